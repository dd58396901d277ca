/** The page's hold on the worker: starts it, ends it, and starts another when it fails. */

import * as Comlink from "comlink";
import { startClipWorker } from "./start";
import { type CallsOf, coreThread, isTrap, type Thread } from "./thread";
import type { Cleaned, DetectOptions, Edit, Gait, Overrides, SegmentOptions, Slide } from "./types";
import type { Api, Compared, CutPart, Detected, Opened, Segmented } from "./worker";

export type { Compared, CutPart, Detected, EditedParts, Opened, Segmented } from "./worker";

/** What the worker offers, with ways to stop it. */
export interface Engine
  extends Omit<
    Calls,
    "open" | "detect" | "segment" | "gait" | "skate" | "clean" | "saveCleaned" | "cut"
  > {
  /** Reads a clip and holds it in place of the one before. */
  open(file: Blob, name: string, options?: OpenOptions): Promise<Opened>;
  /** Labels the clip. */
  detect(options: DetectOptions, stoppable?: Stoppable): Promise<Detected>;
  /** Cuts the clip into actions. */
  segment(options: SegmentOptions, stoppable?: Stoppable): Promise<Segmented>;
  /** How the person walks. */
  gait(stoppable?: Stoppable): Promise<Gait | undefined>;
  /** How far every plant slides. */
  skate(stoppable?: Stoppable): Promise<Slide[]>;
  /** Holds the planted feet still. */
  clean(stoppable?: Stoppable): Promise<Cleaned>;
  /** Writes the clip as it was cleaned last. */
  saveCleaned(stoppable?: Stoppable): Promise<Blob>;
  /** Writes parts of the clip as files of their own into one zip archive. */
  cut(parts: readonly CutPart[], stoppable?: Stoppable): Promise<Blob>;
  /** Ends the worker and what it is doing; the clip opened before stays at hand. */
  cancel(): void;
}

export interface OpenOptions {
  /** Hold the previous frame's value where one is no number. */
  lenient?: boolean;
  /** Gets the share read so far, 0 … 1. */
  onProgress?: (share: number) => void;
}

/** Work that may take long: aborted, its worker ends, and what else that was asked is asked of the next one. */
export interface Stoppable {
  signal?: AbortSignal;
  /** Gets the share done so far, 0 … 1. */
  onProgress?: (share: number) => void;
}

type Calls = Omit<CallsOf<Api>, "start">;

/** What calls in flight fail with when the worker is ended. */
export class Cancelled extends Error {
  constructor() {
    super("Cancelled.");
  }
}

/** The worker was ended because of another call than this one. */
class Replaced extends Error {}

/** What the page shows: all that it takes to have it again. */
interface Held {
  file: Blob;
  name: string;
  lenient: boolean;
  overrides?: Overrides;
  edits?: Edit[];
  options?: DetectOptions;
  segmentOptions?: SegmentOptions;
  /** Labels and segments of someone else that it is compared with. */
  other?: Theirs;
  otherSegments?: Theirs;
}

interface Theirs {
  file: Blob;
  name: string;
}

interface Running extends Thread<Api> {
  /** Rejects when the worker is ended. */
  ended: Promise<never>;
  end: (reason: Error) => void;
  /** Settles when the worker holds what the page shows; absent as long as it does not. */
  restored?: Promise<unknown>;
  /** The same for the segments, which may take long to find again: only who needs them waits. */
  segmented?: Promise<unknown>;
}

/** An engine on workers that `start` gives; `onBroken` is told of one that fails by itself. */
export function createEngine(
  start: (onBroken: (reason: Error) => void) => Thread<Api> = startWorker,
): Engine {
  let running: Running | undefined;
  /** What a new worker has to be told to be where the old one was. */
  let held: Held | undefined;

  function started(): Running {
    if (running) return running;
    let end: Running["end"] = () => {};
    const ended = new Promise<never>((_, reject) => {
      end = reject;
    });
    // Nobody may be waiting when it ends.
    ended.catch(() => {});
    const worker = start((reason) => {
      if (running === here) stop(reason);
    });
    const here: Running = { ...worker, ended, end };
    running = here;
    return here;
  }

  function stop(reason: Error) {
    running?.stop();
    running?.end(reason);
    running = undefined;
  }

  async function restore(calls: Calls) {
    if (!held) return;
    await calls.open(held.file, held.name, held.lenient);
    if (held.overrides) await calls.override(held.overrides);
    if (held.edits) await calls.edit(held.edits);
    if (held.options) await calls.detect(held.options);
    if (held.other) await calls.compare(held.other.file, held.other.name);
    if (held.otherSegments) await calls.compare(held.otherSegments.file, held.otherSegments.name);
  }

  async function resegment(calls: Calls) {
    if (held?.segmentOptions) await calls.segment(held.segmentOptions);
  }

  /** Runs one call; if the worker breaks, it is replaced, and the call fails with a reason. */
  async function call<T>(work: (here: Running) => Promise<T>, signal?: AbortSignal): Promise<T> {
    const here = started();
    try {
      return await Promise.race([work(here), here.ended]);
    } catch (error) {
      if (signal?.aborted) throw new Cancelled();
      if (error instanceof Replaced) return call(work, signal);
      if (isTrap(error) && running === here) stop(error as Error);
      throw error;
    }
  }

  /** Runs a call on the clip that the page shows, which a new worker has to open first. */
  function callOnClip<T>(
    work: (calls: Calls, here: Running) => Promise<T>,
    signal?: AbortSignal,
  ): Promise<T> {
    return call(async (here) => {
      here.restored ??= restore(here.calls);
      await here.restored;
      return work(here.calls, here);
    }, signal);
  }

  /** Runs a call on its segments. */
  function callOnSegments<T>(work: (calls: Calls) => Promise<T>): Promise<T> {
    return callOnClip(async (calls, here) => {
      here.segmented ??= resegment(calls);
      await here.segmented;
      return work(calls);
    });
  }

  /** Runs a call on the clip that may be aborted. */
  async function callStoppable<T>(
    work: (calls: Calls, here: Running, report?: (share: number) => void) => Promise<T>,
    { signal, onProgress }: Stoppable = {},
  ): Promise<T> {
    if (signal?.aborted) throw new Cancelled();
    const report = onProgress && Comlink.proxy(onProgress);
    const abort = () => stop(new Replaced());
    signal?.addEventListener("abort", abort);
    try {
      return await callOnClip((calls, here) => work(calls, here, report), signal);
    } finally {
      signal?.removeEventListener("abort", abort);
    }
  }

  started();
  return {
    async open(file, name, { lenient = false, onProgress } = {}) {
      const report = onProgress && Comlink.proxy(onProgress);
      const opened: Opened = await call(async (here) => {
        const opened = await here.calls.open(file, name, lenient, report);
        if (opened.ok) {
          held = { file, name, lenient };
          here.restored = Promise.resolve();
          here.segmented = Promise.resolve();
        }
        return opened;
      }).catch(broken);
      return opened;
    },
    async override(overrides) {
      const opened: Opened = await callOnClip((calls) => calls.override(overrides)).catch(broken);
      if (opened.ok && held) held.overrides = overrides;
      return opened;
    },
    async detect(options, stoppable) {
      const detected: Detected = await callStoppable(
        (calls) => calls.detect(options),
        stoppable,
      ).catch(broken);
      if (detected.ok && held) held.options = options;
      return detected;
    },
    segment(options, stoppable) {
      return callStoppable(async (calls, here, report) => {
        const found = calls.segment(options, report);
        // Those before, found again by who saves meanwhile, would come after these and stay.
        here.segmented ??= found.then(
          ({ ok }) => (ok ? undefined : resegment(calls)),
          () => {},
        );
        const segmented = await found;
        if (segmented.ok && held) {
          held.segmentOptions = options;
          here.segmented = Promise.resolve();
        }
        return segmented;
      }, stoppable).catch(broken);
    },
    async compare(file, name) {
      const compared: Compared = await callOnClip((calls) => calls.compare(file, name)).catch(
        broken,
      );
      if (compared.ok && held) {
        held["other" in compared ? "other" : "otherSegments"] = { file, name };
      }
      return compared;
    },
    edit(edits) {
      // First of all remembered: a worker that fails over it must not take it along.
      if (held) held.edits = edits;
      return callOnClip((calls) => calls.edit(edits));
    },
    theirs: () => callOnClip((calls) => calls.theirs()),
    why: (part, reach) => callOnClip((calls) => calls.why(part, reach)),
    hash: () => callOnClip((calls) => calls.hash()),
    methods: () => call(({ calls }) => calls.methods()),
    segmentMethods: () => call(({ calls }) => calls.segmentMethods()),
    gait: (stoppable) => callStoppable((calls) => calls.gait(), stoppable),
    skate: (stoppable) => callStoppable((calls) => calls.skate(), stoppable),
    clean: (stoppable) => callStoppable((calls) => calls.clean(), stoppable),
    saveCleaned: (stoppable) => callStoppable((calls) => calls.saveCleaned(), stoppable),
    score: () => callOnClip((calls) => calls.score()),
    scoreSegments: () => callOnSegments((calls) => calls.scoreSegments()),
    save: (format) => callOnClip((calls) => calls.save(format)),
    saveSegments: (format, names) => callOnSegments((calls) => calls.saveSegments(format, names)),
    cut: (parts, stoppable) =>
      callStoppable((calls, _, report) => calls.cut(parts, report), stoppable),
    cancel: () => stop(new Cancelled()),
  };
}

function startWorker(onBroken: (reason: Error) => void): Thread<Api> {
  return coreThread<Api>(startClipWorker(), onBroken);
}

/** A fault of the program, told as a failure; a cancelled call stays cancelled. */
function broken(error: unknown): { ok: false; failure: { message: string; hint: string } } {
  if (error instanceof Cancelled) throw error;
  const reason = error instanceof Error ? error.message : String(error);
  return {
    ok: false,
    failure: {
      message: `the program failed on this clip (${reason})`,
      hint: "Nothing else is affected. Please report it, with the file if you may share it.",
    },
  };
}
