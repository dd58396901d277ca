/** Views of the open session for components: fields that follow it, and values derived from it. */

import { computed } from "@preact/signals";
import { plantsOf } from "../model/plants/plants";
import { plantEditsOf } from "../model/segments/cut-edits";
import { actionsOf, cutsOf, nameSegments } from "../model/segments/segments";
import { titleOfSource } from "../model/sources/source";
import { openVocabulary } from "./batch";
import { session, sessionField } from "./clip-session";

export const source = computed(() => session.value.source);

/** True while the clip is the decorative preview of the start page. */
export const isPreview = computed(() => session.value.isPreview);

export const clip = sessionField((clipSession) => clipSession.clip);
export const overrides = sessionField((clipSession) => clipSession.overrides);
export const detection = sessionField((clipSession) => clipSession.detection);
export const detectFailure = sessionField((clipSession) => clipSession.detectFailure);
export const segmentation = sessionField((clipSession) => clipSession.segmentation);
export const segmentFailure = sessionField((clipSession) => clipSession.segmentFailure);
export const segmentNames = sessionField((clipSession) => clipSession.segmentNames);
export const renamedSegment = sessionField((clipSession) => clipSession.renamedSegment);
export const edits = sessionField((clipSession) => clipSession.edits);
export const selectedCut = sessionField((clipSession) => clipSession.selectedCut);
export const cutPreview = sessionField((clipSession) => clipSession.cutPreview);
export const selected = sessionField((clipSession) => clipSession.selected);
export const selectedEdge = sessionField((clipSession) => clipSession.selectedEdge);
export const similar = sessionField((clipSession) => clipSession.similar);
export const addTarget = sessionField((clipSession) => clipSession.addTarget);
export const dragPreview = sessionField((clipSession) => clipSession.dragPreview);
export const persistError = sessionField((clipSession) => clipSession.persistError);
export const unreadable = sessionField((clipSession) => clipSession.unreadable);
export const changedElsewhere = sessionField((clipSession) => clipSession.changedElsewhere);
export const reference = sessionField((clipSession) => clipSession.reference);
export const scores = sessionField((clipSession) => clipSession.scores);
export const scorePart = sessionField((clipSession) => clipSession.scorePart);
export const referenceSegments = sessionField((clipSession) => clipSession.referenceSegments);
export const cutScores = sessionField((clipSession) => clipSession.cutScores);
export const cleaning = sessionField((clipSession) => clipSession.cleaning);
export const slides = sessionField((clipSession) => clipSession.slides);
export const gait = sessionField((clipSession) => clipSession.gait);
export const gaitAction = sessionField((clipSession) => clipSession.gaitAction);

/** The clip that the user opened; null on the start page. */
export const openClip = computed(() => (isPreview.value ? null : clip.value));

/** Name of the clip, with its folder if another clip of the drop has the same name. */
export const clipTitle = computed(() =>
  source.value ? titleOfSource(source.value) : (clip.value?.name ?? ""),
);

/** The edits of the labels. */
export const plantEdits = computed(() => plantEditsOf(edits.value));

/** The displayed score: that of the chosen part, or the first. */
export const score = computed(
  () => scores.value.find(({ part }) => part === scorePart.value) ?? scores.value[0],
);

export const plants = computed(() => (detection.value ? plantsOf(detection.value) : []));

/** The segments with the names that the user gave them. */
export const namedSegments = computed(() =>
  nameSegments(
    segmentation.value?.segments ?? [],
    segmentNames.value,
    openVocabulary.value,
    segmentation.value?.detected,
  ),
);

/** The actions whose gait can be measured separately; empty if all of the clip is one action. */
export const gaitActions = computed(() => {
  const actions = actionsOf(namedSegments.value);
  return actions.length > 1 ? actions : [];
});

/** The action whose gait is measured; undefined for the whole clip. */
export const measuredAction = computed(() =>
  gaitActions.value.find(({ name }) => name === gaitAction.value),
);

/** The first frame of each segment except the first. */
export const cuts = computed(() => cutsOf(namedSegments.value));

/** Notices of the archive, of the reader and of the detector. */
export const notices = computed(() => [
  ...((openClip.value && source.value?.notices) ?? []),
  ...(openClip.value?.notices ?? []),
  ...(openClip.value && detection.value ? detection.value.notices : []),
]);

/** The clean-up, as long as clip, labels and overrides are those from which it was computed. */
const cleanUp = computed(() => {
  const clipSession = session.value;
  const made = clipSession.cleanUp.value;
  const isCurrent =
    made?.clip === clipSession.clip.value &&
    made?.detection === clipSession.detection.value &&
    made?.overrides === clipSession.overrides.value;
  return isCurrent ? made : null;
});

/** The clip without foot skate; null until it is computed. */
export const cleaned = computed(() => cleanUp.value?.cleaned ?? null);

/** False if the clean-up left spikes of the hips. */
export const repairsSpikes = computed(() => !cleanUp.value?.keepSpikes);

/** Frames of the plants that the clean-up corrected; empty for all. */
export const cleanedOnly = computed(() => cleanUp.value?.only ?? []);

/** Version of the clip that the viewer shows. */
export const cleanedView = computed(() => cleanUp.value?.view ?? "before");
