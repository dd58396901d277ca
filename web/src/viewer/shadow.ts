import { DynamicDrawUsage, type InstancedBufferAttribute, Mesh, ShaderMaterial } from "three";
import type { Bones } from "./bones";
import { createQuads, floorMaterialOptions, groundHeight, groundUniform } from "./quads";

const vertexShader = /* glsl */ `
  ${groundHeight}
  uniform float uSize;
  attribute vec3 aFrom;
  attribute vec3 aTo;
  attribute float aWidth;
  varying vec2 vPosition;
  varying vec2 vFrom;
  varying vec2 vTo;
  varying float vRadius;
  varying float vStrength;
  void main() {
    float height = max(0.0, 0.5 * (aFrom.y + aTo.y)) / uSize;
    vRadius = aWidth * 1.5 + uSize * (0.02 + 0.16 * height);
    vStrength = 0.62 * aWidth / (aWidth + 0.35 * uSize * height * height + 0.012 * uSize) * exp(-1.6 * height);
    vFrom = aFrom.xz;
    vTo = aTo.xz;
    vec2 along = vTo - vFrom;
    float half_ = 0.5 * length(along);
    along = half_ > 1e-5 ? normalize(along) : vec2(1.0, 0.0);
    vec2 across = vec2(-along.y, along.x);
    vPosition = 0.5 * (vFrom + vTo) + along * position.x * (half_ + vRadius) + across * position.y * vRadius;
    gl_Position = projectionMatrix * viewMatrix * vec4(vPosition.x, groundHeight(vPosition), vPosition.y, 1.0);
  }
`;

const fragmentShader = /* glsl */ `
  uniform float uStrength;
  varying vec2 vPosition;
  varying vec2 vFrom;
  varying vec2 vTo;
  varying float vRadius;
  varying float vStrength;
  void main() {
    vec2 bone = vTo - vFrom;
    float t = clamp(dot(vPosition - vFrom, bone) / max(dot(bone, bone), 1e-8), 0.0, 1.0);
    float boneDistance = length(vPosition - vFrom - bone * t) / vRadius;
    float falloff = max(0.0, 1.0 - boneDistance * boneDistance);
    gl_FragColor = vec4(0.0, 0.0, 0.0, uStrength * vStrength * falloff * falloff);
  }
`;

/** Soft shadows of the bones; sharper and darker for bones near the floor. */
export class Shadow {
  readonly mesh: Mesh;
  private readonly material: ShaderMaterial;
  private readonly from: InstancedBufferAttribute;
  private readonly to: InstancedBufferAttribute;

  constructor(bones: Bones, size: number, strength: number) {
    const count = bones.child.length;
    const geometry = createQuads(count, {
      aFrom: [3, new Float32Array(3 * count)],
      aTo: [3, new Float32Array(3 * count)],
      aWidth: [1, bones.width],
    });
    this.from = geometry.getAttribute("aFrom") as InstancedBufferAttribute;
    this.to = geometry.getAttribute("aTo") as InstancedBufferAttribute;
    this.from.setUsage(DynamicDrawUsage);
    this.to.setUsage(DynamicDrawUsage);
    this.material = new ShaderMaterial({
      ...floorMaterialOptions,
      vertexShader,
      fragmentShader,
      uniforms: { uGround: groundUniform, uSize: { value: size }, uStrength: { value: strength } },
    });
    this.mesh = new Mesh(geometry, this.material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = -8;
  }

  update(bones: Bones) {
    const from = this.from.array;
    const to = this.to.array;
    for (let k = 0; k < bones.child.length; k++) {
      const parent = 3 * (bones.parent[k] as number);
      const child = 3 * (bones.child[k] as number);
      for (let axis = 0; axis < 3; axis++) {
        from[3 * k + axis] = bones.pose[parent + axis] as number;
        to[3 * k + axis] = bones.pose[child + axis] as number;
      }
    }
    this.from.needsUpdate = true;
    this.to.needsUpdate = true;
  }

  dispose() {
    this.mesh.geometry.dispose();
    this.material.dispose();
  }
}
