/** Labels that are dropped on the table. */

import { type Source, titleOfSource } from "../../model/sources/source";
import { type BatchRow, batchRows, labelsForTable, openBatchRow } from "../../store/batch";
import { reportOpenFailure } from "../../store/errors";
import { showToast } from "../../store/toasts";
import { plural } from "../../util/format";
import { attachLabels } from "../open/collect-files";
import { flushUpdates, processAgain } from "./batch";
import { compareQuietly } from "./compare";

/** Assigns the labels that were dropped on the table to its clips. */
export function addDroppedLabels() {
  const labels = labelsForTable.value;
  if (!labels.length) return;
  labelsForTable.value = [];
  void addLabels(labels);
}

/** Compares the clips of the table with labels of their names. */
export async function addLabels(labels: readonly Source[]): Promise<void> {
  flushUpdates();
  const rows = batchRows.value;
  const sources = rows.map(({ source }) => source);
  const { clips, errors } = attachLabels(sources, labels, "the table");
  const [error] = errors;
  if (error) reportOpenFailure(errors.map(({ name }) => name).join(", "), error.failure);
  const owners = rows.filter((_, i) => clips[i]?.labels?.length);
  for (const [i, { source }] of rows.entries()) replaceLabels(source, clips[i]?.labels ?? []);
  if (!owners.length) return;
  const isUnchanged = await Promise.all(owners.map(hasSameScore));
  const unchanged = owners.filter((_, i) => isUnchanged[i]);
  const names = unchanged.map(({ source }) => titleOfSource(source)).join(", ");
  showToast({
    text: names
      ? `The score of ${names} is unchanged by the dropped labels. Open the clip to compare it with them.`
      : `${plural(owners.length, "clip")} ${owners.length > 1 ? "were" : "was"} compared with the dropped labels.`,
  });
}

/** Adds labels to those of a clip, in place of older ones with the same names. */
function replaceLabels(source: Source, added: readonly Source[]) {
  const others = (source.labels ?? []).filter(({ name }) =>
    added.every((label) => label.name !== name),
  );
  source.labels = [...others, ...added];
}

/** Processes a row with its new labels. Returns true if it has the same score as before, or none. */
async function hasSameScore(row: BatchRow): Promise<boolean> {
  // The others get the labels when they are processed.
  if (row.status === "waiting") return false;
  const isOpen = row === openBatchRow.value;
  await processAgain(row);
  if (isOpen) await compareQuietly(row.source);
  const after = batchRows.value.find(({ source }) => source === row.source);
  return after?.summary?.agreement === row.summary?.agreement;
}
