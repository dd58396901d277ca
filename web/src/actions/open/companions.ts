/** Showing other clips side by side with the open one, synchronised in time. */

import { batch } from "@preact/signals";
import * as Comlink from "comlink";
import { batchWorkers } from "../../engine";
import type { Source } from "../../model/sources/source";
import { companions, maxCompanions } from "../../store/companions";
import { reportFailure, reportOpenFailure } from "../../store/errors";
import { runJob } from "../../store/jobs";
import { openClip } from "../../store/session";
import { detectOptions } from "../../store/settings";
import { announce } from "../../store/view";
import { storedChangesOf } from "../stored/persist";

export async function addCompanion(source: Source): Promise<void> {
  const { name, data } = source;
  if (!openClip.value || companions.value.length >= maxCompanions) return;
  if (companions.value.some((other) => other.source === source)) return;
  try {
    const job = { title: "Reading", name };
    const loaded = await runJob(job, new AbortController(), ({ signal }) =>
      batchWorkers.run(
        (calls) =>
          calls.loadCompanion(data, name, detectOptions.value, Comlink.proxy(storedChangesOf)),
        signal,
      ),
    );
    if (!loaded.ok) {
      reportOpenFailure(name, loaded.failure, { source });
      return;
    }
    const { clip, detection } = loaded;
    batch(() => {
      companions.value = [...companions.value, { source, clip, detection }];
      announce(`${name} is shown next to ${openClip.value?.name}`);
    });
  } catch (error) {
    if (!(error instanceof DOMException && error.name === "AbortError")) {
      reportFailure("shown", name, error, () => void addCompanion(source));
    }
  }
}

export function removeCompanion(source: Source) {
  companions.value = companions.value.filter((other) => other.source !== source);
}
