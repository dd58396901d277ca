/**
 * Foot plant detection in motion capture.
 *
 * Positions are in metres, Y up; times are in seconds; frames count from 0 and frame ranges are
 * half-open. Objects that own memory of the module have `free()` and support `using`.
 */

import load, {
  type ActionInfo,
  type ClipInfo,
  type CurveInfo,
  type CutEditInfo,
  type DetectOptions,
  type EditInfo,
  type Failure,
  type FootFrames,
  type FormatInfo,
  type GaitInfo,
  type GroundInfo,
  type InstantInfo,
  gaitFormats as listGaitFormats,
  methods as listMethods,
  plantFormats as listPlantFormats,
  segmentFormats as listSegmentFormats,
  segmentMethods as listSegmentMethods,
  type MethodInfo,
  type NoiseInfo,
  type NoticeInfo,
  type Overrides,
  type SegmentInfo,
  type SegmentMethodInfo,
  type SegmentOptions,
  type SimilarInfo,
  type SlideInfo,
  type StepInfo,
  type WasmClip,
  type WasmDetection,
  WasmReader,
  type WasmSegmentation,
} from "./plantigrade.js";

export type {
  ActionInfo,
  ClipInfo,
  CurveInfo,
  CutEditInfo,
  DetectOptions,
  EditInfo,
  FootFrames,
  FormatInfo,
  GaitInfo,
  GroundInfo,
  InstantInfo,
  MethodInfo,
  NoiseInfo,
  NoticeInfo,
  Overrides,
  SegmentInfo,
  SegmentMethodInfo,
  SegmentOptions,
  SimilarInfo,
  SlideInfo,
  StepInfo,
};

export type Side = "left" | "right";
export type Part = "contact" | "toe" | "heel";

/** An operation that failed; `failure` has `line`, `column` and `hint` where known. */
export class PlantigradeError extends Error {
  override name = "PlantigradeError";
  constructor(readonly failure: Failure) {
    super(failure.message);
  }
}

let loading: Promise<unknown> | undefined;

/**
 * Loads the module; must have resolved before anything else is used.
 *
 * @param source URL, response, bytes or compiled module. Default: the file in the package.
 */
export function init(source?: Parameters<typeof load>[0]): Promise<void> {
  loading ??= (source === undefined ? packagedModule() : Promise.resolve(source)).then((module) =>
    load({ module_or_path: module as WebAssembly.Module }),
  );
  return loading.then(() => {});
}

/** Returns the module in the package: its URL, or its bytes in Node, which cannot fetch files. */
async function packagedModule(): Promise<URL | BufferSource> {
  const url = new URL("./plantigrade_bg.wasm", import.meta.url);
  if (url.protocol !== "file:") return url;
  const { readFile } = await import("node:fs/promises");
  return readFile(url);
}

/** Returns all detection methods, the default first. */
export const methods = (): MethodInfo[] => rethrow(listMethods);

/** Returns all segmentation methods, the default first. */
export const segmentMethods = (): SegmentMethodInfo[] => rethrow(listSegmentMethods);

/** Returns all file formats of plants, the default first. */
export const plantFormats = (): FormatInfo[] => rethrow(listPlantFormats);

/** Returns all file formats of segments, the default first. */
export const segmentFormats = (): FormatInfo[] => rethrow(listSegmentFormats);

/** Returns all file formats of gait, the default first. */
export const gaitFormats = (): FormatInfo[] => rethrow(listGaitFormats);

/** A clip of motion capture. */
export class Clip {
  private constructor(private readonly inner: WasmClip) {}

  /**
   * Reads a BVH file from its bytes or from chunks of them.
   *
   * @param lenient Replace values that are not numbers by those of the previous frame. Default false.
   * @throws PlantigradeError If the file cannot be read.
   */
  static read(bytes: Uint8Array | Iterable<Uint8Array>, lenient = false): Clip {
    const chunks = bytes instanceof Uint8Array ? [bytes] : [...bytes];
    const total = chunks.reduce((sum, { length }) => sum + length, 0);
    return rethrow(() => {
      const reader = new WasmReader(lenient, total);
      try {
        for (const chunk of chunks) reader.push(chunk);
      } catch (error) {
        reader.free();
        throw error;
      }
      return new Clip(reader.finish());
    });
  }

  /** Returns frames, rate, joints, roles, units and the notices of the reader. */
  info(): ClipInfo {
    return rethrow(() => this.inner.info());
  }

  /** Returns joint positions: frames (or one rest pose) × joints × 3, in metres, Y up. */
  positions(): Float32Array {
    return this.inner.positions();
  }

  /**
   * Overrides the rate, the up axis, the metres per unit or the roles of joints.
   * Replaces all earlier overrides; absent fields stay as detected.
   */
  override(overrides: Overrides): void {
    rethrow(() => this.inner.override(overrides));
  }

  /**
   * Detects when each foot is planted. Absent options have the defaults of the core.
   *
   * @throws PlantigradeError If the clip has no motion or no feet.
   */
  detect(options: DetectOptions = {}): Plants {
    return rethrow(() => new Plants(this.inner, this.inner.detect(options)));
  }

  /**
   * Segments the motion into actions. Absent options have the defaults of the core.
   *
   * @param onProgress Receives the completed fraction, 0 to 1.
   */
  segment(
    options: SegmentOptions = {},
    onProgress: (fraction: number) => void = () => {},
  ): Segmentation {
    return rethrow(() => new Segmentation(this.inner, this.inner.segment(options, onProgress)));
  }

  free(): void {
    this.inner.free();
  }

  [Symbol.dispose](): void {
    this.free();
  }
}

/** The plants of a clip. Requires that the clip is not freed. */
export class Plants {
  /** @internal */
  constructor(
    private readonly clip: WasmClip,
    private readonly inner: WasmDetection,
  ) {}

  /** Labelled parts, the principal part first. */
  get parts(): Part[] {
    return this.inner.parts() as Part[];
  }

  /** Height of the ground in the positions of the clip, in metres. */
  get floor(): number {
    return this.inner.floor;
  }

  /** Ground on which the feet stand: plane, levels and belt. */
  get ground(): GroundInfo {
    return rethrow(() => this.inner.ground());
  }

  /** Noise of planted feet; undefined if no foot is planted. */
  get noise(): NoiseInfo | undefined {
    return rethrow(() => this.inner.noise());
  }

  /** Assumptions and doubts of the method. */
  get notices(): NoticeInfo[] {
    return rethrow(() => this.inner.notices());
  }

  /** Returns labels per frame: 1 planted, 0 not planted. */
  planted(part: Part, side: Side): Uint8Array {
    return rethrow(() => this.inner.planted(part, side));
  }

  /** Returns the probability that the label is correct, per frame, 0.5 to 1. */
  confidence(part: Part, side: Side): Float32Array {
    return rethrow(() => this.inner.confidence(part, side));
  }

  /** Returns plants as half-open frame ranges: start, end, start, end, …. */
  intervals(part: Part, side: Side): Uint32Array {
    return rethrow(() => this.inner.intervals(part, side));
  }

  /**
   * Returns the instants of each plant: time of the foot strike, its uncertainty (standard deviation),
   * time of the foot off, its uncertainty, in seconds; NaN where an instant is known to the frame only.
   */
  instants(part: Part, side: Side): Float64Array {
    return rethrow(() => this.inner.instants(part, side));
  }

  /** Applies edits, replacing earlier ones; later entries take precedence. */
  edit(edits: EditInfo[]): void {
    rethrow(() => this.inner.edit(edits));
  }

  /**
   * Returns the changes by which edits apply to similar motion, and the number of plants that they change. Add
   * the changes to the edits, and pass all to `edit`, to accept them.
   */
  similar(edits: EditInfo[]): SimilarInfo {
    return rethrow(() => this.clip.similar(this.inner, edits));
  }

  /**
   * Returns gait measures with edits applied: cadence, times, lengths, symmetry, `steps`, and `curves` of
   * joint angles over the gait cycle.
   *
   * @param frames Ranges of frames to which the measures are limited: start, end, start, end, …. Default:
   *   the whole clip.
   */
  gait(frames?: number[]): GaitInfo {
    return rethrow(() => this.clip.gait(this.inner, frames));
  }

  /**
   * Returns the gait as a file.
   *
   * @param format Name of one of the `gaitFormats()`.
   * @param name File name of the clip.
   * @param actions Actions to measure separately. Default: none, for the whole clip.
   * @param sha256 Hash of the bytes of the clip, if known.
   */
  saveGait(format: string, name: string, actions: ActionInfo[] = [], sha256?: string): string {
    return rethrow(() => this.clip.saveGait(this.inner, actions, format, name, sha256));
  }

  /**
   * Returns a printable page in HTML with figures, plots, steps and definitions; see `saveGait`. It contains
   * neither scripts nor references to other files.
   */
  gaitReport(name: string, actions: ActionInfo[] = [], sha256?: string): string {
    return this.saveGait("report", name, actions, sha256);
  }

  /** Returns the slide of each plant: those of the left foot, then those of the right. */
  skate(): SlideInfo[] {
    return rethrow(() => this.clip.skate(this.inner));
  }

  /**
   * Returns the clip without foot skate, as the bytes of a BVH file: those of the file of the clip,
   * except for the numbers that differ.
   *
   * @param file The bytes that `Clip.read` was given, or chunks of them.
   * @param keepSpikes If true, spikes of the hips, short jumps away and back, are not interpolated;
   *   default false.
   * @param only If not empty, only plants that overlap one of these ranges are corrected.
   * @throws PlantigradeError If the file is shorter than the one that was read.
   */
  clean(
    file: Uint8Array | Iterable<Uint8Array>,
    keepSpikes = false,
    only: FootFrames[] = [],
  ): Uint8Array {
    return rethrow(() => {
      const cleaned = this.clip.clean(this.inner, keepSpikes, only);
      const rewriter = cleaned.rewriter();
      cleaned.free();
      const written: Uint8Array[] = [];
      try {
        for (const chunk of file instanceof Uint8Array ? [file] : file) {
          written.push(rewriter.push(chunk));
        }
      } catch (error) {
        rewriter.free();
        throw error;
      }
      written.push(rewriter.finish());
      return concatenate(written);
    });
  }

  /**
   * Returns the labels as a file.
   *
   * @param format Name of one of the `plantFormats()`.
   * @param name File name of the clip.
   * @param sha256 Hash of the bytes of the clip, if known.
   */
  save(format: string, name: string, sha256?: string): Uint8Array {
    return rethrow(() => this.clip.save(this.inner, format, name, sha256));
  }

  free(): void {
    this.inner.free();
  }

  [Symbol.dispose](): void {
    this.free();
  }
}

/** The segments of a clip. Requires that the clip is not freed. */
export class Segmentation {
  /** @internal */
  constructor(
    private readonly clip: WasmClip,
    private readonly inner: WasmSegmentation,
  ) {}

  /** The segments in order; they cover the clip without gaps. */
  get segments(): SegmentInfo[] {
    return rethrow(() => this.inner.segments());
  }

  /** Assumptions and doubts of the method. */
  get notices(): NoticeInfo[] {
    return rethrow(() => this.inner.notices());
  }

  /**
   * Applies edits of the cuts to the segments of the method, replacing earlier edits. Later entries take
   * precedence.
   */
  editCuts(edits: CutEditInfo[]): void {
    rethrow(() => this.inner.editCuts(edits));
  }

  /**
   * Returns the segments as a file.
   *
   * @param format Name of one of the `segmentFormats()`.
   * @param name File name of the clip.
   * @param labels Labels of the segments in order. Default: those of the method.
   */
  save(format: string, name: string, labels?: string[]): Uint8Array {
    const given = labels ?? this.segments.map(({ label }) => label);
    return rethrow(() => this.clip.saveSegments(this.inner, given, [], format, name));
  }

  free(): void {
    this.inner.free();
  }

  [Symbol.dispose](): void {
    this.free();
  }
}

function concatenate(chunks: readonly Uint8Array[]): Uint8Array {
  const bytes = new Uint8Array(chunks.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const chunk of chunks) {
    bytes.set(chunk, at);
    at += chunk.length;
  }
  return bytes;
}

/** Runs a call to the core and rethrows its failures, which are plain objects, as errors. */
function rethrow<T>(call: () => T): T {
  try {
    return call();
  } catch (error) {
    if (error instanceof Error) throw error;
    throw new PlantigradeError(error as Failure);
  }
}
