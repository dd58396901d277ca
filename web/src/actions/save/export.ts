/** Saving labels, segments and clips. */

import { engine } from "../../engine";
import { segmentFileNames, segmentTitle } from "../../model/segments/segments";
import type { FileFormat } from "../../model/types";
import { session } from "../../store/clip-session";
import { runJob } from "../../store/jobs";
import {
  clip,
  detection,
  gaitActions,
  measuredAction,
  namedSegments,
  openClip,
} from "../../store/session";
import { gaitFormats, plantFormats } from "../../store/settings";
import { stemOf } from "../../util/file-names";
import { segmentingDone } from "../analyse/segment";
import { download } from "./download";

/** Time for which the report can be reloaded. */
const reportLifetimeMs = 600_000;

/** Downloads the labels, by default in the first format. */
export async function exportLabels(format = plantFormats.value[0]): Promise<void> {
  if (!openClip.value || !detection.value || !format) return;
  await downloadAs(format, () => engine.save(format.name));
}

/**
 * Downloads the segments under their names. The worker writes those of the chosen method, so their names are known
 * when they are shown.
 */
export async function exportSegments(format: FileFormat): Promise<void> {
  await downloadAs(format, async () => {
    await segmentingDone();
    const names = namedSegments.value.map(segmentTitle);
    const actions = namedSegments.value.map(({ action = "" }) => action);
    return engine.saveSegments(format.name, names, actions);
  });
}

/** Downloads a file that is named after the clip. */
function downloadAs(
  { extension, mediaType }: FileFormat,
  save: () => Promise<Uint8Array<ArrayBuffer>>,
): Promise<void> {
  const fileName = `${stem()}.${extension}`;
  return download(fileName, async () => new Blob([await save()], { type: mediaType }));
}

/** The actions of files of gait: the measured action, or none for the whole clip. */
const fileActions = () => (measuredAction.value ? [measuredAction.value] : []);

/** Downloads the gait of the measured action or of the whole clip. */
export async function exportGait({ name, extension, mediaType }: FileFormat): Promise<void> {
  await download(`${stem()}.${extension}`, async () => {
    const text = await engine.saveGait(fileActions(), name);
    return new Blob([text], { type: mediaType });
  });
}

/**
 * Opens the report of the gait in a new window and starts printing; with several actions and none chosen, the
 * report compares them. Where windows are blocked, the report is downloaded.
 */
export async function printGaitReport(): Promise<void> {
  const format = gaitFormats.value[0];
  if (!format) return;
  await session.value.editsDone();
  const actions = measuredAction.value ? fileActions() : gaitActions.value;
  const report = await engine.saveGait(actions, format.name);
  const blob = new Blob([report], { type: format.mediaType });
  const url = URL.createObjectURL(blob);
  const page = window.open(url);
  page?.addEventListener("load", () => page.print());
  if (!page) await download(`${stem()}.${format.extension}`, async () => blob);
  setTimeout(() => URL.revokeObjectURL(url), reportLifetimeMs);
}

/** Downloads an archive with each segment as a BVH file. */
export async function exportClips(): Promise<void> {
  await download(`${stem()}.segments.zip`, async () => {
    await segmentingDone();
    const names = segmentFileNames(namedSegments.value, stem());
    const parts = namedSegments.value.map(({ start, end }, i) => ({
      name: names[i] ?? "",
      start,
      end,
    }));
    return runJob({ title: "Cutting" }, new AbortController(), (options) =>
      engine.cut(parts, options),
    );
  });
}

const stem = () => stemOf(clip.value?.name ?? "clip");
