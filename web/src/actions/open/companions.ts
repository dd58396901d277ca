/** Showing other clips side by side with the open one, synchronised in time. */

import { batch } from "@preact/signals";
import * as Comlink from "comlink";
import { batchWorkers } from "../../engine";
import { type Source, titleOfSource } from "../../model/sources/source";
import { tableNumber } from "../../store/batch";
import { companions, maxCompanions, ownCompanions } from "../../store/companions";
import { reportFailure, reportOpenFailure } from "../../store/errors";
import { runJob } from "../../store/jobs";
import { clipTitle, openClip, source as openedSource } from "../../store/session";
import { detectOptions } from "../../store/settings";
import { announce } from "../../store/view";
import { storedChangesOf } from "../stored/persist";

export async function addCompanion(source: Source): Promise<void> {
  const { name, data, lenient = false } = source;
  const title = titleOfSource(source);
  const canAdd = () =>
    ownCompanions.value.length < maxCompanions &&
    ownCompanions.value.every((other) => other.source !== source);
  if (!openClip.value || !canAdd()) return;
  const origin = { addedTo: openedSource.value, table: tableNumber.value };
  try {
    const job = { title: "Reading", name: title };
    const loaded = await runJob(job, new AbortController(), ({ signal }) =>
      batchWorkers.run((calls) => {
        const changesOf = Comlink.proxy(storedChangesOf);
        return calls.loadCompanion(data, name, lenient, detectOptions.value, changesOf);
      }, signal),
    );
    if (!loaded.ok) {
      reportOpenFailure(title, loaded.failure);
      return;
    }
    // It may have been added twice meanwhile.
    if (!canAdd()) return;
    const { clip, detection } = loaded;
    batch(() => {
      // Those of other clips and tables are closed.
      companions.value = [...ownCompanions.value, { source, ...origin, clip, detection }];
      announce(`${title} is shown next to ${clipTitle}`);
    });
  } catch (error) {
    if (!(error instanceof DOMException && error.name === "AbortError")) {
      reportFailure("shown", title, error, () => void addCompanion(source));
    }
  }
}

export function removeCompanion(source: Source) {
  companions.value = companions.value.filter((other) => other.source !== source);
}
