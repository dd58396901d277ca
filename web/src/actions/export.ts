/** Saving labels, segments and clips. */

import { engine } from "../engine";
import { labelFormats, segmentFormats } from "../model/file-formats";
import { segmentFileNames, segmentTitle } from "../model/segments";
import type { SaveFormat, SegmentFormat } from "../model/types";
import { runJob } from "../store/jobs";
import { clip, detection, namedSegments, openClip } from "../store/session";
import { stemOf } from "../util/file-names";
import { download } from "./download";

/** Downloads the labels. */
export async function exportLabels(format: SaveFormat): Promise<void> {
  if (!openClip.value || !detection.value) return;
  const [suffix, type] = labelFormats[format];
  await download(stem() + suffix, async () => new Blob([await engine.save(format)], { type }));
}

/** Downloads the segments under their names. */
export async function exportSegments(format: SegmentFormat): Promise<void> {
  const [suffix, type] = segmentFormats[format];
  const names = namedSegments.value.map(segmentTitle);
  await download(
    stem() + suffix,
    async () => new Blob([await engine.saveSegments(format, names)], { type }),
  );
}

/** Downloads an archive with each segment as a BVH file. */
export async function exportClips(): Promise<void> {
  const names = segmentFileNames(namedSegments.value, stem());
  const parts = namedSegments.value.map(({ start, end }, i) => ({
    name: names[i] ?? "",
    start,
    end,
  }));
  await download(`${stem()}.segments.zip`, () =>
    runJob({ title: "Cutting" }, new AbortController(), (options) => engine.cut(parts, options)),
  );
}

const stem = () => stemOf(clip.value?.name ?? "clip");
