import {
  BufferGeometry,
  type Color,
  Float32BufferAttribute,
  Group,
  InstancedBufferAttribute,
  InstancedMesh,
  MeshStandardMaterial,
  type MeshStandardMaterialParameters,
  Quaternion,
  Sphere,
  SphereGeometry,
  Vector3,
} from "three";
import { footLightOfJoints } from "../model/feet";
import type { Clip } from "../model/types";
import type { Palette } from "./palette";

/** A bone from the origin along +y: four faces that swell near its root and taper to its tip. */
function boneGeometry(): BufferGeometry {
  const rings: readonly (readonly [y: number, radius: number])[] = [
    [0.0, 0.3],
    [0.16, 1.0],
    [1.0, 0.3],
  ];
  const points: number[] = [];
  const at = (ring: number, side: number) => {
    const [y, radius] = rings[ring] ?? [0, 0];
    const angle = ((side + 0.5) * Math.PI) / 2;
    return [Math.cos(angle) * radius, y, -Math.sin(angle) * radius];
  };
  for (let ring = 0; ring + 1 < rings.length; ring++) {
    for (let side = 0; side < 4; side++) {
      const [a, b, c, d] = [
        at(ring, side),
        at(ring, side + 1),
        at(ring + 1, side),
        at(ring + 1, side + 1),
      ];
      points.push(...a, ...b, ...d, ...a, ...d, ...c);
    }
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new Float32BufferAttribute(points, 3));
  geometry.computeVertexNormals();
  return geometry;
}

/** Lets each instance shine in its own colour by its `aGlow`, 0 … 1. */
function glowing(material: MeshStandardMaterial): MeshStandardMaterial {
  material.onBeforeCompile = (shader) => {
    shader.vertexShader = shader.vertexShader
      .replace(
        "#include <common>",
        "attribute float aGlow;\nvarying float vGlow;\n#include <common>",
      )
      .replace("#include <begin_vertex>", "#include <begin_vertex>\nvGlow = aGlow;");
    shader.fragmentShader = shader.fragmentShader
      .replace("#include <common>", "varying float vGlow;\n#include <common>")
      .replace(
        "#include <emissivemap_fragment>",
        "#include <emissivemap_fragment>\ntotalEmissiveRadiance += 0.6 * vGlow * diffuseColor.rgb;",
      );
  };
  return material;
}

/** What bones and joints are made of: one for all skeletons, so that its shader stays compiled. */
function skin(more: MeshStandardMaterialParameters) {
  const kind = { roughness: 0.62, metalness: 0.05, ...more };
  return {
    bones: glowing(new MeshStandardMaterial({ ...kind, flatShading: true })),
    joints: glowing(new MeshStandardMaterial(kind)),
  };
}

const solid = skin({});
const ghostly = skin({ transparent: true, opacity: 0.28, depthWrite: false });

/** The skeleton as solid bones, two instanced meshes whose matrices change in place. */
export class Bones {
  readonly group = new Group();
  /** Joint positions of the pose on show, floor at 0. */
  readonly pose: Float32Array;
  /** Joints that end a drawn bone, and the parents they hang from. */
  readonly child: Uint16Array;
  readonly parent: Uint16Array;
  readonly width: Float32Array;
  private readonly lit: Uint8Array;
  private readonly base: Float32Array;
  private readonly radius: Float32Array;
  private readonly bones: InstancedMesh;
  private readonly joints: InstancedMesh;
  private readonly palette: Palette;
  private readonly turn = new Quaternion();
  private readonly rest = new Vector3();
  private readonly along = new Vector3();

  /** A ghost is seen through. */
  constructor(clip: Clip, size: number, palette: Palette, isGhost = false) {
    this.palette = palette;
    this.pose = new Float32Array(clip.joints.length * 3);
    this.lit = footLightOfJoints(clip);
    const drawn = drawnBones(clip, size);
    this.child = Uint16Array.from(drawn);
    this.parent = Uint16Array.from(drawn, (joint) => clip.joints[joint]?.parent ?? 0);
    this.base = new Float32Array(drawn.length * 3);
    this.width = new Float32Array(drawn.length);
    this.radius = new Float32Array(clip.joints.length);
    drawn.forEach((joint, k) => {
      const parent = clip.joints[joint]?.parent ?? 0;
      const at = (axis: number) =>
        (clip.positions[joint * 3 + axis] ?? 0) - (clip.positions[parent * 3 + axis] ?? 0);
      const length = Math.hypot(at(0), at(1), at(2));
      for (let axis = 0; axis < 3; axis++) this.base[3 * k + axis] = at(axis) / length;
      // Thickness grows with length, so that fingers stay threads beside a thigh.
      // A foot is stouter, for its light to be seen.
      const width = Math.min((this.lit[joint] ? 0.2 : 0.12) * length, 0.026 * size);
      this.width[k] = width;
      this.radius[parent] = Math.max(this.radius[parent] ?? 0, 0.62 * width);
      this.radius[joint] = Math.max(this.radius[joint] ?? 0, 0.46 * width);
    });
    const skin = isGhost ? ghostly : solid;
    this.bones = new InstancedMesh(boneGeometry(), skin.bones, drawn.length);
    this.joints = new InstancedMesh(new SphereGeometry(1, 20, 14), skin.joints, clip.joints.length);
    for (const mesh of [this.bones, this.joints]) {
      mesh.frustumCulled = false;
      // For the order in which things are drawn any will do; three.js would go through all of them.
      mesh.boundingSphere = new Sphere();
      mesh.geometry.setAttribute(
        "aGlow",
        new InstancedBufferAttribute(new Float32Array(mesh.count), 1),
      );
      this.group.add(mesh);
    }
    drawn.forEach((_, k) => void this.bones.setColorAt(k, palette.bone));
    clip.joints.forEach((_, j) => void this.joints.setColorAt(j, palette.joint));
  }

  /** Puts the bones where a moment between two frames has them, or aside of there. */
  show(clip: Clip, moment: number, floor: number, aside = { x: 0, z: 0 }) {
    const { pose } = this;
    const last = Math.max(clip.frames - 1, 0);
    const frame = Math.min(Math.floor(moment), last);
    const share = moment - frame;
    const from = frame * pose.length;
    const to = Math.min(frame + 1, last) * pose.length;
    const source = clip.positions;
    for (let i = 0; i < pose.length; i++) {
      const a = source[from + i] as number;
      pose[i] = a + ((source[to + i] as number) - a) * share;
    }
    for (let i = 0; i < pose.length; i += 3) {
      pose[i] = (pose[i] as number) + aside.x;
      pose[i + 1] = (pose[i + 1] as number) - floor;
      pose[i + 2] = (pose[i + 2] as number) + aside.z;
    }
    this.placeBones();
    this.placeJoints();
  }

  /** Lights the feet; `shares` holds 0 … 1 per entry of `lights`. */
  light(shares: Float32Array) {
    this.tint(this.bones, this.child, this.palette.bone, shares);
    this.tint(this.joints, null, this.palette.joint, shares);
  }

  private tint(mesh: InstancedMesh, which: Uint16Array | null, plain: Color, shares: Float32Array) {
    if (!mesh.instanceColor) return;
    const colors = mesh.instanceColor.array;
    const glow = mesh.geometry.getAttribute("aGlow");
    for (let k = 0; k < mesh.count; k++) {
      const light = this.lit[which ? (which[k] as number) : k] as number;
      if (!light) continue;
      const share = shares[light] as number;
      glow.array[k] = share;
      const side = light <= 2 ? this.palette.left : this.palette.right;
      colors[3 * k] = plain.r + (side.r - plain.r) * share;
      colors[3 * k + 1] = plain.g + (side.g - plain.g) * share;
      colors[3 * k + 2] = plain.b + (side.b - plain.b) * share;
    }
    mesh.instanceColor.needsUpdate = true;
    glow.needsUpdate = true;
  }

  private placeBones() {
    const m = this.bones.instanceMatrix.array;
    const { pose, base, turn, rest, along } = this;
    for (let k = 0; k < this.child.length; k++) {
      const c = 3 * (this.child[k] as number);
      const p = 3 * (this.parent[k] as number);
      const px = pose[p] as number;
      const py = pose[p + 1] as number;
      const pz = pose[p + 2] as number;
      along.set(
        (pose[c] as number) - px,
        (pose[c + 1] as number) - py,
        (pose[c + 2] as number) - pz,
      );
      const length = along.length();
      const w = this.width[k] as number;
      // Turned from the first frame's direction, a bone never rolls by itself.
      rest.set(base[3 * k] as number, base[3 * k + 1] as number, base[3 * k + 2] as number);
      if (length > 0) along.divideScalar(length);
      turn.setFromUnitVectors(rest, along);
      // Any two axes across the rest direction will do, as long as they stay the same.
      sideways.set(0, 0, 1);
      if (Math.abs(rest.z) > 0.9) sideways.set(1, 0, 0);
      sideways.cross(rest).normalize();
      across.crossVectors(sideways, rest);
      sideways.applyQuaternion(turn);
      across.applyQuaternion(turn);
      const o = 16 * k;
      m[o] = sideways.x * w;
      m[o + 1] = sideways.y * w;
      m[o + 2] = sideways.z * w;
      m[o + 4] = along.x * length;
      m[o + 5] = along.y * length;
      m[o + 6] = along.z * length;
      m[o + 8] = across.x * w;
      m[o + 9] = across.y * w;
      m[o + 10] = across.z * w;
      m[o + 12] = px;
      m[o + 13] = py;
      m[o + 14] = pz;
      m[o + 15] = 1;
    }
    this.bones.instanceMatrix.needsUpdate = true;
  }

  private placeJoints() {
    const m = this.joints.instanceMatrix.array;
    for (let j = 0; j < this.radius.length; j++) {
      const o = 16 * j;
      const r = this.radius[j] as number;
      m[o] = r;
      m[o + 5] = r;
      m[o + 10] = r;
      m[o + 12] = this.pose[3 * j] as number;
      m[o + 13] = this.pose[3 * j + 1] as number;
      m[o + 14] = this.pose[3 * j + 2] as number;
      m[o + 15] = 1;
    }
    this.joints.instanceMatrix.needsUpdate = true;
  }

  dispose() {
    for (const mesh of [this.bones, this.joints]) {
      mesh.geometry.dispose();
      mesh.dispose();
    }
  }
}

const sideways = new Vector3();
const across = new Vector3();

/** Joints worth a bone to their parent: not the empty ones, nor a root's way through the world. */
function drawnBones(clip: Clip, size: number): number[] {
  const stride = clip.joints.length * 3;
  const frames = Math.max(clip.frames, 1);
  const drawn: number[] = [];
  clip.joints.forEach((joint, i) => {
    if (joint.parent === undefined) return;
    let least = Number.POSITIVE_INFINITY;
    let most = 0;
    for (let k = 0; k < 12; k++) {
      const frame = Math.floor((k / 12) * frames) * stride;
      const c = frame + i * 3;
      const p = frame + joint.parent * 3;
      const at = (axis: number) =>
        (clip.positions[c + axis] ?? 0) - (clip.positions[p + axis] ?? 0);
      const length = Math.hypot(at(0), at(1), at(2));
      least = Math.min(least, length);
      most = Math.max(most, length);
    }
    const moves = most - least > 0.15 * size;
    if (least > 1e-4 * size && !moves) drawn.push(i);
  });
  return drawn;
}
