import {
  DoubleSide,
  InstancedBufferAttribute,
  InstancedBufferGeometry,
  PlaneGeometry,
  Vector3,
} from "three";

/** Creates instanced quads; attributes are given as [item size, values] with one item per quad. */
export function createQuads(
  count: number,
  attributes: Record<string, readonly [number, Float32Array]>,
) {
  const plane = new PlaneGeometry(2, 2);
  const geometry = new InstancedBufferGeometry();
  geometry.index = plane.index;
  geometry.setAttribute("position", plane.getAttribute("position"));
  for (const [name, [size, values]] of Object.entries(attributes)) {
    geometry.setAttribute(name, new InstancedBufferAttribute(values, size));
  }
  geometry.instanceCount = count;
  return geometry;
}

/** Uniform of the plane of the ground, shared by everything on it: slopes along x and z, and offset. */
export const groundUniform = { value: new Vector3() };

/** Shader function of the height of the ground at a position (x, z). */
export const groundHeight = /* glsl */ `
  uniform vec3 uGround;
  float groundHeight(vec2 point) { return dot(uGround, vec3(point, 1.0)); }
`;

/** Material parameters of everything on the floor: drawn in `renderOrder`, under the skeleton. */
export const floorMaterialOptions = {
  transparent: true,
  depthTest: false,
  depthWrite: false,
  side: DoubleSide,
} as const;
