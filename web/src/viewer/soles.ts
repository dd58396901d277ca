import { Mesh, ShaderMaterial } from "three";
import type { Footprint } from "../model/footprints";
import type { Plant } from "../model/plants";
import type { Palette } from "./palette";
import { flat, quads } from "./quads";

const vertexShader = /* glsl */ `
  uniform float uNow;
  attribute vec4 aPlace;
  attribute vec2 aShape;
  attribute vec2 aSpan;
  attribute vec2 aReign;
  attribute vec3 aColor;
  varying vec2 vLocal;
  varying vec3 vColor;
  varying float vFill;
  varying float vLine;
  void main() {
    vec2 ahead = aPlace.zw;
    vec2 right = vec2(-ahead.y, ahead.x);
    vec2 local = position.xy * vec2(0.3, 0.56);
    vec2 place = aPlace.xy + (right * local.x + ahead * local.y) * aShape.x;
    vLocal = vec2(local.x * aShape.y, local.y);
    float past = max(0.0, uNow - aSpan.y);
    float future = max(0.0, aSpan.x - uNow);
    float here = smoothstep(-0.12, 0.0, uNow - aSpan.x) * (1.0 - smoothstep(0.0, 0.25, past));
    float near = exp(-(past / 3.2 + future / 1.6));
    float reign = smoothstep(-0.1, 0.1, uNow - aReign.x) * smoothstep(-0.1, 0.1, aReign.y - uNow);
    reign = max(reign, here);
    vFill = reign * mix(0.34 * near * step(future, 0.0), 0.6, here);
    vLine = reign * mix(0.14 + 0.7 * near * (future > 0.0 ? 0.55 : 1.0), 1.0, here);
    vColor = aColor;
    gl_Position = projectionMatrix * viewMatrix * vec4(place.x, 0.0, place.y, 1.0);
  }
`;

// A sole as a distance field, length 1, toes towards +y, big toe towards -x.
const fragmentShader = /* glsl */ `
  varying vec2 vLocal;
  varying vec3 vColor;
  varying float vFill;
  varying float vLine;
  float join(float a, float b, float k) {
    float h = clamp(0.5 + 0.5 * (b - a) / k, 0.0, 1.0);
    return mix(b, a, h) - k * h * (1.0 - h);
  }
  float rod(vec2 p, vec2 a, vec2 b, float r) {
    vec2 d = b - a;
    return length(p - a - d * clamp(dot(p - a, d) / dot(d, d), 0.0, 1.0)) - r;
  }
  float disc(vec2 p, float x, float y, float r) { return length(p - vec2(x, y)) - r; }
  void main() {
    vec2 p = vLocal;
    float sole = disc(p, 0.0, -0.36, 0.125);
    sole = join(sole, rod(p, vec2(0.055, -0.26), vec2(0.07, 0.02), 0.075), 0.1);
    sole = join(sole, rod(p, vec2(-0.055, 0.14), vec2(0.07, 0.085), 0.115), 0.1);
    float toes = disc(p, -0.105, 0.37, 0.07);
    toes = min(toes, disc(p, 0.0, 0.392, 0.046));
    toes = min(toes, disc(p, 0.078, 0.36, 0.041));
    toes = min(toes, disc(p, 0.142, 0.312, 0.037));
    toes = min(toes, disc(p, 0.19, 0.25, 0.033));
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

const uniforms = { uNow: { value: 0 } };

/** One for all soles there will be, so that its shader stays compiled while none lie. */
const material = new ShaderMaterial({ ...flat, vertexShader, fragmentShader, uniforms });

/** A footprint for every plant. Time is a uniform: fading costs the page nothing. */
export class Soles {
  readonly mesh: Mesh;

  constructor(
    plants: readonly Plant[],
    prints: readonly Footprint[],
    reign: Float32Array,
    rate: number,
    palette: Palette,
  ) {
    const n = plants.length;
    const place = new Float32Array(4 * n);
    const shape = new Float32Array(2 * n);
    const span = new Float32Array(2 * n);
    const color = new Float32Array(3 * n);
    plants.forEach((plant, i) => {
      const print = prints[i];
      if (!print) return;
      place.set([print.x, print.z, print.dx, print.dz], 4 * i);
      shape.set([print.length, plant.side === "left" ? -1 : 1], 2 * i);
      span.set([plant.start / rate, plant.end / rate], 2 * i);
      (plant.side === "left" ? palette.left : palette.right).toArray(color, 3 * i);
    });
    const geometry = quads(n, {
      aPlace: [4, place],
      aShape: [2, shape],
      aSpan: [2, span],
      aReign: [2, reign],
      aColor: [3, color],
    });
    this.mesh = new Mesh(geometry, material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = -6;
  }

  show(seconds: number) {
    uniforms.uNow.value = seconds;
  }

  dispose() {
    this.mesh.geometry.dispose();
  }
}
