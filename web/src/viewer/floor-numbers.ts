import {
  CanvasTexture,
  Color,
  LinearMipmapLinearFilter,
  Mesh,
  ShaderMaterial,
  Vector2,
} from "three";
import { firstIndexWhere } from "../util/binary-search";
import { createQuads, floorMaterialOptions, groundHeight, groundUniform } from "./quads";

const vertexShader = /* glsl */ `
  ${groundHeight}
  uniform float uTime;
  uniform float uCurrent;
  uniform vec2 uRight;
  uniform vec2 uCenter;
  uniform float uFadeRadius;
  uniform float uAspect;
  attribute vec4 aPlacement;
  attribute vec2 aPlant;
  attribute vec2 aVisible;
  attribute float aLevel;
  varying vec2 vCell;
  varying float vNumber;
  varying float vDigits;
  varying float vAlpha;
  void main() {
    vNumber = aPlacement.w;
    vDigits = 1.0 + step(10.0, vNumber) + step(100.0, vNumber) + step(1000.0, vNumber) + step(10000.0, vNumber);
    vCell = vec2((position.x * 0.5 + 0.5) * vDigits, position.y * 0.5 + 0.5);
    vec2 up = vec2(uRight.y, -uRight.x);
    vec2 ground = aPlacement.xy + aPlacement.z * (uRight * position.x * 0.31 * vDigits + up * position.y * 0.5 * uAspect);
    float age = max(0.0, uTime - aPlant.y) / 3.2 + max(0.0, aPlant.x - uTime) / 1.6;
    // Only the numbers next to the current one.
    float nearby = 1.0 - smoothstep(4.5, 6.5, abs(vNumber - uCurrent));
    float visibility = smoothstep(-0.1, 0.1, uTime - aVisible.x) * smoothstep(-0.1, 0.1, aVisible.y - uTime);
    vAlpha = 0.9 * nearby * visibility * exp(-age) * (1.0 - smoothstep(0.25, 0.8, length(aPlacement.xy - uCenter) / uFadeRadius));
    gl_Position = projectionMatrix * viewMatrix * vec4(ground.x, groundHeight(ground) + aLevel, ground.y, 1.0);
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
    // Derivatives of the continuous cell: the jump between digits would select a coarse mip level.
    vec2 at = vec2((digit + fract(vCell.x)) / 10.0, vCell.y);
    float coverage = textureGrad(uDigits, at, dFdx(vCell) * vec2(0.1, 1.0), dFdy(vCell) * vec2(0.1, 1.0)).a;
    if (coverage * vAlpha < 0.01) discard;
    gl_FragColor = vec4(uColor, coverage * vAlpha);
    #include <colorspace_fragment>
  }
`;

/** Returns a texture of the digits 0 to 9 in ten equal cells. */
function digitsTexture(): CanvasTexture {
  const canvas = document.createElement("canvas");
  canvas.width = 640;
  canvas.height = 100;
  const ctx = canvas.getContext("2d");
  if (ctx) {
    ctx.font = `600 88px "Inter Variable", system-ui, sans-serif`;
    ctx.textAlign = "center";
    ctx.textBaseline = "middle";
    for (let digit = 0; digit < 10; digit++) ctx.fillText(String(digit), 64 * digit + 32, 54);
  }
  const texture = new CanvasTexture(canvas);
  texture.minFilter = LinearMipmapLinearFilter;
  texture.anisotropy = 4;
  return texture;
}

const uniforms = {
  uGround: groundUniform,
  uTime: { value: 0 },
  uCurrent: { value: 0 },
  uRight: { value: new Vector2(1, 0) },
  uCenter: { value: new Vector2() },
  uFadeRadius: { value: 1 },
  uAspect: { value: 1 },
  uDigits: { value: null as CanvasTexture | null },
  uColor: { value: new Color() },
};

// Shared by all instances, so that the shader stays compiled while there are none.
const material = new ShaderMaterial({
  ...floorMaterialOptions,
  vertexShader,
  fragmentShader,
  uniforms,
});

/** The number of a plant on the floor. */
export interface FloorNumber {
  x: number;
  z: number;
  /** Height of its level above the plane of the ground, in metres. */
  level: number;
  /** Height of the digits, metres. */
  height: number;
  number: number;
  /** Start and end of the plant in seconds, between which the number is fully opaque. */
  from: number;
  to: number;
}

/** Plant numbers on the floor, oriented towards the camera. */
export class FloorNumbers {
  readonly mesh: Mesh;

  /** `visibility` holds the start and end of the visible time of each number, in seconds. */
  constructor(
    private readonly numbers: readonly FloorNumber[],
    visibility: Float32Array,
    color: Color,
    fadeRadius: number,
  ) {
    const placements = new Float32Array(4 * numbers.length);
    const plantTimes = new Float32Array(2 * numbers.length);
    numbers.forEach(({ x, z, height, number, from, to }, i) => {
      placements.set([x, z, height, number], 4 * i);
      plantTimes.set([from, to], 2 * i);
    });
    // Created once and shared by all instances.
    uniforms.uDigits.value ??= digitsTexture();
    uniforms.uFadeRadius.value = fadeRadius;
    uniforms.uColor.value = color;
    this.mesh = new Mesh(
      createQuads(numbers.length, {
        aPlacement: [4, placements],
        aPlant: [2, plantTimes],
        aVisible: [2, visibility],
        aLevel: [1, Float32Array.from(numbers, ({ level }) => level)],
      }),
      material,
    );
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = -5;
  }

  /** `azimuth` and `polar` are angles of the camera; `x` and `z` the position of the character. */
  update(seconds: number, azimuth: number, polar: number, x: number, z: number) {
    uniforms.uRight.value.set(Math.cos(azimuth), -Math.sin(azimuth));
    uniforms.uCenter.value.set(x, z);
    uniforms.uTime.value = seconds;
    uniforms.uCurrent.value = this.currentNumber(seconds);
    // Taller at low camera angles, like road markings.
    uniforms.uAspect.value = Math.min(2.6, 1 / Math.max(Math.cos(polar), 0.1));
  }

  /** Returns the plant number at a time, interpolated between plants. */
  private currentNumber(seconds: number): number {
    const { numbers } = this;
    const index = firstIndexWhere(
      numbers.length,
      (i) => (numbers[i] as FloorNumber).from > seconds,
    );
    const previous = numbers[index - 1];
    const following = numbers[index];
    if (!previous) return following?.number ?? 0;
    if (!following) return previous.number;
    const fraction = (seconds - previous.from) / (following.from - previous.from);
    return previous.number + fraction * (following.number - previous.number);
  }

  dispose() {
    this.mesh.geometry.dispose();
  }
}
