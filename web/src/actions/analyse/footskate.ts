/** Removing foot skate. */

import { batch } from "@preact/signals";
import { engine } from "../../engine";
import type { FootFrames } from "../../model/types";
import { type CleanedView, session } from "../../store/clip-session";
import { reportFailure } from "../../store/errors";
import { runJob } from "../../store/jobs";
import { clip } from "../../store/session";
import { announce } from "../../store/view";
import { stemOf } from "../../util/file-names";
import { download, ofOpenClip } from "../save/download";

/** Removes the foot skate of the open clip, or of some of its plants, and shows the result. */
export async function cleanClip({
  keepSpikes = false,
  only = [],
}: {
  keepSpikes?: boolean;
  only?: FootFrames[];
} = {}): Promise<void> {
  const clipSession = session.value;
  const [before, detection, overrides] = [
    clipSession.clip.value,
    clipSession.detection.value,
    clipSession.overrides.value,
  ];
  if (!before || !detection || clipSession.cleaning.value) return;
  clipSession.cleaning.value = true;
  try {
    const cleaned = await clipSession.run("clean", () =>
      runJob({ title: "Fixing foot skate of" }, new AbortController(), (options) =>
        engine.clean(keepSpikes, only, options),
      ),
    );
    // Labels that have changed since the start need another clean-up.
    if (!cleaned || clipSession.detection.value !== detection) return;
    batch(() => {
      clipSession.cleanUp.value = {
        clip: before,
        detection,
        overrides,
        keepSpikes,
        only,
        cleaned,
        view: "both",
      };
      announce("Foot skate fixed; the original is shown in red");
    });
  } catch (error) {
    reportFailure("cleaned", before.name, error, () => void cleanClip({ keepSpikes, only }));
  } finally {
    clipSession.cleaning.value = false;
  }
}

/** Chooses which version of the clip the viewer shows. */
export function setCleanedView(view: CleanedView) {
  const { cleanUp } = session.value;
  if (cleanUp.value) cleanUp.value = { ...cleanUp.value, view };
}

/** Shows the clip as it was, so that it can be cleaned in another way. */
export function discardCleaned() {
  session.value.cleanUp.value = null;
}

/** Downloads the cleaned clip. */
export async function saveCleaned(): Promise<void> {
  const name = `${stemOf(clip.value?.name ?? "clip")}.clean.bvh`;
  const { keepSpikes = false, only = [] } = session.value.cleanUp.value ?? {};
  const write = () =>
    runJob({ title: "Writing" }, new AbortController(), (options) =>
      engine.saveCleaned(keepSpikes, only, options),
    );
  await download(name, ofOpenClip(write));
}
