/** The page's hold on the worker: starts it, ends it, and starts another when it fails. */

import * as Comlink from "comlink";
import type { Overrides } from "./types";
import type { Api, Compared, Detected, Opened } from "./worker";

export type { Compared, Detected, Opened } from "./worker";

/** What the worker offers, with a way to stop it. */
export interface Engine extends Omit<Calls, "open"> {
  /** Reads a clip and holds it in place of the one before. */
  open(file: Blob, name: string, options?: OpenOptions): Promise<Opened>;
  /** Ends the worker and what it is doing; the clip opened before stays at hand. */
  cancel(): void;
}

export interface OpenOptions {
  /** Hold the previous frame's value where one is no number. */
  lenient?: boolean;
  /** Gets the share read so far, 0 … 1. */
  onProgress?: (share: number) => void;
}

type Calls = {
  [Call in keyof Api]: (...args: Parameters<Api[Call]>) => ReturnType<Api[Call]>;
};

/** What calls in flight fail with when the worker is ended. */
export class Cancelled extends Error {
  constructor() {
    super("Cancelled.");
  }
}

interface Running {
  worker: Worker;
  api: Calls;
  /** Rejects when the worker is ended. */
  ended: Promise<never>;
  end: (reason: Error) => void;
}

export function createEngine(): Engine {
  let running: Running | undefined;
  /** What a new worker has to be told to be where the old one was. */
  let held: { file: Blob; name: string; lenient: boolean; overrides?: Overrides } | undefined;

  async function started(restore: boolean): Promise<Running> {
    if (running) return running;
    running = start();
    const { api } = running;
    if (held && restore) {
      await api.open(held.file, held.name, held.lenient);
      if (held.overrides) await api.override(held.overrides);
    }
    return running;
  }

  function stop(reason: Error) {
    running?.worker.terminate();
    running?.end(reason);
    running = undefined;
  }

  /** Runs one call; if the worker breaks, it is replaced, and the call fails with a reason. */
  async function call<T>(work: (api: Calls) => Promise<T>, restore = true): Promise<T> {
    const here = await started(restore);
    try {
      return await Promise.race([work(here.api), here.ended]);
    } catch (error) {
      if (error instanceof WebAssembly.RuntimeError || isTrap(error)) stop(error as Error);
      throw error;
    }
  }

  running = start();
  return {
    async open(file, name, { lenient = false, onProgress } = {}) {
      const report = onProgress && Comlink.proxy(onProgress);
      const opened: Opened = await call(
        (api) => api.open(file, name, lenient, report),
        false,
      ).catch(broken);
      if (opened.ok) held = { file, name, lenient };
      return opened;
    },
    async override(overrides) {
      const opened: Opened = await call((api) => api.override(overrides)).catch(broken);
      if (opened.ok && held) held.overrides = overrides;
      return opened;
    },
    async detect(options) {
      const detected: Detected = await call((api) => api.detect(options)).catch(broken);
      return detected;
    },
    async compare(text, name) {
      const compared: Compared = await call((api) => api.compare(text, name)).catch(broken);
      return compared;
    },
    methods: () => call((api) => api.methods()),
    score: () => call((api) => api.score()),
    save: (format) => call((api) => api.save(format)),
    cancel: () => stop(new Cancelled()),
  };
}

function start(): Running {
  const worker = new Worker(new URL("./worker.ts", import.meta.url), { type: "module" });
  let end: Running["end"] = () => {};
  const ended = new Promise<never>((_, reject) => {
    end = reject;
  });
  // Nobody may be waiting when it ends.
  ended.catch(() => {});
  worker.addEventListener("error", (event) =>
    end(new Error(event.message || "The worker failed.")),
  );
  // Comlink splits unions over promises; the calls are as the worker has them.
  return { worker, api: Comlink.wrap<Api>(worker) as unknown as Calls, ended, end };
}

/** Errors lose their class on the way from the worker, but not their name. */
function isTrap(error: unknown): boolean {
  return error instanceof Error && error.name === "RuntimeError";
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
