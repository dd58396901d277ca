import { DirectionalLight, HemisphereLight, Scene, Vector2, WebGLRenderer } from "three";
import { type PlantWindow, plantWindowAt } from "../model/motion/footprints";
import { groundPlane } from "../model/motion/ground";
import type { Plant } from "../model/plants/plants";
import type { Companion } from "../model/sources/source";
import type { CameraPose, CameraView, ViewState } from "../model/stored/view-state";
import type { Clip, Detection } from "../model/types";
import { Bones } from "./bones";
import { Camera } from "./camera";
import { CompanionFigure, companionDistance } from "./companion";
import { FootOffsets } from "./foot-offsets";
import { Footprints } from "./footprints";
import { JointMarker } from "./joint-marker";
import { MainCharacter } from "./main-character";
import { NameTag } from "./name-tag";
import { type Palette, readPalette } from "./palette";
import { groundUniform } from "./quads";
import { Trails } from "./trails";

/** The uncorrected clip, drawn translucent, with lines that show how far the feet were moved. */
interface Ghost {
  clip: Clip;
  bones: Bones;
  offsets: FootOffsets;
}

/** The labels of the open clip. */
interface Labels {
  detection: Detection;
  plants: readonly Plant[];
}

/** Footprints of the plants near the playhead. */
interface VisibleFootprints {
  plantWindow: PlantWindow;
  footprints: Footprints;
}

/** The three.js scene. Draws on demand only, see `invalidate`. */
export class Stage {
  follow = true;
  private readonly host: HTMLElement;
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly camera: Camera;
  private readonly observer: ResizeObserver;
  private mainCharacter: MainCharacter | null = null;
  private labels: Labels | null = null;
  private visibleFootprints: VisibleFootprints | null = null;
  private ghost: Ghost | null = null;
  private companions: CompanionFigure[] = [];
  /** Names of the main character and of the companions; empty without companions. */
  private nameTags: NameTag[] = [];
  /** Number of companions that the camera has framed. */
  private groupSize = 0;
  private trails: Trails | null = null;
  private jointMarker: JointMarker | null = null;
  /** Replaced objects, disposed of after the next draw, so that shared shaders stay compiled. */
  private readonly retired: { dispose: () => void }[] = [];
  /** False after a new clip: the page layout changes, so the size is measured before drawing. */
  private isSized = false;
  /** Playhead position in frames, possibly fractional. */
  private playhead = 0;
  /** Pending animation frame, 0 if none. */
  private frameRequest = 0;
  /** Time of the previous animation frame, in milliseconds. */
  private previousTick = 0;

  /** Throws if WebGL is unavailable. */
  constructor(host: HTMLElement, reducedMotion: boolean) {
    this.host = host;
    this.renderer = new WebGLRenderer({ antialias: true });
    const canvas = this.renderer.domElement;
    host.append(canvas);
    this.scene.background = readPalette(host).background;
    this.camera = new Camera(canvas, reducedMotion);
    for (const event of ["control", "wake", "transitionstart"] as const) {
      this.camera.controls.addEventListener(event, () => this.invalidate());
    }
    const key = new DirectionalLight(0xffffff, 2.1);
    key.position.set(-1.2, 1.6, 1.4);
    // Attached to the camera, so that no visible side of the skeleton is unlit.
    this.camera.camera.add(key);
    this.scene.add(this.camera.camera, new HemisphereLight(0xffffff, 0x8794a3, 1.5));
    this.observer = new ResizeObserver(() => this.resize());
    this.observer.observe(host);
    this.resize();
  }

  get canvas() {
    return this.renderer.domElement;
  }

  private resize() {
    // Drawn immediately: resizing clears the canvas, which would flicker.
    if (this.updateSize()) this.draw();
    else this.invalidate();
  }

  /** Adapts the drawing buffer to the size of the host; returns true if the size has changed. */
  private updateSize(): boolean {
    const { clientWidth: width, clientHeight: height } = this.host;
    if (!width || !height) return false;
    this.camera.resize(width, height);
    const { renderer } = this;
    const ratio = Math.min(devicePixelRatio, 2);
    renderer.getSize(currentSize);
    // Reallocating the buffer takes tens of milliseconds.
    if (
      renderer.getPixelRatio() === ratio &&
      currentSize.equals(requestedSize.set(width, height))
    ) {
      return false;
    }
    renderer.setDrawingBufferSize(width, height, ratio);
    return true;
  }

  /** Replaces the clip; `reframe` also resets the camera. */
  setClip(clip: Clip | null, reframe: boolean) {
    this.setLabels(null, []);
    this.setGhost(null);
    this.setCompanions([]);
    this.setTrails(false);
    this.markJoint(null);
    this.removeMainCharacter();
    if (clip) this.addMainCharacter(clip);
    if (this.mainCharacter && reframe) {
      const { mainCharacter } = this;
      const { x, z } = mainCharacter.groundPosition(this.playhead);
      this.camera.setCharacter(mainCharacter.size, mainCharacter.maxHeight, x, z);
      this.camera.frame(false);
      this.setCameraView("perspective", false, 0);
      this.isSized = false;
    }
    this.invalidate();
  }

  private addMainCharacter(clip: Clip) {
    const palette = readPalette(this.host);
    this.scene.background = palette.background;
    this.mainCharacter = new MainCharacter(clip, palette);
    this.mainCharacter.addTo(this.scene);
  }

  private removeMainCharacter() {
    if (!this.mainCharacter) return;
    this.mainCharacter.removeFrom(this.scene);
    this.retired.push(this.mainCharacter);
    this.mainCharacter = null;
  }

  /** Shows or hides the trails of the toes and the root. */
  setTrails(visible: boolean) {
    if (this.trails) {
      this.scene.remove(this.trails.group);
      this.retired.push(this.trails);
    }
    const { mainCharacter } = this;
    this.trails =
      visible && mainCharacter?.clip.frames
        ? new Trails(mainCharacter.clip, readPalette(this.host))
        : null;
    if (this.trails) this.scene.add(this.trails.group);
    this.invalidate();
  }

  /** Puts a ring around a joint of the main character, or removes it. */
  markJoint(joint: number | null) {
    if (this.jointMarker) {
      this.scene.remove(this.jointMarker.mesh);
      this.retired.push(this.jointMarker);
      this.jointMarker = null;
    }
    const { mainCharacter } = this;
    if (mainCharacter && joint !== null) {
      const { clip, size } = mainCharacter;
      this.jointMarker = new JointMarker(clip, joint, size, readPalette(this.host));
      this.scene.add(this.jointMarker.mesh);
    }
    this.invalidate();
  }

  /**
   * Replaces the comparison clips, which start next to the main character. `names` are that of its clip and theirs.
   */
  setCompanions(others: readonly Companion[], names: readonly string[] = []) {
    for (const companion of this.companions) companion.removeFrom(this.scene);
    this.retired.push(...this.companions);
    const { mainCharacter } = this;
    const palette = readPalette(this.host);
    this.companions = mainCharacter
      ? others.map((companion, i) => new CompanionFigure(mainCharacter, companion, i, palette))
      : [];
    for (const companion of this.companions) companion.addTo(this.scene);
    this.setNameTags(others.length ? names : [], palette);
    if (mainCharacter && others.length > this.groupSize)
      this.camera.frameGroup(this.halfWidth, true);
    this.groupSize = others.length;
    this.invalidate();
  }

  /** Half the width of the group of characters, in metres. */
  private get halfWidth() {
    const { size } = this.mainCharacter ?? { size: 1 };
    return companionDistance(size, this.companions.length - 1) + 0.4 * size;
  }

  /** Names the characters if there are several. */
  private setNameTags(names: readonly string[], palette: Palette) {
    for (const tag of this.nameTags) this.scene.remove(tag.sprite);
    this.retired.push(...this.nameTags);
    const { mainCharacter } = this;
    this.nameTags = mainCharacter
      ? names.map((name) => new NameTag(name, mainCharacter.size, palette))
      : [];
    for (const tag of this.nameTags) this.scene.add(tag.sprite);
  }

  /** Shows a translucent copy of a clip at the main character; `null` removes it. */
  setGhost(clip: Clip | null) {
    if (this.ghost) {
      this.scene.remove(this.ghost.bones.group, this.ghost.offsets.lines);
      this.retired.push(this.ghost.bones, this.ghost.offsets);
    }
    this.ghost = null;
    if (clip && this.mainCharacter) {
      const palette = readPalette(this.host);
      const bones = new Bones(clip, this.mainCharacter.size, palette, true);
      const offsets = new FootOffsets(clip, palette);
      this.ghost = { clip, bones, offsets };
      this.scene.add(bones.group, offsets.lines);
    }
    this.invalidate();
  }

  /** Replaces the labels of the clip. */
  setLabels(detection: Detection | null, plants: readonly Plant[]) {
    this.labels = this.mainCharacter && detection ? { detection, plants } : null;
    this.hideFootprints();
    this.invalidate();
  }

  /** Creates footprints on the first draw, and again when the playhead has left their window. */
  private showFootprints({ clip, size }: MainCharacter) {
    const { labels, visibleFootprints, playhead } = this;
    if (
      !labels ||
      (visibleFootprints &&
        playhead >= visibleFootprints.plantWindow.since &&
        playhead < visibleFootprints.plantWindow.until)
    )
      return;
    const plantWindow = plantWindowAt(labels.plants, playhead);
    const plants = labels.plants.slice(plantWindow.from, plantWindow.to);
    const palette = readPalette(this.host);
    const footprints = new Footprints(clip, labels.detection, plants, size, palette);
    this.hideFootprints();
    footprints.addTo(this.scene);
    this.visibleFootprints = { plantWindow, footprints };
  }

  private hideFootprints() {
    if (!this.visibleFootprints) return;
    this.visibleFootprints.footprints.removeFrom(this.scene);
    this.retired.push(this.visibleFootprints.footprints);
    this.visibleFootprints = null;
  }

  seek(playhead: number) {
    this.playhead = Math.max(0, playhead);
    this.invalidate();
  }

  /** Rotates the camera to a preset view, relative to the facing direction in a frame. */
  setCameraView(view: CameraView, animate = true, frame = Math.floor(this.playhead)) {
    if (!this.mainCharacter) return;
    this.camera.setView(view, this.mainCharacter.facingAngle(frame), animate);
    this.invalidate();
  }

  /** Returns the camera pose; undefined if it is the default pose of the preset view. */
  cameraPose(view: CameraView): CameraPose | undefined {
    if (!this.mainCharacter) return undefined;
    // The initial perspective view is relative to the first frame.
    const frame = view === "perspective" ? 0 : Math.floor(this.playhead);
    const isDefault = this.camera.isAtPreset(view, this.mainCharacter.facingAngle(frame));
    return isDefault ? undefined : this.camera.pose;
  }

  /** Applies a preset view, a camera pose or both. */
  applyViewState({ view, eye, at }: ViewState) {
    if (!this.mainCharacter) return;
    const { x, z } = this.mainCharacter.groundPosition(this.playhead);
    this.camera.followCharacter(x, z, true);
    if (view) this.setCameraView(view, false);
    if (eye && at) this.camera.setPose({ eye, at });
    this.invalidate();
  }

  /** Returns the current view as a PNG image. */
  picture(): Promise<Blob | null> {
    // The drawing buffer is only valid in the task that draws it.
    this.draw();
    return new Promise((resolve) => this.canvas.toBlob(resolve));
  }

  /** Moves the camera to the feet. */
  frameFeet() {
    const { mainCharacter } = this;
    if (!mainCharacter) return;
    let ground = Number.POSITIVE_INFINITY;
    for (let i = 1; i < mainCharacter.pose.length; i += 3)
      ground = Math.min(ground, mainCharacter.pose[i] as number);
    this.camera.frameFeet(ground, mainCharacter.size, true);
    this.invalidate();
  }

  /** Frames the character if the camera follows it, otherwise its whole trajectory. */
  frameAll() {
    const { mainCharacter } = this;
    if (!mainCharacter) return;
    if (this.companions.length) this.camera.frameGroup(this.halfWidth, true);
    else if (this.follow) this.camera.frame(true);
    else {
      const { low, high } = mainCharacter.groundBounds();
      this.camera.frameBounds(low, high, true);
    }
    this.invalidate();
  }

  /** Moves the character off-centre on the start page, to leave space for the text. */
  setPreview(isPreview: boolean) {
    this.camera.isPreview = isPreview;
    this.resize();
  }

  setFollow(follow: boolean) {
    const isStarting = follow && !this.follow;
    this.follow = follow;
    if (isStarting && this.companions.length) this.camera.frameGroup(this.halfWidth, true);
    else if (isStarting) this.camera.frame(true);
    this.invalidate();
  }

  /** Draws now if a draw is requested. */
  flush() {
    if (!this.frameRequest) return;
    cancelAnimationFrame(this.frameRequest);
    this.tick(performance.now());
  }

  /** Requests a draw in the next animation frame. */
  invalidate() {
    if (!this.frameRequest) this.frameRequest = requestAnimationFrame(this.tick);
  }

  private readonly tick = (now: number) => {
    this.frameRequest = 0;
    const elapsed = Math.min((now - this.previousTick) / 1000, 0.1);
    this.previousTick = now;
    const isMoving = this.camera.controls.update(elapsed);
    if (!this.isSized) this.updateSize();
    this.isSized = true;
    this.draw();
    if (isMoving) this.invalidate();
  };

  private draw() {
    const { mainCharacter } = this;
    if (mainCharacter) {
      this.showFootprints(mainCharacter);
      const { clip } = mainCharacter;
      const { x, z } = mainCharacter.groundPosition(this.playhead);
      this.camera.followCharacter(x, z, this.follow);
      this.camera.controls.update(0);
      const detection = this.labels?.detection ?? null;
      const playhead = Math.min(this.playhead, Math.max(clip.frames - 1, 0));
      const groundHeight = detection?.floor ?? mainCharacter.fallbackGroundHeight;
      const { slopeX, slopeZ, offset } = groundPlane(detection);
      groundUniform.value.set(slopeX, slopeZ, offset);
      mainCharacter.update(playhead, groundHeight, detection, this.camera.isEdgeOn);
      if (this.ghost) {
        const { bones, offsets } = this.ghost;
        bones.setPose(this.ghost.clip, playhead, groundHeight);
        offsets.update(mainCharacter.pose, bones.pose);
      }
      this.jointMarker?.update(mainCharacter.pose);
      this.trails?.update(playhead, groundHeight);
      const seconds = this.playhead / clip.rate;
      this.visibleFootprints?.footprints.update(
        seconds,
        this.camera.azimuth,
        this.camera.polar,
        x,
        z,
      );
      for (const companion of this.companions) companion.update(seconds);
      for (const [i, tag] of this.nameTags.entries())
        tag.moveAbove(i === 0 ? mainCharacter.pose : (this.companions[i - 1]?.pose ?? noPose));
    }
    this.camera.updateProjection();
    this.renderer.render(this.scene, this.camera.camera);
    // In a later task: the first draw of a clip is already slow.
    if (!this.retired.length) return;
    const parts = this.retired.splice(0);
    setTimeout(() => dispose(parts));
  }

  dispose() {
    cancelAnimationFrame(this.frameRequest);
    this.observer.disconnect();
    this.setLabels(null, []);
    cancelAnimationFrame(this.frameRequest);
    this.setGhost(null);
    this.setCompanions([]);
    this.setTrails(false);
    this.markJoint(null);
    cancelAnimationFrame(this.frameRequest);
    this.removeMainCharacter();
    dispose(this.retired);
    this.camera.dispose();
    this.renderer.dispose();
    this.canvas.remove();
  }
}

function dispose(parts: readonly { dispose: () => void }[]) {
  for (const part of parts) part.dispose();
}

const noPose = new Float32Array(0);
const currentSize = new Vector2();
const requestedSize = new Vector2();
