/** Saving labels, and parts of the names of all saved files. */

import { engine } from "../../engine";
import type { FileFormat } from "../../model/types";
import { clip, detection, openClip } from "../../store/session";
import { plantFormats } from "../../store/settings";
import { stemOf } from "../../util/file-names";
import { download, ofOpenClip } from "./download";

/** Downloads the labels, by default in the first format. */
export async function exportLabels(format = plantFormats.value[0]): Promise<void> {
  if (!openClip.value || !detection.value || !format) return;
  await downloadAs(format, () => engine.save(format.name));
}

/** Downloads a file that is named after the clip. */
export function downloadAs(
  { extension, mediaType }: FileFormat,
  save: () => Promise<Uint8Array<ArrayBuffer> | string>,
  ready?: () => Promise<void>,
): Promise<void> {
  const make = ofOpenClip(async () => new Blob([await save()], { type: mediaType }), ready);
  return download(`${stem()}.${extension}`, make);
}

/** Returns the name of the open clip without its extension. */
export const stem = () => stemOf(clip.value?.name ?? "clip");
