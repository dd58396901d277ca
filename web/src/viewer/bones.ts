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
import { footLightOfJoints } from "../model/motion/feet";
import type { Clip } from "../model/types";
import type { Palette } from "./palette";

/** Unit bone along +y with four sides: widest near the root, tapered to the tip. */
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

/** Adds emission in the instance colour to a material, scaled by the attribute `aGlow` (0 … 1). */
function withGlow(material: MeshStandardMaterial): MeshStandardMaterial {
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

function createMaterials(overrides: MeshStandardMaterialParameters) {
  const parameters = { roughness: 0.62, metalness: 0.05, ...overrides };
  return {
    bones: withGlow(new MeshStandardMaterial({ ...parameters, flatShading: true })),
    joints: withGlow(new MeshStandardMaterial(parameters)),
  };
}

// All skeletons share their materials, so that the shaders stay compiled.
const solidMaterials = createMaterials({});
const ghostMaterials = createMaterials({ transparent: true, opacity: 0.45, depthWrite: false });

/** A skeleton of solid bones: two instanced meshes whose matrices are updated in place. */
export class Bones {
  readonly group = new Group();
  /** Joint positions of the shown pose, ground at y = 0, metres. */
  readonly pose: Float32Array;
  /** Child joint of each drawn bone. */
  readonly child: Uint16Array;
  /** Parent joint of each drawn bone. */
  readonly parent: Uint16Array;
  /** Half-width of each drawn bone, metres. */
  readonly width: Float32Array;
  /** Index into `footLights` per joint; 0 for joints outside the feet. */
  private readonly footLight: Uint8Array;
  /** Unit direction of each drawn bone in the first frame. */
  private readonly restDirections: Float32Array;
  private readonly radius: Float32Array;
  private readonly bones: InstancedMesh;
  private readonly joints: InstancedMesh;
  private readonly palette: Palette;
  private readonly rotation = new Quaternion();
  private readonly restDirection = new Vector3();
  private readonly direction = new Vector3();

  /** `isGhost` draws the skeleton translucent, in the colour of differences. */
  constructor(clip: Clip, size: number, palette: Palette, isGhost = false) {
    this.palette = palette;
    this.pose = new Float32Array(clip.joints.length * 3);
    this.footLight = footLightOfJoints(clip);
    const drawn = drawnBones(clip, size);
    this.child = Uint16Array.from(drawn);
    this.parent = Uint16Array.from(drawn, (joint) => clip.joints[joint]?.parent ?? 0);
    this.restDirections = new Float32Array(drawn.length * 3);
    this.width = new Float32Array(drawn.length);
    this.radius = new Float32Array(clip.joints.length);
    drawn.forEach((joint, k) => {
      const parent = clip.joints[joint]?.parent ?? 0;
      const difference = (axis: number) =>
        (clip.positions[joint * 3 + axis] ?? 0) - (clip.positions[parent * 3 + axis] ?? 0);
      const length = Math.hypot(difference(0), difference(1), difference(2));
      for (let axis = 0; axis < 3; axis++) {
        this.restDirections[3 * k + axis] = difference(axis) / length;
      }
      // Width is proportional to length, so fingers are thin; feet are wider to show their highlight.
      const width = Math.min((this.footLight[joint] ? 0.2 : 0.12) * length, 0.026 * size);
      this.width[k] = width;
      this.radius[parent] = Math.max(this.radius[parent] ?? 0, 0.62 * width);
      this.radius[joint] = Math.max(this.radius[joint] ?? 0, 0.46 * width);
    });
    const materials = isGhost ? ghostMaterials : solidMaterials;
    this.bones = new InstancedMesh(boneGeometry(), materials.bones, drawn.length);
    this.joints = new InstancedMesh(
      new SphereGeometry(1, 20, 14),
      materials.joints,
      clip.joints.length,
    );
    for (const mesh of [this.bones, this.joints]) {
      mesh.frustumCulled = false;
      // Only used for sorting. Without it, three.js would compute it from all instances.
      mesh.boundingSphere = new Sphere();
      mesh.geometry.setAttribute(
        "aGlow",
        new InstancedBufferAttribute(new Float32Array(mesh.count), 1),
      );
      this.group.add(mesh);
    }
    const [boneColor, jointColor] = isGhost
      ? [palette.difference, palette.difference]
      : [palette.bone, palette.joint];
    drawn.forEach((_, k) => void this.bones.setColorAt(k, boneColor));
    clip.joints.forEach((_, j) => void this.joints.setColorAt(j, jointColor));
  }

  /** Shows a pose, interpolated linearly if `frame` is fractional, translated by `offset`. */
  setPose(clip: Clip, frame: number, groundHeight: number, offset = { x: 0, z: 0 }) {
    const { pose } = this;
    const last = Math.max(clip.frames - 1, 0);
    const previous = Math.min(Math.floor(frame), last);
    const fraction = frame - previous;
    const from = previous * pose.length;
    const to = Math.min(previous + 1, last) * pose.length;
    const source = clip.positions;
    for (let i = 0; i < pose.length; i++) {
      const a = source[from + i] as number;
      pose[i] = a + ((source[to + i] as number) - a) * fraction;
    }
    for (let i = 0; i < pose.length; i += 3) {
      pose[i] = (pose[i] as number) + offset.x;
      pose[i + 1] = (pose[i + 1] as number) - groundHeight;
      pose[i + 2] = (pose[i + 2] as number) + offset.z;
    }
    this.updateBones();
    this.updateJoints();
  }

  /** Sets the brightness of the feet: 0 … 1 for each entry of `footLights`. */
  setFootLights(weights: Float32Array) {
    this.tint(this.bones, this.child, this.palette.bone, weights);
    this.tint(this.joints, null, this.palette.joint, weights);
  }

  /** Colours the instances of a mesh; `joints` maps instances to joints, null for the identity. */
  private tint(
    mesh: InstancedMesh,
    joints: Uint16Array | null,
    baseColor: Color,
    weights: Float32Array,
  ) {
    if (!mesh.instanceColor) return;
    const colors = mesh.instanceColor.array;
    const glow = mesh.geometry.getAttribute("aGlow");
    for (let k = 0; k < mesh.count; k++) {
      const light = this.footLight[joints ? (joints[k] as number) : k] as number;
      if (!light) continue;
      const weight = weights[light] as number;
      glow.array[k] = weight;
      const side = light <= 2 ? this.palette.left : this.palette.right;
      colors[3 * k] = baseColor.r + (side.r - baseColor.r) * weight;
      colors[3 * k + 1] = baseColor.g + (side.g - baseColor.g) * weight;
      colors[3 * k + 2] = baseColor.b + (side.b - baseColor.b) * weight;
    }
    mesh.instanceColor.needsUpdate = true;
    glow.needsUpdate = true;
  }

  private updateBones() {
    const matrices = this.bones.instanceMatrix.array;
    const { pose, restDirections, rotation, restDirection, direction } = this;
    for (let k = 0; k < this.child.length; k++) {
      const c = 3 * (this.child[k] as number);
      const p = 3 * (this.parent[k] as number);
      const px = pose[p] as number;
      const py = pose[p + 1] as number;
      const pz = pose[p + 2] as number;
      direction.set(
        (pose[c] as number) - px,
        (pose[c + 1] as number) - py,
        (pose[c + 2] as number) - pz,
      );
      const length = direction.length();
      const w = this.width[k] as number;
      // The shortest rotation from the direction in the first frame: bones do not roll.
      restDirection.set(
        restDirections[3 * k] as number,
        restDirections[3 * k + 1] as number,
        restDirections[3 * k + 2] as number,
      );
      if (length > 0) direction.divideScalar(length);
      rotation.setFromUnitVectors(restDirection, direction);
      // Two fixed axes perpendicular to the rest direction.
      xAxis.set(0, 0, 1);
      if (Math.abs(restDirection.z) > 0.9) xAxis.set(1, 0, 0);
      xAxis.cross(restDirection).normalize();
      zAxis.crossVectors(xAxis, restDirection);
      xAxis.applyQuaternion(rotation);
      zAxis.applyQuaternion(rotation);
      const o = 16 * k;
      matrices[o] = xAxis.x * w;
      matrices[o + 1] = xAxis.y * w;
      matrices[o + 2] = xAxis.z * w;
      matrices[o + 4] = direction.x * length;
      matrices[o + 5] = direction.y * length;
      matrices[o + 6] = direction.z * length;
      matrices[o + 8] = zAxis.x * w;
      matrices[o + 9] = zAxis.y * w;
      matrices[o + 10] = zAxis.z * w;
      matrices[o + 12] = px;
      matrices[o + 13] = py;
      matrices[o + 14] = pz;
      matrices[o + 15] = 1;
    }
    this.bones.instanceMatrix.needsUpdate = true;
  }

  private updateJoints() {
    const matrices = this.joints.instanceMatrix.array;
    for (let j = 0; j < this.radius.length; j++) {
      const o = 16 * j;
      const r = this.radius[j] as number;
      matrices[o] = r;
      matrices[o + 5] = r;
      matrices[o + 10] = r;
      matrices[o + 12] = this.pose[3 * j] as number;
      matrices[o + 13] = this.pose[3 * j + 1] as number;
      matrices[o + 14] = this.pose[3 * j + 2] as number;
      matrices[o + 15] = 1;
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

const xAxis = new Vector3();
const zAxis = new Vector3();

/**
 * Returns the joints that get a bone to their parent. Leaves out bones of no length and those that
 * change their length, such as the translation of a root joint.
 */
function drawnBones(clip: Clip, size: number): number[] {
  const stride = clip.joints.length * 3;
  const frames = Math.max(clip.frames, 1);
  const drawn: number[] = [];
  clip.joints.forEach((joint, i) => {
    if (joint.parent === undefined) return;
    let shortest = Number.POSITIVE_INFINITY;
    let longest = 0;
    for (let k = 0; k < 12; k++) {
      const frame = Math.floor((k / 12) * frames) * stride;
      const c = frame + i * 3;
      const p = frame + joint.parent * 3;
      const difference = (axis: number) =>
        (clip.positions[c + axis] ?? 0) - (clip.positions[p + axis] ?? 0);
      const length = Math.hypot(difference(0), difference(1), difference(2));
      shortest = Math.min(shortest, length);
      longest = Math.max(longest, length);
    }
    const isRigid = longest - shortest <= 0.15 * size;
    if (shortest > 1e-4 * size && isRigid) drawn.push(i);
  });
  return drawn;
}
