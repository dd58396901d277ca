/** Moving between the start page and the clips that were open, by the logo, Back and Forward. */

import { batch } from "@preact/signals";
import { engine } from "../../engine";
import type { Source } from "../../model/sources/source";
import { batchRows, tableVisible } from "../../store/batch";
import { ClipSession, openSession, session } from "../../store/clip-session";
import { errorReport } from "../../store/errors";
import { opening } from "../../store/jobs";
import { source } from "../../store/session";
import { dialog } from "../../store/view";
import { showTable } from "../analyse/batch";
import { compareQuietly } from "../analyse/compare";
import { pause } from "../view/playback";
import { clipOfEntry, isTableEntry } from "./history";
import { cancelOpening, openingSignal, openSource } from "./open";
import { openFromAddress, startPreview } from "./open-address";

/** Shows the start page. */
export function goHome() {
  history.pushState(null, "", location.pathname + location.search);
  void showStartPage();
}

/** Shows the start page when the edits of the open clip are applied. */
async function showStartPage(): Promise<void> {
  cancelOpening();
  const [clipSession, signal] = [session.value, openingSignal()];
  await clipSession.editsDone();
  if (clipSession.signal.aborted || signal.aborted) return;
  batch(() => {
    pause();
    errorReport.value = null;
    dialog.value = null;
    tableVisible.value = false;
    openSession(new ClipSession(null, null, { isPreview: true }));
  });
  engine.cancel();
  void startPreview();
}

/** Opens a clip again, with the labels that were dropped with it. */
const reopen = (clip: Source) => openSource(clip, { whenOpen: () => compareQuietly(clip) });

/** Follows Back, Forward and changes of the address. */
export function followHistory(signal: AbortSignal) {
  addEventListener(
    "popstate",
    ({ state }) => {
      const clip = clipOfEntry(state);
      // Otherwise it would replace what is shown now.
      if (opening.peek() && opening.peek()?.stage !== "detect") cancelOpening();
      if (clip) {
        tableVisible.value = false;
        if (clip !== source.peek()) void reopen(clip);
      } else if (isTableEntry(state) && batchRows.peek().length) showTable();
      else if (!location.hash) void showStartPage();
    },
    { signal },
  );
  addEventListener(
    "hashchange",
    () => {
      if (!clipOfEntry(history.state)) void openFromAddress();
    },
    { signal },
  );
}
