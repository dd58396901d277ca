import { Mesh, PlaneGeometry, ShaderMaterial, Vector2 } from "three";
import { gridStep } from "../model/trajectory";
import type { Palette } from "./palette";

const vertexShader = /* glsl */ `
  uniform vec2 uCenter;
  varying vec2 vPlace;
  void main() {
    vPlace = position.xz + uCenter;
    gl_Position = projectionMatrix * viewMatrix * vec4(vPlace.x, 0.0, vPlace.y, 1.0);
  }
`;

// Lines stay one pixel and a half wide near and far; far away they fade before they alias.
const fragmentShader = /* glsl */ `
  uniform vec2 uCenter;
  uniform float uStep;
  uniform float uReach;
  uniform vec3 uGround;
  uniform vec3 uFloor;
  uniform vec3 uLine;
  varying vec2 vPlace;
  void main() {
    vec2 cell = vPlace / uStep;
    vec2 width = fwidth(cell);
    vec2 away = abs(fract(cell - 0.5) - 0.5) / width;
    vec2 line = (1.0 - smoothstep(0.1, 1.1, away)) * (1.0 - smoothstep(0.15, 0.5, width));
    float distance = length(vPlace - uCenter) / uReach;
    float fade = 1.0 - smoothstep(0.12, 1.0, distance);
    float glow = 1.0 - smoothstep(0.0, 0.8, distance);
    vec3 color = mix(uGround, uFloor, glow);
    color = mix(color, uLine, max(line.x, line.y) * fade);
    gl_FragColor = vec4(color, 1.0);
    #include <colorspace_fragment>
  }
`;

/** The ground: a grid of metres that fades around the character into the page's own colour. */
export class Floor {
  readonly mesh: Mesh;
  private readonly material: ShaderMaterial;
  private readonly center = new Vector2();

  constructor(palette: Palette, size: number) {
    this.material = new ShaderMaterial({
      vertexShader,
      fragmentShader,
      depthTest: false,
      depthWrite: false,
      uniforms: {
        uCenter: { value: this.center },
        uStep: { value: gridStep(size) },
        uReach: { value: size * 5.5 },
        uGround: { value: palette.ground },
        uFloor: { value: palette.floor },
        uLine: { value: palette.line },
      },
    });
    const plane = new PlaneGeometry(size * 14, size * 14).rotateX(-Math.PI / 2);
    this.mesh = new Mesh(plane, this.material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = -10;
  }

  moveTo(x: number, z: number) {
    this.center.set(x, z);
  }

  dispose() {
    this.mesh.geometry.dispose();
    this.material.dispose();
  }
}
