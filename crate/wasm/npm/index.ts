/**
 * Foot plants in motion capture.
 *
 * Positions are metres, Y up; times are seconds; frames count from 0 and stretches of them are
 * half-open. Whatever holds memory of the module has `free()`, and is freed by `using` too.
 */

import load, {
  type ClipFacts,
  type DetectOptions,
  type EditFacts,
  type Failure,
  type GaitFacts,
  methods as listMethods,
  segmentMethods as listSegmentMethods,
  type MethodFacts,
  type NoticeText,
  type Overrides,
  type RawClip,
  type RawDetection,
  RawReader,
  type RawSegmentation,
  type SegmentFacts,
  type SegmentMethodFacts,
  type SegmentOptions,
  type SlideFacts,
} from "./plantigrade.js";

export type {
  ClipFacts,
  DetectOptions,
  EditFacts,
  GaitFacts,
  MethodFacts,
  NoticeText,
  Overrides,
  SegmentFacts,
  SegmentMethodFacts,
  SegmentOptions,
  SlideFacts,
};

export type Side = "left" | "right";
export type Part = "contact" | "toe" | "heel";
/** A document, tables per frame, plant and gait event, arrays for NumPy, or a script for Blender. */
export type LabelFormat = "json" | "csv" | "intervals" | "events" | "npz" | "blender";
export type SegmentFormat = "json" | "csv" | "babel";

/** Why something cannot be done; `line`, `column` and `hint` where there are any. */
export class PlantigradeError extends Error {
  override name = "PlantigradeError";
  constructor(readonly failure: Failure) {
    super(failure.message);
  }
}

let loading: Promise<unknown> | undefined;

/**
 * Loads the module; everything else waits for it. `source` is where it is to be had from:
 * an address, a response, its bytes or the compiled module; without, the file that comes with
 * the package.
 */
export function init(source?: Parameters<typeof load>[0]): Promise<void> {
  loading ??= (source === undefined ? own() : Promise.resolve(source)).then((from) =>
    load({ module_or_path: from as WebAssembly.Module }),
  );
  return loading.then(() => {});
}

/** Node cannot fetch a file. */
async function own(): Promise<URL | BufferSource> {
  const address = new URL("./plantigrade_bg.wasm", import.meta.url);
  if (address.protocol !== "file:") return address;
  const { readFile } = await import("node:fs/promises");
  return readFile(address);
}

/** All methods of detection, the default first. */
export const methods = (): MethodFacts[] => attempt(listMethods);

/** All methods of segmentation, the default first. */
export const segmentMethods = (): SegmentMethodFacts[] => attempt(listSegmentMethods);

/** A clip of motion capture. */
export class Clip {
  private constructor(private readonly raw: RawClip) {}

  /**
   * Reads a BVH file from its bytes, or from the chunks of them.
   *
   * @param lenient Hold the previous frame's value where one is no number. Default false.
   * @throws PlantigradeError If it cannot be read.
   */
  static read(bytes: Uint8Array | Iterable<Uint8Array>, lenient = false): Clip {
    const chunks = bytes instanceof Uint8Array ? [bytes] : [...bytes];
    const total = chunks.reduce((sum, { length }) => sum + length, 0);
    return attempt(() => {
      const reader = new RawReader(lenient, total);
      try {
        for (const chunk of chunks) reader.push(chunk);
      } catch (refusal) {
        reader.free();
        throw refusal;
      }
      return new Clip(reader.finish());
    });
  }

  /** Frames, rate, joints, which of them are feet, the reader's notices. */
  facts(): ClipFacts {
    return attempt(() => this.raw.facts());
  }

  /** All poses: frames (or one rest pose) × joints × 3, in metres, Y up. */
  positions(): Float32Array {
    return this.raw.positions();
  }

  /**
   * Reads the clip in another way: its rate, its up axis, its metres per unit, which joint is which.
   * In place of what was overridden before; nothing given is as found.
   */
  override(overrides: Overrides): void {
    attempt(() => this.raw.override(overrides));
  }

  /**
   * Finds when each foot is planted. Default: method `robust`, r 0.001, w 1.
   *
   * @throws PlantigradeError If there is no motion, or there are no feet.
   */
  detect(options: Partial<DetectOptions> = {}): Plants {
    const asked = { method: "robust", r: 0.001, w: 1, ...options };
    return attempt(() => new Plants(this.raw, this.raw.detect(asked)));
  }

  /** Cuts the motion into actions. Default: method `auto`. `onProgress` gets the share done, 0 … 1. */
  segment(
    options: Partial<SegmentOptions> = {},
    onProgress: (share: number) => void = () => {},
  ): Segmentation {
    const asked = { method: "auto", ...options };
    return attempt(() => new Segmentation(this.raw, this.raw.segment(asked, onProgress)));
  }

  free(): void {
    this.raw.free();
  }

  [Symbol.dispose](): void {
    this.free();
  }
}

/** The plants of a clip; it needs the clip as long as it is used. */
export class Plants {
  /** @internal */
  constructor(
    private readonly clip: RawClip,
    private readonly raw: RawDetection,
  ) {}

  /** The parts that are labelled, the one that says best when a foot is down first. */
  get parts(): Part[] {
    return this.raw.parts() as Part[];
  }

  /** Height of the ground in the clip's positions, in metres. */
  get floor(): number {
    return this.raw.floor;
  }

  /** What was assumed or is doubtful. */
  get notices(): NoticeText[] {
    return attempt(() => this.raw.notices());
  }

  /** 1 where the part of the foot is planted, per frame. */
  planted(part: Part, side: Side): Uint8Array {
    return attempt(() => this.raw.planted(part, side));
  }

  /** Probability that the label is right, per frame, 0.5 … 1. */
  confidence(part: Part, side: Side): Float32Array {
    return attempt(() => this.raw.confidence(part, side));
  }

  /** Plants as frames: start, end, start, end …; half-open. */
  intervals(part: Part, side: Side): Uint32Array {
    return attempt(() => this.raw.intervals(part, side));
  }

  /** Lays a person's edits over what was found, in place of those before; later ones count more. */
  edit(edits: EditFacts[]): void {
    attempt(() => this.raw.edit(edits));
  }

  /** How the person walks: cadence, times, lengths, symmetry. */
  gait(): GaitFacts {
    return attempt(() => this.clip.gait(this.raw));
  }

  /** How far each plant slides, in metres: the left foot's, then the right's. */
  skate(): SlideFacts[] {
    return attempt(() => this.clip.skate(this.raw));
  }

  /** The clip with its planted feet held still, as a BVH file. */
  clean(): string {
    return attempt(() => {
      const cleaned = this.clip.clean(this.raw);
      try {
        return new TextDecoder().decode(cleaned.bvh());
      } finally {
        cleaned.free();
      }
    });
  }

  /** The labels as a file; `name` is that of the clip's, `sha256` of its bytes where it is known. */
  save(format: LabelFormat, name: string, sha256?: string): Uint8Array {
    return attempt(() => this.clip.save(this.raw, format, name, sha256));
  }

  free(): void {
    this.raw.free();
  }

  [Symbol.dispose](): void {
    this.free();
  }
}

/** The actions of a clip; it needs the clip as long as it is used. */
export class Segmentation {
  /** @internal */
  constructor(
    private readonly clip: RawClip,
    private readonly raw: RawSegmentation,
  ) {}

  /** The actions in order; they tile the clip. */
  get segments(): SegmentFacts[] {
    return attempt(() => this.raw.segments());
  }

  /** What was assumed or is doubtful. */
  get notices(): NoticeText[] {
    return attempt(() => this.raw.notices());
  }

  /** The actions as a file, under `names` in their order; without, under the method's own. */
  save(format: SegmentFormat, name: string, names?: string[]): string {
    const shown = names ?? this.segments.map(({ label }) => label);
    return attempt(() => this.clip.saveSegments(this.raw, shown, format, name));
  }

  free(): void {
    this.raw.free();
  }

  [Symbol.dispose](): void {
    this.free();
  }
}

/** What the core refuses comes as a plain object: here it is an error. */
function attempt<T>(work: () => T): T {
  try {
    return work();
  } catch (refusal) {
    if (refusal instanceof Error) throw refusal;
    throw new PlantigradeError(refusal as Failure);
  }
}
