/** The open clip and all state that belongs to it. */

import { batch, type Signal, signal } from "@preact/signals";
import type { StoredChanges } from "../model/batch/batch";
import { clampView, type TimeView } from "../model/motion/time-view";
import type { Video } from "../model/motion/video";
import type { FrameRange, PlantRef } from "../model/plants/edits";
import { type AnyEdit, haveSamePlantEdits } from "../model/segments/cut-edits";
import type { NamedSegment, SegmentName } from "../model/segments/segments";
import type { Source } from "../model/sources/source";
import type { UnreadableRecord } from "../model/stored/stored-changes";
import type {
  Annotation,
  CleanedClip,
  Clip,
  CutScore,
  Detection,
  Evidence,
  Failure,
  FootFrames,
  Gait,
  Overrides,
  Part,
  Score,
  SegmentAnnotation,
  Segmentation,
  Side,
  Similar,
  Slide,
} from "../model/types";

/** What playback repeats; a range is chosen by the user. */
export type Loop = "off" | "clip" | "plant" | "segment" | "range";

/** Version of a cleaned clip that the viewer shows. */
export type CleanedView = "before" | "after" | "both";

/** A clean-up and the clip, labels and overrides from which it was computed. */
export interface CleanUp {
  clip: Clip;
  detection: Detection;
  overrides: Overrides;
  /** True if spikes of the hips were not repaired. */
  keepSpikes: boolean;
  /** Frames of the corrected plants; empty for all. */
  only: FootFrames[];
  cleaned: CleanedClip;
  view: CleanedView;
}

/** A frame under the pointer or selected by a key in a plot. */
export interface PointedFrame {
  frame: number;
  /** The foot whose point it is; absent if the timeline is pointed at. */
  side?: Side;
}

interface Start {
  /** True for the decorative preview of the start page. */
  isPreview?: boolean;
  overrides?: Overrides;
  /** First shown moment, in frames. */
  playhead?: number;
  loop?: Loop;
}

/**
 * State of one open clip. Opening another clip replaces the session as a whole:
 * no field has to be reset, and results requested by an older session are dropped.
 */
export class ClipSession {
  readonly source: Source | null;
  readonly isPreview: boolean;

  /** The clip as read with the current overrides; null before the first clip is read. */
  readonly clip: Signal<Clip | null>;
  readonly overrides: Signal<Overrides>;

  /** The detected plants with edits applied; null while there are none. */
  readonly detection = signal<Detection | null>(null);
  readonly detectFailure = signal<Failure | null>(null);

  readonly segmentation = signal<Segmentation | null>(null);
  readonly segmentFailure = signal<Failure | null>(null);
  /** Names given by the user; they survive a change of the segmentation. */
  readonly segmentNames = signal<readonly SegmentName[]>([]);
  /** The selected cut: the first frame of its segment. */
  readonly selectedCut = signal<number | null>(null);
  /** Frame of the selected cut if the current drag ended now. */
  readonly cutPreview = signal<number | null>(null);
  /** The segment whose name field should receive the focus. */
  readonly renamedSegment = signal<NamedSegment | null>(null);

  /** Edits of the labels and of the cuts, in order. */
  readonly edits = signal<readonly AnyEdit[]>([]);
  /** Earlier and undone lists of edits; the newest is last. */
  readonly undoStack = signal<readonly (readonly AnyEdit[])[]>([]);
  readonly redoStack = signal<readonly (readonly AnyEdit[])[]>([]);
  /** Changes by which the edits apply to similar motion; null if none are offered. */
  readonly similar = signal<Similar | null>(null);
  /** The edits whose changes of similar motion the user has applied or declined. */
  readonly similarSettledFor = signal<readonly AnyEdit[] | null>(null);
  /** The plant that is being edited. */
  readonly selected = signal<PlantRef | null>(null);
  /** The edge of the selected plant that keys move; null for the one nearest to the playhead. */
  readonly selectedEdge = signal<"start" | "end" | null>(null);
  /** The track to which a plant is added: the one that was used last. */
  readonly addTarget = signal<{ side: Side; part: Part } | null>(null);
  /** Range that the selected plant would have if the current drag ended now. */
  readonly dragPreview = signal<FrameRange | null>(null);
  /** Local storage key of the edits; undefined until the hash of the file is known. */
  readonly storageKey = signal<string | undefined>(undefined);
  /** Reason why edits cannot be stored; empty if they can. */
  readonly persistError = signal("");
  /** Stored records of this clip that cannot be read. */
  readonly unreadable = signal<readonly UnreadableRecord[]>([]);
  /** Set when another page has changed the edits; `remote` if both changed the same plants. */
  readonly changedElsewhere = signal<{ remote?: StoredChanges } | null>(null);

  /** Labels that the detection is compared with. */
  readonly reference = signal<Annotation | null>(null);
  /** Agreement with the reference, for each part that both label. */
  readonly scores = signal<readonly Score[]>([]);
  /** The part whose agreement was chosen for display. */
  readonly scorePart = signal<Part | null>(null);
  /** Segments that the segmentation is compared with. */
  readonly referenceSegments = signal<SegmentAnnotation | null>(null);
  readonly cutScores = signal<readonly CutScore[]>([]);

  readonly cleanUp = signal<CleanUp | null>(null);
  readonly cleaning = signal(false);
  /** Slide of every plant; empty until measured. */
  readonly slides = signal<readonly Slide[]>([]);
  /** Gait measures; undefined until measured. */
  readonly gait = signal<Gait | undefined>(undefined);
  /** Name of the action whose gait is measured; null for the whole clip. */
  readonly gaitAction = signal<string | null>(null);

  /** The video next to the clip. */
  readonly video = signal<Video | null>(null);

  /** Evidence for the labels of one part; null until the evidence tab is open. */
  readonly evidence = signal<Evidence | null>(null);
  readonly pointedFrame = signal<PointedFrame | null>(null);

  /** Current moment, in frames; fractional while playing. */
  readonly playhead: Signal<number>;
  /** The part of the clip that the timeline shows. */
  readonly timeView: Signal<TimeView>;
  readonly loop: Signal<Loop>;
  /** Frames of the looped plant, segment or range, half-open. */
  readonly loopRegion = signal<TimeView | null>(null);

  private readonly controller = new AbortController();
  private readonly newest = new Map<string, symbol>();
  /** Fulfilled when the edits so far are in the labels. */
  private edited: Promise<unknown> = Promise.resolve();
  /** Number of edits that have not begun or ended. */
  private pending = 0;

  constructor(clip: Clip | null, source: Source | null, start: Start = {}) {
    const { isPreview = false, overrides = {}, playhead = 0, loop = "clip" } = start;
    const frames = clip?.frames ?? 1;
    this.source = source;
    this.isPreview = isPreview;
    this.clip = signal(clip);
    this.overrides = signal(overrides);
    this.playhead = signal(Math.min(playhead, Math.max(0, frames - 1)));
    this.timeView = signal(
      clip ? clampView({ start: 0, end: frames }, frames) : { start: 0, end: 1 },
    );
    this.loop = signal(loop);
  }

  /** True if the user has applied the present edits of plants to similar plants, or has declined to. */
  get isSimilarSettled(): boolean {
    const settled = this.similarSettledFor.value;
    return settled !== null && haveSamePlantEdits(settled, this.edits.value);
  }

  /** Aborts when another clip replaces this one. */
  get signal(): AbortSignal {
    return this.controller.signal;
  }

  close() {
    this.controller.abort();
  }

  /**
   * Awaits a call made for this clip. Returns undefined, also if the call failed, once another
   * clip is open or a newer call with the same name was made.
   */
  async run<T>(name: string, call: () => Promise<T>): Promise<T | undefined> {
    const id = Symbol(name);
    this.newest.set(name, id);
    const isCurrent = () => !this.signal.aborted && this.newest.get(name) === id;
    try {
      const answer = await call();
      return isCurrent() ? answer : undefined;
    } catch (error) {
      if (isCurrent()) throw error;
      return undefined;
    }
  }

  /** Runs an edit after those before it, unless another clip is open by then. Rejects if the edit does. */
  inOrder(edit: () => unknown): Promise<void> {
    this.pending++;
    const done = this.edited
      .then(async () => {
        if (!this.signal.aborted) await edit();
      })
      .finally(() => this.pending--);
    this.delayEdits(done);
    return done;
  }

  /** Number of edits that are lost if another clip replaces this one now. */
  get pendingEdits(): number {
    return this.pending;
  }

  /** Resolves when all edits so far are applied or have failed. */
  editsDone(): Promise<unknown> {
    return this.edited;
  }

  /** Lets later edits wait for a change of the labels. */
  delayEdits(change: Promise<unknown>) {
    this.edited = Promise.allSettled([this.edited, change]);
  }

  /** Drops the result of the pending call with that name. */
  drop(name: string) {
    this.newest.delete(name);
  }
}

/** The open clip. The first session, without a clip, lasts until one is read. */
export const session = signal(new ClipSession(null, null, { isPreview: true }));

/** Replaces the open clip. */
export function openSession(next: ClipSession) {
  batch(() => {
    session.peek().close();
    session.value = next;
  });
}

/** A field of the open session that is read and written like a signal. */
export interface SessionField<T> {
  value: T;
  peek(): T;
}

/** Returns a view of one signal of the open session, whichever session that is. */
export function sessionField<T>(select: (session: ClipSession) => Signal<T>): SessionField<T> {
  return {
    get value() {
      return select(session.value).value;
    },
    set value(next: T) {
      select(session.peek()).value = next;
    },
    peek: () => select(session.peek()).peek(),
  };
}
