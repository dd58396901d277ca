/** Many clips at once: each is labelled by a worker of its own, and all are told in one table. */

import { batch, computed, signal } from "@preact/signals";
import * as Comlink from "comlink";
import { stemOf, unique } from "../lib/names";
import { tableCsv } from "../lib/table";
import { archivist, type Orders, type Stoppable, type Survey, surveyors } from "../worker";
import type { Failure } from "../worker/types";
import { compareWith } from "./compare";
import { messageOf } from "./failing";
import { handOver } from "./handOver";
import { keptOf } from "./keep";
import { sizeLimit, tooLarge } from "./limits";
import { openSource } from "./open";
import { pause } from "./playback";
import { announcement, options, type Refusal, type Source, segmentOptions } from "./state";
import { withProgress } from "./work";

/** One file of the table. */
export interface Row {
  /** Place in the drop, from 1. */
  number: number;
  source: Source;
  status: "waiting" | "running" | "done" | "failed";
  survey?: Survey;
  failure?: Failure;
}

/** The files of the last drop, when there were several. */
export const rows = signal<readonly Row[]>([]);

/** Whether their table is on show. */
export const tableShown = signal(false);

export const finished = computed(
  () => rows.value.filter(({ status }) => status === "done" || status === "failed").length,
);

/** What the table was made with. */
export const asked = signal<Pick<Orders, "detect" | "segment">>();

let controller = new AbortController();

/** Labels all clips; what could not even be unpacked stands in the table too. */
export async function survey(clips: readonly Source[], refusals: readonly Refusal[]) {
  stopSurvey();
  const refused = refusals.map(({ name, failure }) => ({
    source: { name, data: new Blob() },
    status: "failed" as const,
    failure,
  }));
  const waiting = clips.map((source) => ({ source, status: "waiting" as const }));
  batch(() => {
    pause();
    rows.value = [...waiting, ...refused].map((row, i) => ({ ...row, number: i + 1 }));
    tableShown.value = true;
  });
  await goOn();
}

/** Labels the clips that wait. */
export async function goOn() {
  controller = new AbortController();
  const { signal } = controller;
  const orders = { detect: options.value, segment: segmentOptions.value };
  asked.value = orders;
  const waiting = rows.value.filter(({ status }) => status === "waiting");
  await Promise.all(
    waiting.map((row) => surveyOne(row, { ...orders, formats: [], segmentFormats: [] }, signal)),
  );
  if (signal.aborted) return;
  settle();
  const failed = rows.value.filter(({ status }) => status === "failed").length;
  announcement.value = `${rows.value.length} files labelled${failed ? `, ${failed} could not be read` : ""}`;
}

/** Labels all clips anew, as is asked now. */
export async function labelAgain() {
  stopSurvey();
  rows.value = rows.value.map(({ number, source, ...row }) =>
    row.status === "done" ? { number, source, status: "waiting" } : { number, source, ...row },
  );
  await goOn();
}

async function surveyOne(row: Row, orders: Orders, signal: AbortSignal) {
  const { name, data } = row.source;
  if (data.size > sizeLimit) {
    change(row, { status: "failed", failure: tooLarge(data.size) });
    return;
  }
  try {
    const surveyed = await surveyors.run((calls) => {
      change(row, { status: "running" });
      return calls.survey(data, name, orders, Comlink.proxy(keptOf));
    }, signal);
    if (signal.aborted) return;
    change(
      row,
      surveyed.ok
        ? { status: "done", survey: surveyed.survey }
        : { status: "failed", failure: surveyed.failure },
    );
  } catch (error) {
    if (signal.aborted) return;
    change(row, { status: "failed", failure: { message: messageOf(error) } });
  }
}

/** Changes that came since the last picture: a table of a thousand rows is drawn once for all. */
const changes = new Map<number, Partial<Row>>();

function change({ number }: Row, to: Partial<Row>) {
  if (!changes.size) setTimeout(settle, 50);
  changes.set(number, { ...changes.get(number), ...to });
}

function settle() {
  if (!changes.size) return;
  rows.value = rows.value.map((row) => ({ ...row, ...changes.get(row.number) }));
  changes.clear();
}

/** Ends what is not done: it waits until somebody goes on. */
export function stopSurvey() {
  controller.abort(new Error("stopped"));
  settle();
  rows.value = rows.value.map((row) =>
    row.status === "running" ? { ...row, status: "waiting" } : row,
  );
}

/** Opens a clip of the table. */
export async function openRow({ source }: Row): Promise<void> {
  if (!(await openSource(source))) return;
  tableShown.value = false;
  for (const { name, data } of source.labels ?? []) await compareWith(name, data);
}

const everything = {
  formats: ["json", "csv", "intervals", "events", "npz"],
  segmentFormats: ["json", "csv"],
} as const;

/** Hands all labels and segments of all clips to the browser, with the table, in one archive. */
export async function saveAll(): Promise<void> {
  const done = rows.value.filter(({ status }) => status === "done");
  const orders = {
    ...everything,
    ...(asked.peek() ?? { detect: options.value, segment: segmentOptions.value }),
  };
  const names = unique(done.map(({ source }) => stemOf(source.name)));
  const made = (stoppable: Stoppable) =>
    archivist.run(async (calls) => {
      let count = 0;
      const save = async ({ source: { name, data } }: Row, i: number) => {
        const surveyed = await surveyors.run(
          (survey) => survey.survey(data, name, orders, Comlink.proxy(keptOf)),
          stoppable.signal,
        );
        if (!surveyed.ok) throw new Error(`${name}: ${surveyed.failure.message}`);
        for (const { ending, data } of surveyed.documents) {
          await calls.add(`${names[i]}${ending}`, data);
        }
        stoppable.onProgress?.(++count / done.length);
      };
      await Promise.all(done.map(save));
      await calls.add("table.csv", tableCsv(rows.value));
      return calls.finish();
    }, stoppable.signal);
  await handOver("labels.zip", () =>
    withProgress({ what: "Saving", name: "labels.zip" }, new AbortController(), made),
  );
}
