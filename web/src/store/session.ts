/** Views of the open session for components: fields that follow it, and values derived from it. */

import { computed } from "@preact/signals";
import { plantEdges, plantsOf } from "../model/plants";
import { cutsOf, nameSegments } from "../model/segments";
import { session, sessionField } from "./clip-session";

export const source = computed(() => session.value.source);

/** True while the clip is the decorative preview of the start page. */
export const isPreview = computed(() => session.value.isPreview);

export const clip = sessionField((open) => open.clip);
export const overrides = sessionField((open) => open.overrides);
export const detection = sessionField((open) => open.detection);
export const detectFailure = sessionField((open) => open.detectFailure);
export const segmentation = sessionField((open) => open.segmentation);
export const segmentFailure = sessionField((open) => open.segmentFailure);
export const segmentNames = sessionField((open) => open.segmentNames);
export const renamedSegment = sessionField((open) => open.renamedSegment);
export const edits = sessionField((open) => open.edits);
export const selected = sessionField((open) => open.selected);
export const dragPreview = sessionField((open) => open.dragPreview);
export const persistError = sessionField((open) => open.persistError);
export const reference = sessionField((open) => open.reference);
export const scores = sessionField((open) => open.scores);
export const scorePart = sessionField((open) => open.scorePart);
export const referenceSegments = sessionField((open) => open.referenceSegments);
export const cutScores = sessionField((open) => open.cutScores);
export const cleaning = sessionField((open) => open.cleaning);
export const slides = sessionField((open) => open.slides);
export const gait = sessionField((open) => open.gait);

/** The clip that the user opened; null on the start page. */
export const openClip = computed(() => (isPreview.value ? null : clip.value));

/** The displayed score: that of the chosen part, or the first. */
export const score = computed(
  () => scores.value.find(({ part }) => part === scorePart.value) ?? scores.value[0],
);

export const plants = computed(() => (detection.value ? plantsOf(detection.value) : []));

/** Frames at which plants begin or end, ascending. */
export const edges = computed(() => plantEdges(plants.value, clip.value?.frames ?? 1));

/** The segments with the names that the user gave them. */
export const namedSegments = computed(() =>
  nameSegments(segmentation.value?.segments ?? [], segmentNames.value),
);

/** The first frame of each segment except the first. */
export const cuts = computed(() => cutsOf(namedSegments.value));

/** Notices of the reader and of the detector. */
export const notices = computed(() => [
  ...(openClip.value?.notices ?? []),
  ...(openClip.value && detection.value ? detection.value.notices : []),
]);

/** The clean-up, as long as clip, labels and overrides are those from which it was computed. */
const cleanUp = computed(() => {
  const open = session.value;
  const made = open.cleanUp.value;
  const isCurrent =
    made?.clip === open.clip.value &&
    made?.detection === open.detection.value &&
    made?.overrides === open.overrides.value;
  return isCurrent ? made : null;
});

/** The clip without foot skate; null until it is computed. */
export const cleaned = computed(() => cleanUp.value?.cleaned ?? null);

/** Which version of the clip the viewer shows. */
export const cleanedView = computed(() => cleanUp.value?.view ?? "before");
