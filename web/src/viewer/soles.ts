import { Mesh, ShaderMaterial } from "three";
import type { Footprint } from "../model/motion/footprints";
import type { Plant } from "../model/plants/plants";
import type { Palette } from "./palette";
import { createQuads, floorMaterialOptions, groundHeight, groundUniform } from "./quads";

const vertexShader = /* glsl */ `
  ${groundHeight}
  uniform float uTime;
  attribute vec4 aPlacement;
  attribute vec2 aShape;
  attribute vec2 aPlant;
  attribute vec2 aVisible;
  attribute float aLevel;
  attribute vec3 aColor;
  varying vec2 vLocal;
  varying vec3 vColor;
  varying float vFill;
  varying float vLine;
  void main() {
    vec2 forward = aPlacement.zw;
    vec2 right = vec2(-forward.y, forward.x);
    vec2 local = position.xy * vec2(0.3, 0.56);
    vec2 ground = aPlacement.xy + (right * local.x + forward * local.y) * aShape.x;
    vLocal = vec2(local.x * aShape.y, local.y);
    float past = max(0.0, uTime - aPlant.y);
    float future = max(0.0, aPlant.x - uTime);
    float current = step(aPlant.x, uTime + 1e-4) * step(uTime + 1e-4, aPlant.y);
    float recency = exp(-(past / 3.2 + future / 1.6));
    float visibility = smoothstep(-0.1, 0.1, uTime - aVisible.x) * smoothstep(-0.1, 0.1, aVisible.y - uTime);
    visibility = max(visibility, current);
    vFill = visibility * mix(0.34 * recency * step(future, 0.0), 0.6, current);
    vLine = visibility * mix(0.14 + 0.7 * recency * (future > 0.0 ? 0.55 : 1.0), 1.0, current);
    vColor = aColor;
    gl_Position = projectionMatrix * viewMatrix * vec4(ground.x, groundHeight(ground) + aLevel, ground.y, 1.0);
  }
`;

// Signed distance field of a sole of length 1, toes towards +y, big toe towards -x.
const fragmentShader = /* glsl */ `
  varying vec2 vLocal;
  varying vec3 vColor;
  varying float vFill;
  varying float vLine;
  float smoothUnion(float a, float b, float k) {
    float h = clamp(0.5 + 0.5 * (b - a) / k, 0.0, 1.0);
    return mix(b, a, h) - k * h * (1.0 - h);
  }
  float capsule(vec2 p, vec2 a, vec2 b, float r) {
    vec2 d = b - a;
    return length(p - a - d * clamp(dot(p - a, d) / dot(d, d), 0.0, 1.0)) - r;
  }
  float circle(vec2 p, float x, float y, float r) { return length(p - vec2(x, y)) - r; }
  void main() {
    vec2 p = vLocal;
    float sole = circle(p, 0.0, -0.36, 0.125);
    sole = smoothUnion(sole, capsule(p, vec2(0.055, -0.26), vec2(0.07, 0.02), 0.075), 0.1);
    sole = smoothUnion(sole, capsule(p, vec2(-0.055, 0.14), vec2(0.07, 0.085), 0.115), 0.1);
    float toes = circle(p, -0.105, 0.37, 0.07);
    toes = min(toes, circle(p, 0.0, 0.392, 0.046));
    toes = min(toes, circle(p, 0.078, 0.36, 0.041));
    toes = min(toes, circle(p, 0.142, 0.312, 0.037));
    toes = min(toes, circle(p, 0.19, 0.25, 0.033));
    float d = min(sole, toes);
    float px = 0.75 * fwidth(d);
    float fill = 1.0 - smoothstep(-px, px, d);
    float line = 1.0 - smoothstep(0.6 * px, 1.6 * px, abs(d));
    float alpha = max(fill * vFill, line * vLine);
    if (alpha < 0.004) discard;
    gl_FragColor = vec4(vColor, alpha);
    #include <colorspace_fragment>
  }
`;

const uniforms = { uTime: { value: 0 }, uGround: groundUniform };

// Shared by all instances, so that the shader stays compiled while there are none.
const material = new ShaderMaterial({
  ...floorMaterialOptions,
  vertexShader,
  fragmentShader,
  uniforms,
});

/** The footprints of plants. The shader fades them by time, so that playing updates no attributes. */
export class Soles {
  readonly mesh: Mesh;

  /**
   * `level` is the height above the plane of the ground, in metres; `visibility` holds the start and end
   * of the visible time of each footprint, in seconds.
   */
  constructor(
    plants: readonly Plant[],
    footprints: readonly (Footprint & { level: number })[],
    visibility: Float32Array,
    rate: number,
    palette: Palette,
  ) {
    const count = plants.length;
    const placement = new Float32Array(4 * count);
    const shape = new Float32Array(2 * count);
    const plantTimes = new Float32Array(2 * count);
    const color = new Float32Array(3 * count);
    const levels = Float32Array.from(footprints, ({ level }) => level);
    plants.forEach((plant, i) => {
      const footprint = footprints[i];
      if (!footprint) return;
      placement.set([footprint.x, footprint.z, footprint.dx, footprint.dz], 4 * i);
      shape.set([footprint.length, plant.side === "left" ? -1 : 1], 2 * i);
      plantTimes.set([plant.start / rate, plant.end / rate], 2 * i);
      (plant.side === "left" ? palette.left : palette.right).toArray(color, 3 * i);
    });
    const geometry = createQuads(count, {
      aPlacement: [4, placement],
      aShape: [2, shape],
      aPlant: [2, plantTimes],
      aVisible: [2, visibility],
      aColor: [3, color],
      aLevel: [1, levels],
    });
    this.mesh = new Mesh(geometry, material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = -6;
  }

  update(seconds: number) {
    uniforms.uTime.value = seconds;
  }

  dispose() {
    this.mesh.geometry.dispose();
  }
}
