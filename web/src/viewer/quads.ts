import {
  DoubleSide,
  InstancedBufferAttribute,
  InstancedBufferGeometry,
  PlaneGeometry,
} from "three";

/** Many quads in one draw; each attribute is given per quad as [items per quad, values]. */
export function quads(count: number, attributes: Record<string, readonly [number, Float32Array]>) {
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

/** What everything lying on the floor shares: drawn in order, under the skeleton. */
export const flat = {
  transparent: true,
  depthTest: false,
  depthWrite: false,
  side: DoubleSide,
} as const;
