/** Measuring gait and foot skate while the clip tab is open. */

import { batch, effect } from "@preact/signals";
import { Cancelled, engine } from "../engine";
import { type ClipSession, session } from "../store/clip-session";
import { reportFailure } from "../store/errors";
import { runJob } from "../store/jobs";
import { activeTab } from "../store/view";

/** Measures the open clip whenever its labels change and the clip tab is open. */
export function startMeasuring() {
  effect(() => {
    const open = session.value;
    if (!open.isPreview && open.detection.value && activeTab.value === "clip") {
      void measure(open);
      return;
    }
    open.drop("measure");
    open.gait.value = undefined;
    open.slides.value = [];
  });
}

async function measure(open: ClipSession) {
  try {
    const measured = await open.run("measure", () =>
      runJob({ title: "Measuring" }, new AbortController(), (options) =>
        Promise.all([engine.gait(options), engine.skate(options)]),
      ),
    );
    if (!measured) return;
    batch(() => {
      [open.gait.value, open.slides.value] = measured;
    });
  } catch (error) {
    if (!(error instanceof Cancelled)) reportFailure("measured", open.source?.name ?? "", error);
  }
}
