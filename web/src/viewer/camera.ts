import CameraControls from "camera-controls";
import {
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
} from "three";
import type { CameraPose, CameraView } from "../model/stored/view-state";
import { ViewCamera } from "./view-camera";

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
/** Fraction of the free canvas height that the tallest pose fills. */
const characterFraction = 0.84;
/** Canvas height covered by controls, in pixels: tools at the top, pills at the bottom on a phone. */
const reserved = {
  wide: { top: 52, bottom: 44 },
  narrow: { top: 54, bottom: 46 },
  short: { top: 36, bottom: 30 },
};
/** Height of the largest page that has the small controls of a short page, in pixels, as in the styles. */
const shortPage = 560;
/** Height of the centre and radius of a close-up of the feet, as fractions of the size. */
const feetHeight = 0.09;
const feetRadius = 0.3;
/** Polar angle of the perspective view, in radians from straight above. */
const perspectivePolar = 76 * MathUtils.DEG2RAD;

/** Angles of the preset views, in radians; azimuths are relative to the facing direction. */
const presetAngles = {
  perspective: { azimuth: -0.62, polar: perspectivePolar },
  front: { azimuth: 0, polar: 90 * MathUtils.DEG2RAD },
  side: { azimuth: -Math.PI / 2, polar: 90 * MathUtils.DEG2RAD },
  top: { azimuth: -Math.PI / 2, polar: 0 },
};

/** An orbit camera on one character, with preset views, which can follow the character. */
export class Camera {
  readonly camera = new ViewCamera(fov, 1, 0.05, 200);
  readonly controls: CameraControls;
  /** True on the start page, where the character is off-centre to leave space for the text. */
  isPreview = false;
  /** True until the user moves the camera; only then does resizing frame the character again. */
  private isFramed = true;
  private readonly target = new Vector3();
  /** Height of the framed character, metres. */
  private height = 1.75;
  /** Fraction of the canvas height without controls. */
  private freeFraction = 1;
  private x = 0;
  private z = 0;
  private wasFlat = false;

  constructor(canvas: HTMLElement, reducedMotion: boolean) {
    this.controls = new CameraControls(this.camera, canvas);
    const { controls } = this;
    controls.smoothTime = reducedMotion ? 0 : 0.11;
    controls.draggingSmoothTime = reducedMotion ? 0 : 0.06;
    controls.maxPolarAngle = 90 * MathUtils.DEG2RAD;
    controls.dollyToCursor = true;
    controls.addEventListener("controlstart", () => {
      this.isFramed = false;
    });
    const { ACTION } = CameraControls;
    controls.addEventListener("control", () => {
      // The wheel, which starts no drag, moves the camera, too.
      this.isFramed = false;
      // A rotated view is no longer the front, the side or the top.
      if (
        controls.currentAction === ACTION.ROTATE ||
        controls.currentAction === ACTION.TOUCH_ROTATE
      )
        this.camera.isFlat = false;
    });
    controls.mouseButtons.right = ACTION.TRUCK;
    controls.mouseButtons.middle = ACTION.TRUCK;
    controls.mouseButtons.wheel = ACTION.DOLLY;
    controls.touches.two = ACTION.TOUCH_DOLLY_TRUCK;
    controls.touches.three = ACTION.TOUCH_TRUCK;
  }

  resize(width: number, height: number) {
    const { camera } = this;
    camera.aspect = width / Math.max(height, 1);
    const isShort = innerHeight <= shortPage;
    const isWide = width > 720 || (isShort && width > 559);
    const right = this.isPreview && isWide ? 0.2 * width : 0;
    // Below the headline on a phone, above the gallery on a wide page.
    const { top, bottom } = isShort ? reserved.short : isWide ? reserved.wide : reserved.narrow;
    const up = this.isPreview ? (right ? 0.07 : -0.03) * height : (bottom - top) / 2;
    this.freeFraction = this.isPreview ? 0.78 : Math.max(1 - (top + bottom) / height, 0.3);
    camera.setViewOffset(width, height, -right, up, width, height);
    if (this.isFramed) this.frame(false);
  }

  /** Sets the character: its size, the greatest height that it reaches, and its ground position. */
  setCharacter(size: number, maxHeight: number, x: number, z: number) {
    // Limited, so that a jump from a height does not make the character tiny.
    this.height = Math.min(Math.max(maxHeight, size), 1.6 * size);
    this.x = x;
    this.z = z;
    this.camera.near = size / 40;
    this.camera.far = size * 120;
    this.camera.updateProjectionMatrix();
    this.controls.minDistance = size * 0.3;
    this.controls.maxDistance = size * 40;
  }

  /** Returns the distance at which an object of this radius fills the free part of the canvas. */
  private distance(radius: number) {
    const half = Math.tan((fov / 2) * MathUtils.DEG2RAD) * this.freeFraction;
    // On a narrow canvas the width is the limit.
    return radius / half / Math.min(1, this.camera.aspect * 1.15);
  }

  /** Rotates to a preset view; `facing` is the azimuth of the facing direction. */
  setView(view: CameraView, facing: number, animate: boolean) {
    const { azimuth, polar } = presetAngles[view];
    this.camera.isFlat = view !== "perspective";
    this.controls.normalizeRotations();
    void this.controls.rotateTo(facing + azimuth, polar, animate);
  }

  /** True if the user has not moved the camera away from a preset view. */
  isAtPreset(view: CameraView, facing: number): boolean {
    const { azimuth, polar } = presetAngles[view];
    const alignment = Math.cos(this.azimuth - facing - azimuth);
    return this.isFramed && alignment > 0.99999 && Math.abs(this.polar - polar) < 0.005;
  }

  /** Position of the camera and its target. */
  get pose(): CameraPose {
    return {
      eye: this.controls.getPosition(new Vector3()).toArray(),
      at: this.controls.getTarget(new Vector3()).toArray(),
    };
  }

  setPose({ eye, at }: CameraPose) {
    this.isFramed = false;
    void this.controls.setLookAt(...eye, ...at, false);
  }

  /** Moves so that the whole character is visible. */
  frame(animate: boolean) {
    this.isFramed = true;
    void this.controls.moveTo(this.x, this.height / 2, this.z, animate);
    void this.controls.dollyTo(this.distance(this.height / characterFraction / 2), animate);
  }

  /** Moves close to the feet; `ground` is the height of the floor under them, in metres. */
  frameFeet(ground: number, size: number, animate: boolean) {
    this.isFramed = false;
    void this.controls.moveTo(this.x, ground + feetHeight * size, this.z, animate);
    void this.controls.dollyTo(this.distance(feetRadius * size), animate);
  }

  /** Moves so that characters next to the main one are visible, up to a distance on either side. */
  frameGroup(halfWidth: number, animate: boolean) {
    this.isFramed = false;
    void this.controls.moveTo(this.x, this.height / 2, this.z, animate);
    const half = Math.tan((fov / 2) * MathUtils.DEG2RAD) * this.camera.aspect;
    const distance = Math.max(
      this.distance(this.height / characterFraction / 2),
      halfWidth / half + halfWidth,
    );
    void this.controls.dollyTo(distance, animate);
  }

  /** Adapts the projection to the distance of the target. */
  updateProjection() {
    const { camera } = this;
    const isFlat = camera.isFlat;
    if (!isFlat && !this.wasFlat) return;
    this.wasFlat = isFlat;
    camera.targetDistance = this.controls.distance;
    camera.updateProjectionMatrix();
  }

  /** Moves so that a rectangle on the ground is visible. */
  frameBounds(low: { x: number; z: number }, high: { x: number; z: number }, animate: boolean) {
    this.isFramed = false;
    const radius = Math.max(
      Math.hypot(high.x - low.x, high.z - low.z) / 2,
      this.height / characterFraction / 2,
    );
    void this.controls.moveTo((low.x + high.x) / 2, this.height / 2, (low.z + high.z) / 2, animate);
    void this.controls.dollyTo(this.distance(radius), animate);
  }

  /** Takes the new ground position of the character; moves along with it if `follow` is set. */
  followCharacter(x: number, z: number, follow: boolean) {
    const dx = x - this.x;
    const dz = z - this.z;
    this.x = x;
    this.z = z;
    if (!follow || (dx === 0 && dz === 0)) return;
    this.controls.getTarget(this.target);
    void this.controls.moveTo(this.target.x + dx, this.target.y, this.target.z + dz, false);
  }

  /** True in a view from the front or the side. */
  get isEdgeOn() {
    return this.camera.isFlat && this.polar > 1;
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
