import {
  BufferGeometry,
  Group,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  PlaneGeometry,
  ShaderMaterial,
  Vector2,
  Vector3,
} from "three";
import { gridStep } from "../model/motion/trajectory";
import type { Palette } from "./palette";
import { groundHeight, groundUniform } from "./quads";

const vertexShader = /* glsl */ `
  ${groundHeight}
  uniform vec2 uCenter;
  varying vec2 vPosition;
  void main() {
    vPosition = position.xz + uCenter;
    gl_Position = projectionMatrix * viewMatrix * vec4(vPosition.x, groundHeight(vPosition), vPosition.y, 1.0);
  }
`;

// Lines are 1.5 pixels wide at any distance and fade out before they alias.
const fragmentShader = /* glsl */ `
  uniform vec2 uCenter;
  uniform float uStep;
  uniform float uFadeRadius;
  uniform vec3 uBackground;
  uniform vec3 uFloor;
  uniform vec3 uGrid;
  varying vec2 vPosition;
  void main() {
    vec2 cell = vPosition / uStep;
    vec2 width = fwidth(cell);
    vec2 lineDistance = abs(fract(cell - 0.5) - 0.5) / width;
    vec2 line = (1.0 - smoothstep(0.1, 1.1, lineDistance)) * (1.0 - smoothstep(0.15, 0.5, width));
    float distance = length(vPosition - uCenter) / uFadeRadius;
    float fade = 1.0 - smoothstep(0.12, 1.0, distance);
    float glow = 1.0 - smoothstep(0.0, 0.8, distance);
    vec3 color = mix(uBackground, uFloor, glow);
    color = mix(color, uGrid, max(line.x, line.y) * fade);
    gl_FragColor = vec4(color, 1.0);
    #include <colorspace_fragment>
  }
`;

/** The floor: a grid around the character that fades into the background. */
export class Floor {
  readonly group = new Group();
  /** The ground as a line, for views from the front and the side, in which the floor is edge-on. */
  private readonly line: LineSegments;
  private readonly mesh: Mesh;
  private readonly material: ShaderMaterial;
  private readonly center = new Vector2();

  constructor(palette: Palette, size: number) {
    this.material = new ShaderMaterial({
      vertexShader,
      fragmentShader,
      depthTest: false,
      depthWrite: false,
      uniforms: {
        uGround: groundUniform,
        uCenter: { value: this.center },
        uStep: { value: gridStep(size) },
        uFadeRadius: { value: size * 5.5 },
        uBackground: { value: palette.background },
        uFloor: { value: palette.floor },
        uGrid: { value: palette.grid },
      },
    });
    const plane = new PlaneGeometry(size * 14, size * 14).rotateX(-Math.PI / 2);
    this.mesh = new Mesh(plane, this.material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = -10;
    const reach = size * 7;
    const ends = [
      new Vector3(-reach, 0, 0),
      new Vector3(reach, 0, 0),
      new Vector3(0, 0, -reach),
      new Vector3(0, 0, reach),
    ];
    this.line = new LineSegments(
      new BufferGeometry().setFromPoints(ends),
      new LineBasicMaterial({ color: palette.muted, depthTest: false }),
    );
    this.line.frustumCulled = false;
    this.line.renderOrder = -9;
    this.group.add(this.mesh, this.line);
  }

  /** Draws the ground as a line, or not. */
  setEdgeOn(isEdgeOn: boolean) {
    this.line.visible = isEdgeOn;
  }

  moveTo(x: number, z: number) {
    this.center.set(x, z);
    this.line.position.set(x, 0, z);
  }

  dispose() {
    this.mesh.geometry.dispose();
    this.material.dispose();
    this.line.geometry.dispose();
    (this.line.material as LineBasicMaterial).dispose();
  }
}
