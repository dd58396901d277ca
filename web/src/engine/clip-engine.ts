/** The page's side of the clip worker: starts it, stops it, and replaces it when it fails. */

import * as Comlink from "comlink";
import { failureOf, isFatal } from "../model/failure";
import type {
  DetectOptions,
  Edit,
  Failure,
  OnProgress,
  Overrides,
  SegmentOptions,
} from "../model/types";
import type { ClipApi, Compared, Detected, Opened, Segmented } from "../workers/clip.worker";
import { startClipWorker } from "./start-workers";
import { type CallsOf, type WorkerHandle, wrapWasmWorker } from "./worker-handle";

/** Options of any call. An aborted call ends the worker; other pending calls are repeated. */
export interface CallOptions {
  signal?: AbortSignal;
  onProgress?: OnProgress;
}

export interface OpenOptions extends CallOptions {
  /** Replace values that are not numbers by those of the previous frame. */
  lenient?: boolean;
  /** Applied to the clip when it is read. */
  overrides?: Overrides;
}

/** A clip, with the failure of its overrides if they were not applied. */
export type OpenedWith = Opened & { rejected?: Failure };

type Calls = Omit<CallsOf<ClipApi>, "startWasm" | "startSecondModule" | "holdLock">;

/** Calls that change the state to restore in a new worker; they are implemented individually. */
type StatefulCall = "open" | "override" | "detect" | "segment" | "compare" | "edit";
type SimpleCalls = Omit<Calls, StatefulCall>;

/** The arguments of a call without its progress callback. */
type ArgsOf<Call extends (...args: never[]) => unknown> =
  Required<Parameters<Call>> extends [...infer Args, OnProgress] ? Args : Parameters<Call>;

/** A call of the worker as the page makes it: with `CallOptions` in place of a callback. */
type EngineCall<Call extends (...args: never[]) => unknown> = (
  ...args: [...ArgsOf<Call>, options?: CallOptions]
) => ReturnType<Call>;

/** The calls of the clip worker, and `cancel`. */
export type ClipEngine = { [Name in keyof SimpleCalls]: EngineCall<SimpleCalls[Name]> } & {
  /** Starts the worker before the first call. */
  start(): void;
  /** Opens a clip. Calls for the previous one wait for it, and are cancelled if it succeeds. */
  open(file: Blob, name: string, options?: OpenOptions): Promise<OpenedWith>;
  override(overrides: Overrides): Promise<Opened>;
  detect(options: DetectOptions, callOptions?: CallOptions): Promise<Detected>;
  segment(options: SegmentOptions, callOptions?: CallOptions): Promise<Segmented>;
  compare(file: Blob, name: string): Promise<Compared>;
  edit: Calls["edit"];
  /** Ends the worker and all pending calls; the next worker restores the open clip. */
  cancel(): void;
};

/** State that a call requires in the worker: none, the open clip, or also its segmentation. */
type Requirement = "worker" | "clip" | "segmentation";

/** For each call, its requirement and its number of arguments without the progress callback. */
const simpleCalls: {
  [Name in keyof SimpleCalls]: readonly [Requirement, ArgsOf<SimpleCalls[Name]>["length"]];
} = {
  methods: ["worker", 0],
  segmentMethods: ["worker", 0],
  plantFormats: ["worker", 0],
  segmentFormats: ["worker", 0],
  gaitFormats: ["worker", 0],
  hash: ["clip", 0],
  evidence: ["clip", 2],
  referenceEdits: ["clip", 0],
  similar: ["clip", 0],
  gait: ["clip", 1],
  saveGait: ["clip", 2],
  skate: ["clip", 0],
  clean: ["clip", 2],
  saveCleaned: ["clip", 2],
  score: ["clip", 0],
  save: ["clip", 1],
  cut: ["clip", 1],
  editCuts: ["segmentation", 1],
  scoreSegments: ["segmentation", 0],
  saveSegments: ["segmentation", 3],
};

/** The error of calls that were pending when the worker was ended. */
export class Cancelled extends Error {
  constructor(message = "Cancelled.") {
    super(message);
  }
}

/** The error of calls that were pending when another clip was opened. */
export class Superseded extends Cancelled {
  constructor() {
    super("Another clip was opened before that.");
  }
}

/** The worker was ended because another call was aborted. */
class Replaced extends Error {}

interface ReferenceFile {
  file: Blob;
  name: string;
}

/** Data from which a new worker restores the open clip. */
interface RestorePoint {
  file: Blob;
  name: string;
  lenient: boolean;
  overrides?: Overrides;
  edits?: Edit[];
  options?: DetectOptions;
  segmentOptions?: SegmentOptions;
  annotation?: ReferenceFile;
  segmentAnnotation?: ReferenceFile;
}

interface RunningWorker extends WorkerHandle<ClipApi> {
  /** Rejects when the worker is ended. */
  ended: Promise<never>;
  end: (reason: Error) => void;
  /** Settles when the worker has the open clip; undefined before that was requested. */
  restored?: Promise<unknown>;
  /** True while the clip of an earlier worker is restored. */
  isRestoring?: boolean;
  /** Settles when the worker has the segmentation, for which only some calls wait. */
  segmented?: Promise<unknown>;
}

/** Creates an engine; `start` starts a worker and reports its failure to `onBroken`. */
export function createEngine(
  start: (onBroken: (reason: Error) => void) => WorkerHandle<ClipApi> = startWorker,
): ClipEngine {
  let running: RunningWorker | undefined;
  let restorePoint: RestorePoint | undefined;

  function startedWorker(): RunningWorker {
    if (running) return running;
    let end: RunningWorker["end"] = () => {};
    const ended = new Promise<never>((_, reject) => {
      end = reject;
    });
    // Prevents an unhandled rejection if no call is pending.
    ended.catch(() => {});
    const handle = start((reason) => {
      if (running === worker) stop(reason);
    });
    const worker: RunningWorker = { ...handle, ended, end };
    running = worker;
    return worker;
  }

  function stop(reason: Error) {
    running?.stop();
    running?.end(reason);
    running = undefined;
  }

  async function restore(worker: RunningWorker) {
    worker.isRestoring = true;
    try {
      await restoreClip(worker.calls);
    } finally {
      worker.isRestoring = false;
    }
  }

  async function restoreClip(calls: Calls) {
    if (!restorePoint) return;
    const { file, name, lenient, overrides, edits, options } = restorePoint;
    const { annotation, segmentAnnotation } = restorePoint;
    await calls.open(file, name, lenient);
    if (overrides) await calls.override(overrides);
    if (edits) await calls.edit(edits);
    if (options) await calls.detect(options);
    if (annotation) await calls.compare(annotation.file, annotation.name);
    if (segmentAnnotation) await calls.compare(segmentAnnotation.file, segmentAnnotation.name);
  }

  async function restoreSegmentation(calls: Calls) {
    if (restorePoint?.segmentOptions) await calls.segment(restorePoint.segmentOptions);
  }

  /** Makes a call; a worker that breaks is replaced, and the call fails. */
  async function call<T>(
    run: (worker: RunningWorker) => Promise<T>,
    signal?: AbortSignal,
  ): Promise<T> {
    const worker = startedWorker();
    try {
      return await Promise.race([run(worker), worker.ended]);
    } catch (error) {
      if (signal?.aborted) throw new Cancelled();
      if (error instanceof Replaced) return call(run, signal);
      if (isFatal(error) && running === worker) stop(error);
      throw error;
    }
  }

  /** Makes a call after its requirement is met. */
  async function callWith<T>(
    requirement: Requirement,
    run: (calls: Calls, worker: RunningWorker, onProgress?: OnProgress) => Promise<T>,
    { signal, onProgress }: CallOptions = {},
  ): Promise<T> {
    if (signal?.aborted) throw new Cancelled();
    const target = restorePoint;
    const report = onProgress && Comlink.proxy(onProgress);
    const abort = () => stop(new Replaced());
    signal?.addEventListener("abort", abort);
    try {
      return await call(async (worker) => {
        if (requirement !== "worker") {
          worker.restored ??= restore(worker);
          await worker.restored;
          // The call is not for a clip that was opened after it.
          if (restorePoint !== target) throw new Superseded();
        }
        if (requirement === "segmentation") {
          worker.segmented ??= restoreSegmentation(worker.calls);
          await worker.segmented;
        }
        return run(worker.calls, worker, report);
      }, signal);
    } finally {
      signal?.removeEventListener("abort", abort);
    }
  }

  /** Opens a clip in a worker. If that fails, the worker has the previous clip. */
  async function openIn(
    worker: RunningWorker,
    file: Blob,
    name: string,
    { lenient = false, overrides }: OpenOptions,
    report?: OnProgress,
  ): Promise<OpenedWith> {
    const { calls, restored } = worker;
    const opening = (async (): Promise<OpenedWith> => {
      const opened = await calls.open(file, name, lenient, report);
      if (!opened.ok) return opened;
      const overridden = overrides && (await calls.override(overrides).catch(asFailureUnlessFatal));
      restorePoint = { file, name, lenient, ...(overridden?.ok && { overrides }) };
      worker.segmented = Promise.resolve();
      if (!overridden) return opened;
      return overridden.ok ? overridden : { ...opened, rejected: overridden.failure };
    })();
    // Calls for the previous clip would otherwise restore it during the opening, or apply to the new one.
    worker.restored = opening.then(
      ({ ok }) => (ok ? undefined : (restored ?? restore(worker))),
      () => restored ?? restore(worker),
    );
    worker.restored.catch(() => {});
    return opening;
  }

  /** Makes the page's side of the calls that have no state to restore, from their names. */
  function makeSimpleCalls() {
    const entries = Object.entries(simpleCalls).map(([name, [requirement, count]]) => {
      const engineCall = (...args: unknown[]) =>
        callWith(
          requirement,
          (calls, _, report) => {
            const method = calls[name as keyof SimpleCalls] as (
              ...values: unknown[]
            ) => Promise<unknown>;
            return method(...args.slice(0, count), ...(report ? [report] : []));
          },
          args[count] as CallOptions | undefined,
        );
      return [name, engineCall];
    });
    return Object.fromEntries(entries) as {
      [Name in keyof SimpleCalls]: EngineCall<SimpleCalls[Name]>;
    };
  }

  return {
    ...makeSimpleCalls(),
    start() {
      startedWorker();
    },
    async open(file, name, options = {}) {
      // The previous clip is no longer needed, and would be read at the same time.
      if (running?.isRestoring) stop(new Replaced());
      const opened: OpenedWith = await callWith(
        "worker",
        (_, worker, report) => openIn(worker, file, name, options, report),
        options,
      ).catch(asFailure);
      return opened;
    },
    async override(overrides) {
      const target = restorePoint;
      const opened: Opened = await callWith("clip", (calls) => calls.override(overrides)).catch(
        asFailure,
      );
      if (opened.ok && target) target.overrides = overrides;
      return opened;
    },
    async detect(options, callOptions) {
      const target = restorePoint;
      const detected: Detected = await callWith(
        "clip",
        (calls) => calls.detect(options),
        callOptions,
      ).catch(asFailure);
      if (detected.ok && target) target.options = options;
      return detected;
    },
    segment(options, callOptions) {
      const target = restorePoint;
      return callWith(
        "clip",
        async (calls, worker, report) => {
          const answer = calls.segment(options, report);
          // Calls that need a segmentation wait for this one. Restoring the previous one during it
          // would end after it and replace it.
          worker.segmented ??= answer.then(
            ({ ok }) => (ok ? undefined : restoreSegmentation(calls)),
            () => {},
          );
          const segmented: Segmented = await answer;
          if (segmented.ok && target && restorePoint === target) {
            target.segmentOptions = options;
            worker.segmented = Promise.resolve();
          }
          return segmented;
        },
        callOptions,
      ).catch(asFailure);
    },
    async compare(file, name) {
      const target = restorePoint;
      const compared: Compared = await callWith("clip", (calls) => calls.compare(file, name)).catch(
        asFailure,
      );
      if (compared.ok && target) {
        const kind = "annotation" in compared ? "annotation" : "segmentAnnotation";
        target[kind] = { file, name };
      }
      return compared;
    },
    edit(edits) {
      // Stored before the call, so that the edits survive a worker that fails on it.
      if (restorePoint) restorePoint.edits = edits;
      return callWith("clip", (calls) => calls.edit(edits));
    },
    cancel: () => stop(new Cancelled()),
  };
}

function startWorker(onBroken: (reason: Error) => void): WorkerHandle<ClipApi> {
  return wrapWasmWorker<ClipApi>(startClipWorker(), onBroken);
}

/** Converts an internal error to a failure if the worker need not be replaced. */
function asFailureUnlessFatal(error: unknown) {
  if (isFatal(error)) throw error;
  return asFailure(error);
}

/** Converts an internal error to a failure; a cancelled call stays cancelled. */
function asFailure(error: unknown): { ok: false; failure: Failure } {
  if (error instanceof Cancelled) throw error;
  return { ok: false, failure: failureOf(error) };
}
