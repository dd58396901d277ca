import { fileNames, titleOf } from "../lib/segments";
import { Cancelled } from "../worker";
import type { SegmentFormat } from "../worker/types";
import { engine } from "./engine";
import { messageOf } from "./failing";
import { actions, announcement, clip, detection, failure, openClip } from "./state";
import { withProgress } from "./work";

export type SaveFormat = Parameters<typeof engine.save>[0];

const endings: Record<SaveFormat, readonly [suffix: string, type: string]> = {
  json: [".plants.json", "application/json"],
  csv: [".frames.csv", "text/csv"],
  intervals: [".intervals.csv", "text/csv"],
  events: [".events.csv", "text/csv"],
};

const segmentEndings: Record<SegmentFormat, readonly [suffix: string, type: string]> = {
  json: [".segments.json", "application/json"],
  csv: [".segments.csv", "text/csv"],
  babel: [".babel.json", "application/json"],
};

/** Hands the labels to the browser as a download. */
export async function save(format: SaveFormat): Promise<void> {
  if (!openClip.value || !detection.value) return;
  const [suffix, type] = endings[format];
  await handOver(suffix, async () => new Blob([await engine.save(format)], { type }));
}

/** Hands the segments under their names to the browser as a download. */
export async function saveSegments(format: SegmentFormat): Promise<void> {
  const [suffix, type] = segmentEndings[format];
  const names = actions.value.map(titleOf);
  await handOver(
    suffix,
    async () => new Blob([await engine.saveSegments(format, names)], { type }),
  );
}

/** Hands each segment as a BVH file of its own to the browser, all in one archive. */
export async function saveClips(): Promise<void> {
  const names = fileNames(actions.value, stem());
  const parts = actions.value.map(({ start, end }, i) => ({ name: names[i] ?? "", start, end }));
  await handOver(".segments.zip", () =>
    withProgress("Cutting", new AbortController(), (stoppable) => engine.cut(parts, stoppable)),
  );
}

/** The clip's name without its ending. */
const stem = () => (clip.value?.name ?? "clip").replace(/\.bvh$/i, "");

async function handOver(suffix: string, make: () => Promise<Blob>): Promise<void> {
  const file = stem() + suffix;
  try {
    const url = URL.createObjectURL(await make());
    const link = document.createElement("a");
    link.href = url;
    link.download = file;
    link.click();
    setTimeout(() => URL.revokeObjectURL(url), 10_000);
    announcement.value = `Saved ${file}`;
  } catch (error) {
    if (error instanceof Cancelled) return;
    failure.value = { name: file, failure: { message: messageOf(error) } };
  }
}
