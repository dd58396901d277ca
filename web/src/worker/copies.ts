/** What the core holds, as plain objects that go to the page. */

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
  const track = (side: Side): Track => ({
    ...copyLabels(raw, part, side),
    height: raw.height(part, side),
    speed: raw.speed(part, side),
  });
  return { left: track("left"), right: track("right") };
}

export function copyLabels(raw: RawDetection, part: Part, side: Side): Labels {
  return {
    planted: raw.planted(part, side),
    confidence: raw.confidence(part, side),
    intervals: raw.intervals(part, side),
    edited: raw.edited(part, side),
  };
}

/** The memory of all series of a record, to be handed over rather than copied. */
export function buffers(record: object): Transferable[] {
  return Object.values(record).flatMap((value) => {
    if (ArrayBuffer.isView(value)) return [value.buffer as ArrayBuffer];
    return value && typeof value === "object" ? buffers(value) : [];
  });
}
