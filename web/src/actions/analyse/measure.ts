/** Measuring gait and foot skate while the clip tab is open. */

import { batch, effect } from "@preact/signals";
import { engine } from "../../engine";
import type { GaitAction } from "../../model/types";
import { type ClipSession, session } from "../../store/clip-session";
import { reportFailure } from "../../store/errors";
import { runJob } from "../../store/jobs";
import { measuredAction } from "../../store/session";
import { gaitFormats } from "../../store/settings";
import { activeTab } from "../../store/view";

/** Measures the open clip whenever its labels change and the clip tab is open. */
export function startMeasuring() {
  effect(() => {
    const clipSession = session.value;
    if (!clipSession.isPreview && clipSession.detection.value && activeTab.value === "clip") {
      void measure(clipSession, measuredAction.value);
      return;
    }
    clipSession.drop("measure");
    clipSession.gait.value = undefined;
    clipSession.slides.value = [];
  });
}

async function listFormats() {
  if (!gaitFormats.value.length) gaitFormats.value = await engine.gaitFormats();
}

async function measure(clipSession: ClipSession, action: GaitAction | undefined) {
  try {
    const measured = await clipSession.run("measure", () =>
      runJob({ title: "Measuring" }, new AbortController(), (options) =>
        Promise.all([engine.gait(action?.frames, options), engine.skate(options), listFormats()]),
      ),
    );
    if (!measured) return;
    batch(() => {
      [clipSession.gait.value, clipSession.slides.value] = measured;
    });
  } catch (error) {
    reportFailure(
      "measured",
      clipSession.source?.name ?? "",
      error,
      () => void measure(clipSession, action),
    );
  }
}
