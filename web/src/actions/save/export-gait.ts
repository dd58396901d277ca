/** Saving and printing gait. */

import { engine } from "../../engine";
import type { FileFormat } from "../../model/types";
import { session } from "../../store/clip-session";
import { reportFailure } from "../../store/errors";
import { gaitActions, measuredAction } from "../../store/session";
import { gaitFormats } from "../../store/settings";
import { download, ofOpenClip } from "./download";
import { downloadAs, stem } from "./export";

/** Time for which the report can be reloaded. */
const reportLifetimeMs = 600_000;

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
