import { DirectionalLight, HemisphereLight, Scene, Vector2, WebGLRenderer } from "three";
import { type PlantWindow, plantWindowAt } from "../model/footprints";
import type { Plant } from "../model/plants";
import type { Companion } from "../model/source";
import type { Clip, Detection } from "../model/types";
import type { CameraPose, CameraView, ViewState } from "../model/view-state";
import { Bones } from "./bones";
import { Camera } from "./camera";
import { CompanionFigure } from "./companion";
import { Footprints } from "./footprints";
import { MainCharacter } from "./main-character";
import { readPalette } from "./palette";
import { Trails } from "./trails";

/** The same clip as it was before, seen through. */
interface Ghost {
  clip: Clip;
  bones: Bones;
}

/** The labels of that clip. */
interface Labels {
  detection: Detection;
  plants: readonly Plant[];
}

/** The prints of the plants near the moment. */
interface VisibleFootprints {
  near: PlantWindow;
  prints: Footprints;
}

/** The three.js scene. Draws only when something asked for it. */
export class Stage {
  follow = true;
  private readonly host: HTMLElement;
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly camera: Camera;
  private readonly observer: ResizeObserver;
  private lead: MainCharacter | null = null;
  private labels: Labels | null = null;
  private visibleFootprints: VisibleFootprints | null = null;
  private ghost: Ghost | null = null;
  private companions: CompanionFigure[] = [];
  private trails: Trails | null = null;
  /** What was replaced. It goes after its successor was drawn, so that shaders they share stay compiled. */
  private readonly retired: { dispose: () => void }[] = [];
  /** With a new clip comes the rest of the page: drawn before its place is measured, it is drawn twice. */
  private fits = false;
  private moment = 0;
  private due = 0;
  private before = 0;

  /** Throws where the browser has no WebGL. */
  constructor(host: HTMLElement, still: boolean) {
    this.host = host;
    this.renderer = new WebGLRenderer({ antialias: true });
    const canvas = this.renderer.domElement;
    host.append(canvas);
    this.scene.background = readPalette(host).ground;
    this.camera = new Camera(canvas, still);
    for (const event of ["control", "wake", "transitionstart"] as const) {
      this.camera.controls.addEventListener(event, () => this.invalidate());
    }
    const key = new DirectionalLight(0xffffff, 2.1);
    key.position.set(-1.2, 1.6, 1.4);
    // The key light sits on the camera's shoulder: no side of the skeleton is ever black.
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
    // At once: a cleared canvas must not flash.
    if (this.fit()) this.draw();
    else this.invalidate();
  }

  /** Fits the picture to its place, and tells whether that was of another size. */
  private fit(): boolean {
    const { clientWidth: width, clientHeight: height } = this.host;
    if (!width || !height) return false;
    this.camera.resize(width, height);
    const { renderer } = this;
    const ratio = Math.min(devicePixelRatio, 2);
    renderer.getSize(measured);
    // A new buffer takes tens of milliseconds: only for a new size.
    if (renderer.getPixelRatio() === ratio && measured.equals(wanted.set(width, height))) {
      return false;
    }
    renderer.setDrawingBufferSize(width, height, ratio);
    return true;
  }

  /** Shows another clip; `reframe` also brings the camera to it. */
  setClip(clip: Clip | null, reframe: boolean) {
    this.setLabels(null, []);
    this.setGhost(null);
    this.setCompanions([]);
    this.setTrails(false);
    this.clear();
    if (clip) this.addCharacter(clip);
    if (this.lead && reframe) {
      const { lead } = this;
      const { x, z } = lead.at(this.moment);
      this.camera.measure(lead.size, lead.reach, x, z);
      this.camera.frame(false);
      this.look("perspective", false, 0);
      this.fits = false;
    }
    this.invalidate();
  }

  private addCharacter(clip: Clip) {
    const palette = readPalette(this.host);
    this.scene.background = palette.ground;
    this.lead = new MainCharacter(clip, palette);
    this.lead.enter(this.scene);
  }

  private clear() {
    if (!this.lead) return;
    this.lead.leave(this.scene);
    this.retired.push(this.lead);
    this.lead = null;
  }

  /** Shows the ways of toes and root around the moment, or does not. */
  setTrails(wanted: boolean) {
    if (this.trails) {
      this.scene.remove(this.trails.group);
      this.retired.push(this.trails);
    }
    const { lead } = this;
    this.trails =
      wanted && lead?.clip.frames ? new Trails(lead.clip, readPalette(this.host)) : null;
    if (this.trails) this.scene.add(this.trails.group);
    this.invalidate();
  }

  /** Shows other clips at the side of the one on stage; they start where it does, and go their own way. */
  setCompanions(others: readonly Companion[]) {
    for (const companion of this.companions) companion.leave(this.scene);
    this.retired.push(...this.companions);
    const { lead } = this;
    const palette = readPalette(this.host);
    this.companions = lead ? others.map((it, i) => new CompanionFigure(lead, it, i, palette)) : [];
    for (const companion of this.companions) companion.enter(this.scene);
    this.invalidate();
  }

  /** Shows the clip on stage once more, as it was before; `null` shows none. */
  setGhost(clip: Clip | null) {
    if (this.ghost) {
      this.scene.remove(this.ghost.bones.group);
      this.retired.push(this.ghost.bones);
    }
    this.ghost = null;
    if (clip && this.lead) {
      const bones = new Bones(clip, this.lead.size, readPalette(this.host), true);
      this.ghost = { clip, bones };
      this.scene.add(bones.group);
    }
    this.invalidate();
  }

  /** Shows the labels of the clip on stage. */
  setLabels(detection: Detection | null, plants: readonly Plant[]) {
    this.labels = this.lead && detection ? { detection, plants } : null;
    this.hideFootprints();
    this.invalidate();
  }

  /** Prints are laid when they are drawn first, and others where the moment has come too far. */
  private showFootprints({ clip, size }: MainCharacter) {
    const { labels, visibleFootprints, moment } = this;
    if (
      !labels ||
      (visibleFootprints &&
        moment >= visibleFootprints.near.since &&
        moment < visibleFootprints.near.until)
    )
      return;
    const near = plantWindowAt(labels.plants, moment);
    const plants = labels.plants.slice(near.from, near.to);
    const prints = new Footprints(clip, plants, size, readPalette(this.host));
    this.hideFootprints();
    prints.enter(this.scene);
    this.visibleFootprints = { near, prints };
  }

  private hideFootprints() {
    if (!this.visibleFootprints) return;
    this.visibleFootprints.prints.leave(this.scene);
    this.retired.push(this.visibleFootprints.prints);
    this.visibleFootprints = null;
  }

  seek(moment: number) {
    this.moment = Math.max(0, moment);
    this.invalidate();
  }

  /** Looks from a side at where the character faces, at the moment or at a frame. */
  look(view: CameraView, glide = true, frame = Math.floor(this.moment)) {
    if (!this.lead) return;
    this.camera.look(view, this.lead.facing(frame), glide);
    this.invalidate();
  }

  /** What the camera sees; absent where it does so by itself once a clip is open and a side chosen. */
  cameraPose(view: CameraView): CameraPose | undefined {
    if (!this.lead) return undefined;
    // Nobody has asked for the first side: it is that of the first frame.
    const frame = view === "perspective" ? 0 : Math.floor(this.moment);
    const isUsual = this.camera.isAt(view, this.lead.facing(frame));
    return isUsual ? undefined : this.camera.sight;
  }

  /** Looks at the moment from a place at another, or from a side. */
  show({ view, eye, at }: ViewState) {
    if (!this.lead) return;
    const { x, z } = this.lead.at(this.moment);
    // Along with the character, as if it had walked there.
    this.camera.travel(x, z, true);
    if (view) this.look(view, false);
    if (eye && at) this.camera.place({ eye, at });
    this.invalidate();
  }

  /** A picture of what is to be seen. */
  picture(): Promise<Blob | null> {
    // The drawing does not outlast the task it is drawn in.
    this.draw();
    return new Promise((resolve) => this.canvas.toBlob(resolve));
  }

  /** The character, or all of its way where the camera stands still. */
  frameAll() {
    const { lead } = this;
    if (!lead) return;
    if (this.follow) this.camera.frame(true);
    else {
      const { low, high } = lead.bounds();
      this.camera.frameBox(low, high, true);
    }
    this.invalidate();
  }

  /** Behind the empty page the character stands aside from the words. */
  setAside(aside: boolean) {
    this.camera.aside = aside;
    this.resize();
  }

  setFollow(follow: boolean) {
    const began = follow && !this.follow;
    this.follow = follow;
    if (began) this.camera.frame(true);
    this.invalidate();
  }

  invalidate() {
    if (!this.due) this.due = requestAnimationFrame(this.tick);
  }

  private readonly tick = (now: number) => {
    this.due = 0;
    const elapsed = Math.min((now - this.before) / 1000, 0.1);
    this.before = now;
    const moving = this.camera.controls.update(elapsed);
    if (!this.fits) this.fit();
    this.fits = true;
    this.draw();
    if (moving) this.invalidate();
  };

  private draw() {
    const { lead } = this;
    if (lead) {
      this.showFootprints(lead);
      const { clip } = lead;
      const { x, z } = lead.at(this.moment);
      this.camera.travel(x, z, this.follow);
      this.camera.controls.update(0);
      const detection = this.labels?.detection ?? null;
      const moment = Math.min(this.moment, Math.max(clip.frames - 1, 0));
      const floor = detection?.floor ?? lead.lowest;
      lead.show(moment, floor, detection);
      this.ghost?.bones.show(this.ghost.clip, moment, floor);
      this.trails?.show(moment, floor);
      const seconds = this.moment / clip.rate;
      this.visibleFootprints?.prints.show(seconds, this.camera.azimuth, this.camera.polar, x, z);
      for (const companion of this.companions) companion.show(seconds);
    }
    this.renderer.render(this.scene, this.camera.camera);
    // Not in the same task: a clip's first picture takes long enough.
    if (!this.retired.length) return;
    const parts = this.retired.splice(0);
    setTimeout(() => dispose(parts));
  }

  dispose() {
    cancelAnimationFrame(this.due);
    this.observer.disconnect();
    this.setLabels(null, []);
    cancelAnimationFrame(this.due);
    this.setGhost(null);
    this.setCompanions([]);
    this.setTrails(false);
    cancelAnimationFrame(this.due);
    this.clear();
    dispose(this.retired);
    this.camera.dispose();
    this.renderer.dispose();
    this.canvas.remove();
  }
}

function dispose(parts: readonly { dispose: () => void }[]) {
  for (const part of parts) part.dispose();
}

const measured = new Vector2();
const wanted = new Vector2();
