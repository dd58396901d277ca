import { DynamicDrawUsage, type InstancedBufferAttribute, Mesh, ShaderMaterial } from "three";
import type { FootWithSole } from "../model/motion/footprints";
import type { Bones } from "./bones";
import type { Palette } from "./palette";
import { createQuads, floorMaterialOptions, groundHeight, groundUniform } from "./quads";

const vertexShader = /* glsl */ `
  ${groundHeight}
  uniform float uSize;
  attribute vec4 aFoot;
  attribute vec2 aState;
  attribute vec3 aColor;
  varying vec2 vPosition;
  varying float vHalfLength;
  varying float vWeight;
  varying vec3 vColor;
  void main() {
    vec2 along = aFoot.zw - aFoot.xy;
    float length_ = length(along);
    along = length_ > 1e-5 ? along / length_ : vec2(0.0, 1.0);
    vec2 across = vec2(-along.y, along.x);
    vHalfLength = 0.5 * length_ / uSize;
    vWeight = aState.x;
    vec2 halfSize = vec2(vHalfLength + 0.16, 0.16) * uSize;
    vec2 local = position.xy * halfSize;
    vPosition = local / uSize;
    vec2 ground = 0.5 * (aFoot.xy + aFoot.zw) + along * local.x + across * local.y;
    vColor = aColor;
    gl_Position = projectionMatrix * viewMatrix * vec4(ground.x, groundHeight(ground) + aState.y, ground.y, 1.0);
  }
`;

const fragmentShader = /* glsl */ `
  varying vec2 vPosition;
  varying float vHalfLength;
  varying float vWeight;
  varying vec3 vColor;
  void main() {
    vec2 p = vec2(max(abs(vPosition.x) - vHalfLength, 0.0), vPosition.y);
    float d = length(p) - mix(0.03, 0.062, vWeight);
    float px = fwidth(d);
    float line = 1.0 - smoothstep(0.7 * px, 1.7 * px, abs(d));
    float glow = 0.42 * exp(-max(d, 0.0) * 42.0) * (d > 0.0 ? 1.0 : 0.6);
    glow *= 1.0 - smoothstep(0.06, 0.098, max(d, 0.0));
    float alpha = vWeight * max(line, glow);
    if (alpha < 0.004) discard;
    gl_FragColor = vec4(vColor, alpha);
    #include <colorspace_fragment>
  }
`;

/**
 * Outlines on the floor around planted feet. They mark contact without relying on colour.
 */
export class ContactRings {
  readonly mesh: Mesh;
  private readonly material: ShaderMaterial;
  private readonly feet: readonly (FootWithSole | undefined)[];
  private readonly segments: InstancedBufferAttribute;
  private readonly states: InstancedBufferAttribute;

  constructor(feet: readonly (FootWithSole | undefined)[], size: number, palette: Palette) {
    this.feet = feet;
    const color = new Float32Array(6);
    palette.left.toArray(color, 0);
    palette.right.toArray(color, 3);
    const geometry = createQuads(2, {
      aFoot: [4, new Float32Array(8)],
      aState: [2, new Float32Array(4)],
      aColor: [3, color],
    });
    this.segments = geometry.getAttribute("aFoot") as InstancedBufferAttribute;
    this.states = geometry.getAttribute("aState") as InstancedBufferAttribute;
    this.segments.setUsage(DynamicDrawUsage);
    this.states.setUsage(DynamicDrawUsage);
    this.material = new ShaderMaterial({
      ...floorMaterialOptions,
      vertexShader,
      fragmentShader,
      uniforms: { uGround: groundUniform, uSize: { value: size } },
    });
    this.mesh = new Mesh(geometry, this.material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = -4;
  }

  /**
   * `left` and `right` are 1 if the foot is planted, else 0; `levelAt` returns the height of the level that is nearest
   * to a height above the floor.
   */
  update(bones: Bones, left: number, right: number, levelAt: (height: number) => number) {
    const { pose } = bones;
    for (let i = 0; i < 2; i++) {
      const entry = this.feet[i];
      this.states.array[2 * i] = entry ? (i === 0 ? left : right) : 0;
      if (!entry) continue;
      const { foot, sole } = entry;
      const x = pose[3 * foot.ankle] as number;
      const z = pose[3 * foot.ankle + 2] as number;
      const dx = (pose[3 * foot.tip] as number) - x;
      const dz = (pose[3 * foot.tip + 2] as number) - z;
      const heights = [foot.ankle, foot.toe, foot.tip].map(
        (joint) => pose[3 * joint + 1] as number,
      );
      this.states.array[2 * i + 1] = levelAt(Math.min(...heights));
      // To the front end of the sole; shorter if the foot points down.
      const extension = 1 + sole.front / Math.max(sole.reach, Math.hypot(dx, dz));
      this.segments.array[4 * i] = x;
      this.segments.array[4 * i + 1] = z;
      this.segments.array[4 * i + 2] = x + dx * extension;
      this.segments.array[4 * i + 3] = z + dz * extension;
    }
    this.segments.needsUpdate = true;
    this.states.needsUpdate = true;
  }

  dispose() {
    this.mesh.geometry.dispose();
    this.material.dispose();
  }
}
