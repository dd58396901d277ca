/** Saving labels, segments and clips. */

import { engine } from "../../engine";
import { segmentFileNames, segmentTitle } from "../../model/segments/segments";
import type { FileFormat } from "../../model/types";
import { session } from "../../store/clip-session";
import { reportFailure } from "../../store/errors";
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
import { download, ofOpenClip } from "./download";

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
  const save = () => {
    const names = namedSegments.value.map(segmentTitle);
    const actions = namedSegments.value.map(({ action = "" }) => action);
    return engine.saveSegments(format.name, names, actions);
  };
  await downloadAs(format, save, segmentingDone);
}

/** Downloads a file that is named after the clip. */
function downloadAs(
  { extension, mediaType }: FileFormat,
  save: () => Promise<Uint8Array<ArrayBuffer> | string>,
  ready?: () => Promise<void>,
): Promise<void> {
  const make = ofOpenClip(async () => new Blob([await save()], { type: mediaType }), ready);
  return download(`${stem()}.${extension}`, make);
}

/** The actions of files of gait: the measured action, or none for the whole clip. */
const fileActions = () => (measuredAction.value ? [measuredAction.value] : []);

/** Downloads the gait of the measured action or of the whole clip. */
export async function exportGait(format: FileFormat): Promise<void> {
  await downloadAs(format, () => engine.saveGait(fileActions(), format.name));
}

/**
 * Opens the report of the gait in a new window and starts printing; with several actions and none chosen, the
 * report compares them. Where windows are blocked, the report is downloaded.
 */
export async function printGaitReport(): Promise<void> {
  const format = gaitFormats.value[0];
  if (!format) return;
  const fileName = `${stem()}.${format.extension}`;
  const make = ofOpenClip(() => {
    const actions = measuredAction.value ? fileActions() : gaitActions.value;
    return engine.saveGait(actions, format.name);
  });
  try {
    await session.value.editsDone();
    const blob = new Blob([await make()], { type: format.mediaType });
    const url = URL.createObjectURL(blob);
    const page = window.open(url);
    page?.addEventListener("load", () => page.print());
    if (!page) await download(fileName, async () => blob);
    setTimeout(() => URL.revokeObjectURL(url), reportLifetimeMs);
  } catch (error) {
    reportFailure("printed", fileName, error, () => void printGaitReport());
  }
}

/** Downloads an archive with each segment as a BVH file. */
export async function exportClips(): Promise<void> {
  const cut = () => {
    const names = segmentFileNames(namedSegments.value, stem());
    const parts = namedSegments.value.map(({ start, end }, i) => ({
      name: names[i] ?? "",
      start,
      end,
    }));
    return runJob({ title: "Cutting" }, new AbortController(), (options) =>
      engine.cut(parts, options),
    );
  };
  await download(`${stem()}.segments.zip`, ofOpenClip(cut, segmentingDone));
}

const stem = () => stemOf(clip.value?.name ?? "clip");
