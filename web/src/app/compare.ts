import { batch } from "@preact/signals";
import { nextAfter } from "../lib/disagreements";
import { bytes } from "../lib/time";
import { engine } from "./engine";
import { fail, messageOf } from "./failing";
import { fetchBlob } from "./fetch";
import { pause, seek } from "./playback";
import {
  announcement,
  cutScores,
  detection,
  frame,
  openClip,
  other,
  otherSegments,
  score,
  scorePart,
  scores,
  segmentation,
  source,
  tab,
} from "./state";

/** Labels of an hour at 240 Hz stay below. */
const sizeLimit = 2 ** 27;

/** Shows someone else's labels or segments of the clip beside ours, and how they agree. */
export async function compareWith(name: string, data: Blob): Promise<void> {
  const about = source.value;
  if (!openClip.value) {
    fail(name, {
      message: "There is no clip that these labels could stand beside.",
      hint: "Open the clip first, or drop both together.",
    });
    return;
  }
  if (data.size > sizeLimit) {
    fail(name, {
      message: `The labels have ${bytes(data.size)}; the limit is ${bytes(sizeLimit)}.`,
    });
    return;
  }
  try {
    const compared = await engine.compare(data, name);
    if (source.value !== about) return;
    if (!compared.ok) {
      fail(name, compared.failure);
      return;
    }
    batch(() => {
      if ("segments" in compared) {
        otherSegments.value = compared.segments;
        tab.value = "segment";
      } else {
        other.value = compared.other;
        tab.value = "score";
      }
      announcement.value = `Compared with ${name}`;
    });
    await ("segments" in compared ? rescoreSegments() : rescore());
  } catch (error) {
    fail(name, { message: messageOf(error) });
  }
}

/** Compares a sample with the labels that were generated with it. */
export async function compareWithTruth(): Promise<void> {
  const url = source.value?.truth;
  if (!url) return;
  const name = `${openClip.value?.name.replace(/\.bvh$/i, "")} truth`;
  try {
    const data = await fetchBlob(url, new AbortController().signal, sizeLimit, () => {});
    await compareWith(name, data);
  } catch (error) {
    fail(name, { message: messageOf(error) });
  }
}

export function dropComparison() {
  batch(() => {
    other.value = null;
    scores.value = [];
    scorePart.value = null;
    if (tab.value === "score") tab.value = "labels";
  });
}

/** Measures the agreement anew; without labels on both sides there is none. */
export async function rescore(): Promise<void> {
  const [ours, theirs] = [detection.value, other.value];
  const measured = ours && theirs ? await engine.score() : [];
  if (detection.value === ours && other.value === theirs) scores.value = measured;
}

/** The same for segments. */
export async function rescoreSegments(): Promise<void> {
  const [ours, theirs] = [segmentation.value, otherSegments.value];
  const measured = ours && theirs ? await engine.scoreSegments() : [];
  if (segmentation.value === ours && otherSegments.value === theirs) cutScores.value = measured;
}

export function dropOtherSegments() {
  batch(() => {
    otherSegments.value = null;
    cutScores.value = [];
  });
}

/** Goes to the next or the previous frame where the labels begin to differ, round and round. */
export function stepDisagreement(direction: 1 | -1) {
  const next = nextAfter(score.value?.disagreements ?? [], frame.value, direction);
  if (!next) return;
  pause();
  seek(next.start);
  announcement.value = `${next.side} ${next.part} ${next.kind}, frames ${next.start} to ${next.end}`;
}
