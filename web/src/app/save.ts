import { labelEndings, segmentEndings } from "../lib/endings";
import { stemOf } from "../lib/names";
import { fileNames, titleOf } from "../lib/segments";
import type { SegmentFormat } from "../worker/types";
import { engine } from "./engine";
import { handOver } from "./handOver";
import { actions, clip, detection, openClip } from "./state";
import { withProgress } from "./work";

export type SaveFormat = Parameters<typeof engine.save>[0];

/** Hands the labels to the browser as a download. */
export async function save(format: SaveFormat): Promise<void> {
  if (!openClip.value || !detection.value) return;
  const [suffix, type] = labelEndings[format];
  await handOver(stem() + suffix, async () => new Blob([await engine.save(format)], { type }));
}

/** Hands the segments under their names to the browser as a download. */
export async function saveSegments(format: SegmentFormat): Promise<void> {
  const [suffix, type] = segmentEndings[format];
  const names = actions.value.map(titleOf);
  await handOver(
    stem() + suffix,
    async () => new Blob([await engine.saveSegments(format, names)], { type }),
  );
}

/** Hands each segment as a BVH file of its own to the browser, all in one archive. */
export async function saveClips(): Promise<void> {
  const names = fileNames(actions.value, stem());
  const parts = actions.value.map(({ start, end }, i) => ({ name: names[i] ?? "", start, end }));
  await handOver(`${stem()}.segments.zip`, () =>
    withProgress({ what: "Cutting" }, new AbortController(), (stoppable) =>
      engine.cut(parts, stoppable),
    ),
  );
}

/** The clip's name without its ending. */
const stem = () => stemOf(clip.value?.name ?? "clip");
