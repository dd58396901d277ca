import {
  CanvasTexture,
  Color,
  LinearMipmapLinearFilter,
  Mesh,
  ShaderMaterial,
  Vector2,
} from "three";
import { firstIndexWhere } from "../util/binary-search";
import { flat, quads } from "./quads";

const vertexShader = /* glsl */ `
  uniform float uNow;
  uniform float uNumber;
  uniform vec2 uRight;
  uniform vec2 uCenter;
  uniform float uReach;
  uniform float uStretch;
  attribute vec4 aPlace;
  attribute vec2 aSpan;
  attribute vec2 aReign;
  varying vec2 vCell;
  varying float vNumber;
  varying float vDigits;
  varying float vAlpha;
  void main() {
    vNumber = aPlace.w;
    vDigits = 1.0 + step(10.0, vNumber) + step(100.0, vNumber) + step(1000.0, vNumber) + step(10000.0, vNumber);
    vCell = vec2((position.x * 0.5 + 0.5) * vDigits, position.y * 0.5 + 0.5);
    vec2 up = vec2(uRight.y, -uRight.x);
    vec2 place = aPlace.xy + aPlace.z * (uRight * position.x * 0.31 * vDigits + up * position.y * 0.5 * uStretch);
    float away = max(0.0, uNow - aSpan.y) / 3.2 + max(0.0, aSpan.x - uNow) / 1.6;
    // Only the last few and the next few: more of them help nobody to count.
    float few = 1.0 - smoothstep(4.5, 6.5, abs(vNumber - uNumber));
    float reign = smoothstep(-0.1, 0.1, uNow - aReign.x) * smoothstep(-0.1, 0.1, aReign.y - uNow);
    vAlpha = 0.9 * few * reign * exp(-away) * (1.0 - smoothstep(0.25, 0.8, length(aPlace.xy - uCenter) / uReach));
    gl_Position = projectionMatrix * viewMatrix * vec4(place.x, 0.0, place.y, 1.0);
  }
`;

const fragmentShader = /* glsl */ `
  uniform sampler2D uDigits;
  uniform vec3 uColor;
  varying vec2 vCell;
  varying float vNumber;
  varying float vDigits;
  varying float vAlpha;
  void main() {
    float cell = floor(vCell.x);
    float digit = mod(floor(vNumber / pow(10.0, vDigits - 1.0 - cell) + 1e-4), 10.0);
    // The jump from digit to digit must not choose a coarse mip: derivatives of the smooth cell.
    vec2 at = vec2((digit + fract(vCell.x)) / 10.0, vCell.y);
    float ink = textureGrad(uDigits, at, dFdx(vCell) * vec2(0.1, 1.0), dFdy(vCell) * vec2(0.1, 1.0)).a;
    if (ink * vAlpha < 0.01) discard;
    gl_FragColor = vec4(uColor, ink * vAlpha);
    #include <colorspace_fragment>
  }
`;

function digitsTexture(): CanvasTexture {
  const canvas = document.createElement("canvas");
  canvas.width = 640;
  canvas.height = 100;
  const pen = canvas.getContext("2d");
  if (pen) {
    pen.font = `600 88px "Inter Variable", system-ui, sans-serif`;
    pen.textAlign = "center";
    pen.textBaseline = "middle";
    for (let digit = 0; digit < 10; digit++) pen.fillText(String(digit), 64 * digit + 32, 54);
  }
  const texture = new CanvasTexture(canvas);
  texture.minFilter = LinearMipmapLinearFilter;
  texture.anisotropy = 4;
  return texture;
}

const uniforms = {
  uNow: { value: 0 },
  uNumber: { value: 0 },
  uRight: { value: new Vector2(1, 0) },
  uCenter: { value: new Vector2() },
  uReach: { value: 1 },
  uStretch: { value: 1 },
  uDigits: { value: null as CanvasTexture | null },
  uColor: { value: new Color() },
};

/** One for all of them, so that its shader stays compiled while none lie. */
const material = new ShaderMaterial({ ...flat, vertexShader, fragmentShader, uniforms });

export interface FloorNumber {
  x: number;
  z: number;
  /** Height of the digits, metres. */
  height: number;
  number: number;
  /** Seconds between which it is in full ink. */
  from: number;
  to: number;
}

/** Numbers lying on the floor, turned towards the camera. */
export class FloorNumbers {
  readonly mesh: Mesh;

  constructor(
    private readonly numerals: readonly FloorNumber[],
    reign: Float32Array,
    color: Color,
    reach: number,
  ) {
    const place = new Float32Array(4 * numerals.length);
    const spans = new Float32Array(2 * numerals.length);
    numerals.forEach(({ x, z, height, number, from, to }, i) => {
      place.set([x, z, height, number], 4 * i);
      spans.set([from, to], 2 * i);
    });
    // Drawn once, for all numbers there will be.
    uniforms.uDigits.value ??= digitsTexture();
    uniforms.uReach.value = reach;
    uniforms.uColor.value = color;
    this.mesh = new Mesh(
      quads(numerals.length, { aPlace: [4, place], aSpan: [2, spans], aReign: [2, reign] }),
      material,
    );
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = -5;
  }

  /** `azimuth` and `polar` are the camera's, `x` and `z` where the character is. */
  show(seconds: number, azimuth: number, polar: number, x: number, z: number) {
    uniforms.uRight.value.set(Math.cos(azimuth), -Math.sin(azimuth));
    uniforms.uCenter.value.set(x, z);
    uniforms.uNow.value = seconds;
    uniforms.uNumber.value = this.numberAt(seconds);
    // Seen at a low angle digits are drawn taller, as on a road.
    uniforms.uStretch.value = Math.min(2.6, 1 / Math.max(Math.cos(polar), 0.1));
  }

  /** The number of the moment: between two plants, between their numbers. */
  private numberAt(seconds: number): number {
    const { numerals } = this;
    const next = firstIndexWhere(
      numerals.length,
      (i) => (numerals[i] as FloorNumber).from > seconds,
    );
    const before = numerals[next - 1];
    const after = numerals[next];
    if (!before) return after?.number ?? 0;
    if (!after) return before.number;
    const share = (seconds - before.from) / (after.from - before.from);
    return before.number + share * (after.number - before.number);
  }

  dispose() {
    this.mesh.geometry.dispose();
  }
}
