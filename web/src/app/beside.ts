/** Other clips side by side with the one on show, linked in time. */

import { batch } from "@preact/signals";
import * as Comlink from "comlink";
import { surveyors } from "../worker";
import { fail, failTo } from "./failing";
import { keptOf } from "./keep";
import { announcement, besides, openClip, options, type Source } from "./state";
import { withProgress } from "./work";

/** So many clips stand side by side with the one on show. */
export const mostBesides = 5;

/** Puts a clip beside the one on show. */
export async function putBeside(source: Source): Promise<void> {
  const { name, data } = source;
  if (!openClip.value || besides.value.length >= mostBesides) return;
  if (besides.value.some((other) => other.source === source)) return;
  try {
    const controller = new AbortController();
    const made = await withProgress({ what: "Reading", name }, controller, ({ signal }) =>
      surveyors.run(
        (calls) => calls.figure(data, name, options.value, Comlink.proxy(keptOf)),
        signal,
      ),
    );
    if (!made.ok) {
      fail(name, made.failure, source);
      return;
    }
    const { clip, detection } = made;
    batch(() => {
      besides.value = [...besides.value, { source, clip, detection }];
      announcement.value = `${name} stands beside ${openClip.value?.name}`;
    });
  } catch (error) {
    if (!(error instanceof DOMException && error.name === "AbortError")) {
      failTo("put beside", name, error);
    }
  }
}

export function takeAway(source: Source) {
  besides.value = besides.value.filter((other) => other.source !== source);
}
