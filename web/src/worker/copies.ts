/** What the core holds, as plain objects that go to the page. */

import { doubtful } from "../lib/plants";
import { digestOf } from "../lib/reduce";
import type { RawClip, RawDetection } from "../wasm/plantigrade";
import type { Clip, Detection, DetectOptions, Labels, Part, Side, Track, Tracks } from "./types";

export function copyClip(clip: RawClip, name: string): Clip {
  return { name, ...clip.facts(), positions: clip.positions() };
}

export function copyDetection(raw: RawDetection, options: DetectOptions): Detection {
  const names = raw.parts() as Part[];
  const parts = Object.fromEntries(names.map((part) => [part, tracks(raw, part)]));
  return {
    options,
    parts: parts as Detection["parts"],
    floor: raw.floor,
    notices: raw.notices(),
  };
}

function tracks(raw: RawDetection, part: Part): Tracks {
  // What curves and bars are drawn by is found here, where no picture waits for it.
  const track = (side: Side): Track => {
    const [height, speed] = [raw.height(part, side), raw.speed(part, side)];
    const digests = { height: digestOf(height), speed: digestOf(speed) };
    return { ...copyLabels(raw, part, side), height, speed, digests };
  };
  return { left: track("left"), right: track("right") };
}

export function copyLabels(raw: RawDetection, part: Part, side: Side): Labels {
  const [intervals, confidence] = [raw.intervals(part, side), raw.confidence(part, side)];
  return {
    planted: raw.planted(part, side),
    confidence,
    intervals,
    edited: raw.edited(part, side),
    doubts: doubtful(intervals, confidence),
  };
}

/** The memory of all series of a record, to be handed over rather than copied. */
export function buffers(record: object): Transferable[] {
  return Object.values(record).flatMap((value) => {
    if (ArrayBuffer.isView(value)) return [value.buffer as ArrayBuffer];
    return value && typeof value === "object" ? buffers(value) : [];
  });
}
