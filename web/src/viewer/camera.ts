import CameraControls from "camera-controls";
import {
  Box3,
  MathUtils,
  Matrix4,
  PerspectiveCamera,
  Quaternion,
  Raycaster,
  Sphere,
  Spherical,
  Vector2,
  Vector3,
  Vector4,
} from "three";
import type { CameraPose, CameraView } from "../model/view-state";

CameraControls.install({
  THREE: {
    Box3,
    MathUtils,
    Matrix4,
    Quaternion,
    Raycaster,
    Sphere,
    Spherical,
    Vector2,
    Vector3,
    Vector4,
  },
});

const fov = 32;
/** The part of the free height of the picture that the clip's greatest height takes. */
const share = 0.84;
/** Pixels that the page's own things take from the picture: tools above, on a phone pills below. */
const taken = { wide: { top: 52, bottom: 44 }, narrow: { top: 54, bottom: 54 } };
/** Degrees from straight above. */
const tilt = 76 * MathUtils.DEG2RAD;

/** From where each of the four sides is looked at, in radians; the azimuth from where the character faces. */
const angles = {
  perspective: { azimuth: -0.62, polar: tilt },
  front: { azimuth: 0, polar: 86 * MathUtils.DEG2RAD },
  side: { azimuth: -Math.PI / 2, polar: 86 * MathUtils.DEG2RAD },
  top: { azimuth: -Math.PI / 2, polar: 0 },
};

/** The camera and what it looks at: a person, from an angle, that travels along if asked. */
export class Camera {
  readonly camera = new PerspectiveCamera(fov, 1, 0.05, 200);
  readonly controls: CameraControls;
  /** Whether the character stands beside the middle of the picture. */
  aside = false;
  /** Nobody has moved the camera since the character was framed: a new window size frames it again. */
  private framed = true;
  private readonly target = new Vector3();
  private height = 1.75;
  private free = 1;
  private x = 0;
  private z = 0;

  constructor(canvas: HTMLElement, still: boolean) {
    this.controls = new CameraControls(this.camera, canvas);
    const { controls } = this;
    controls.smoothTime = still ? 0 : 0.11;
    controls.draggingSmoothTime = still ? 0 : 0.06;
    controls.maxPolarAngle = 89 * MathUtils.DEG2RAD;
    controls.dollyToCursor = false;
    controls.addEventListener("controlstart", () => {
      this.framed = false;
    });
    const { ACTION } = CameraControls;
    controls.mouseButtons.right = ACTION.TRUCK;
    controls.mouseButtons.middle = ACTION.TRUCK;
    controls.mouseButtons.wheel = ACTION.DOLLY;
    controls.touches.two = ACTION.TOUCH_DOLLY_TRUCK;
    controls.touches.three = ACTION.TOUCH_TRUCK;
  }

  resize(width: number, height: number) {
    const { camera } = this;
    camera.aspect = width / Math.max(height, 1);
    const right = this.aside && width > 720 ? 0.2 * width : 0;
    // Low enough to leave a phone's words alone, high enough for the gallery's.
    const { top, bottom } = width > 720 ? taken.wide : taken.narrow;
    const up = this.aside ? (right ? 0.07 : -0.03) * height : (bottom - top) / 2;
    this.free = this.aside ? 0.78 : Math.max(1 - (top + bottom) / height, 0.3);
    camera.setViewOffset(width, height, -right, up, width, height);
    if (this.framed) this.frame(false);
  }

  /** Takes the measure of a character: its size, how high it ever reaches, and where it stands. */
  measure(size: number, height: number, x: number, z: number) {
    // A leap from a tower must not make an ant of who leaps.
    this.height = Math.min(Math.max(height, size), 1.6 * size);
    this.x = x;
    this.z = z;
    this.camera.near = size / 40;
    this.camera.far = size * 120;
    this.camera.updateProjectionMatrix();
    this.controls.minDistance = size * 0.3;
    this.controls.maxDistance = size * 40;
  }

  /** How far away something must be for its radius to fill what is free of the picture. */
  private distance(radius: number) {
    const half = Math.tan((fov / 2) * MathUtils.DEG2RAD) * this.free;
    // A narrow picture is short of width before it is short of height.
    return radius / half / Math.min(1, this.camera.aspect * 1.15);
  }

  /** Looks at the character from one of the four sides; `facing` is an azimuth. */
  look(view: CameraView, facing: number, glide: boolean) {
    const { azimuth, polar } = angles[view];
    this.controls.normalizeRotations();
    void this.controls.rotateTo(facing + azimuth, polar, glide);
  }

  /** Whether it looks from a side as it does by itself. */
  isAt(view: CameraView, facing: number): boolean {
    const { azimuth, polar } = angles[view];
    const turn = Math.cos(this.azimuth - facing - azimuth);
    return this.framed && turn > 0.99999 && Math.abs(this.polar - polar) < 0.005;
  }

  /** Where it is and what it looks at. */
  get sight(): CameraPose {
    return {
      eye: this.controls.getPosition(new Vector3()).toArray(),
      at: this.controls.getTarget(new Vector3()).toArray(),
    };
  }

  /** Looks from a place at another. */
  place({ eye, at }: CameraPose) {
    this.framed = false;
    void this.controls.setLookAt(...eye, ...at, false);
  }

  /** Brings the whole character into the picture. */
  frame(glide: boolean) {
    this.framed = true;
    void this.controls.moveTo(this.x, this.height / 2, this.z, glide);
    void this.controls.dollyTo(this.distance(this.height / share / 2), glide);
  }

  /** Brings a whole stretch of floor into the picture. */
  frameBox(low: { x: number; z: number }, high: { x: number; z: number }, glide: boolean) {
    this.framed = false;
    const radius = Math.max(
      Math.hypot(high.x - low.x, high.z - low.z) / 2,
      this.height / share / 2,
    );
    void this.controls.moveTo((low.x + high.x) / 2, this.height / 2, (low.z + high.z) / 2, glide);
    void this.controls.dollyTo(this.distance(radius), glide);
  }

  /** The character has moved; the camera goes along if it follows. */
  travel(x: number, z: number, follow: boolean) {
    const dx = x - this.x;
    const dz = z - this.z;
    this.x = x;
    this.z = z;
    if (!follow || (dx === 0 && dz === 0)) return;
    this.controls.getTarget(this.target);
    void this.controls.moveTo(this.target.x + dx, this.target.y, this.target.z + dz, false);
  }

  get azimuth() {
    return this.controls.azimuthAngle;
  }

  get polar() {
    return this.controls.polarAngle;
  }

  dispose() {
    this.controls.dispose();
  }
}
