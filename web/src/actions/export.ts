/** Saving labels, segments and clips. */

import { engine } from "../engine";
import { segmentFileNames, segmentTitle } from "../model/segments";
import type { FileFormat } from "../model/types";
import { runJob } from "../store/jobs";
import { clip, detection, namedSegments, openClip } from "../store/session";
import { plantFormats } from "../store/settings";
import { stemOf } from "../util/file-names";
import { download } from "./download";

/** Downloads the labels, by default in the first format. */
export async function exportLabels(format = plantFormats.value[0]): Promise<void> {
  if (!openClip.value || !detection.value || !format) return;
  await downloadAs(format, () => engine.save(format.name));
}

/** Downloads the segments under their names. */
export async function exportSegments(format: FileFormat): Promise<void> {
  const names = namedSegments.value.map(segmentTitle);
  await downloadAs(format, () => engine.saveSegments(format.name, names));
}

/** Downloads a file that is named after the clip. */
function downloadAs(
  { extension, mediaType }: FileFormat,
  save: () => Promise<Uint8Array<ArrayBuffer>>,
): Promise<void> {
  const fileName = `${stem()}.${extension}`;
  return download(fileName, async () => new Blob([await save()], { type: mediaType }));
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
