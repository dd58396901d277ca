import { computed, signal } from "@preact/signals";
import type { Span, Stay } from "../lib/edits";
import type { Origin } from "../lib/hash";
import { plantEdges, plantsOf } from "../lib/plants";
import { type Action, actionsOf, cutsOf, type Named } from "../lib/segments";
import type { Showing } from "../lib/showing";
import type { TimeView } from "../lib/timeView";
import type {
  Clip,
  CutScore,
  Detection,
  DetectOptions,
  Edit,
  Failure,
  Labelling,
  MethodFacts,
  Overrides,
  Part,
  Score,
  Segmentation,
  SegmentMethod,
  SegmentOptions,
  Segments,
} from "../worker/types";

/** A clip that can be opened: a dropped file, a sample, a link. */
export interface Source {
  name: string;
  data: Blob;
  /** Where labels of it are that are known to be right. */
  truth?: string;
  /** Where anyone can have it from; absent for a file of one's own. */
  origin?: Origin;
  /** Values that are no number are held from the frame before. */
  lenient?: boolean;
  /** How it is to be shown, where a link or a shared page says so. */
  showing?: Showing;
  /** What was changed in it by whoever shared it; by `id` it is told from the same clip shared again. */
  shared?: { id: string; edits: readonly Edit[]; names: readonly Named[] };
  /** Labels and segments that were dropped with it and bear its name. */
  labels?: readonly Source[];
}

/** Another clip that stands beside the one on show. */
export interface Beside {
  source: Source;
  clip: Clip;
  detection: Detection | null;
}

/** A file that could not be opened, and why. */
export interface Refusal {
  name: string;
  /** What could not be done with it; opened, if that is not said. */
  what?: string;
  failure: Failure;
  /** The file, where its bytes are at hand: it may be tried again in another way. */
  source?: Source;
}

export interface Task {
  name: string;
  stage: "fetch" | "read" | "detect";
  /** 0 … 1; undefined where nobody knows how much is left. */
  share?: number;
}

/** What the worker does for the clip on show, where that takes time. */
export interface Work {
  id: number;
  /** What is done, to be followed by a name. */
  what: string;
  /** Of what, where it is not the clip on show: then it goes on when another is opened. */
  name?: string;
  share?: number;
  stop: () => void;
}

export type CameraView = "perspective" | "front" | "side" | "top";
export type Tab = "detect" | "why" | "segment" | "labels" | "score" | "clip";
export type Loop = "off" | "clip" | "plant" | "segment";

/** The clip on show; null before the first one is read. */
export const clip = signal<Clip | null>(null);

/** Where the clip on show came from. */
export const source = signal<Source | null>(null);

/** The clip on show is only the moving picture behind the empty page. */
export const hero = signal(true);

/** The labels of the clip on show; null while there are none. */
export const detection = signal<Detection | null>(null);

/** Why there are no labels, when the detector could not find any. */
export const detectFailure = signal<Failure | null>(null);

/** Other clips beside the one on show, in the order in which they came. */
export const besides = signal<readonly Beside[]>([]);

/** What a person corrected in the labels, in order. */
export const edits = signal<readonly Edit[]>([]);

/** The bar of the timeline that is edited. */
export const selected = signal<Stay | null>(null);

/** Where it would be if the drag of its edge ended now. */
export const reach = signal<Span | null>(null);

/** Why edits last only as long as the page. */
export const keepFailure = signal("");

/** Someone else's labels of the clip, shown beside ours. */
export const other = signal<Labelling | null>(null);

/** How ours agree with them, for each part that both have. */
export const scores = signal<readonly Score[]>([]);

/** The part whose agreement is on show, where there are several. */
export const scorePart = signal<Part | null>(null);

/** The score on show: of the part chosen, or of the first. */
export const score = computed(
  () => scores.value.find(({ part }) => part === scorePart.value) ?? scores.value[0],
);

/** The segments of the clip on show; null while there are none. */
export const segmentation = signal<Segmentation | null>(null);

/** Why there are no segments. */
export const segmentFailure = signal<Failure | null>(null);

/** What people called actions of the clip on show, whatever the segments are at the moment. */
export const segmentNames = signal<readonly Named[]>([]);

/** Someone else's segments of the clip, shown below ours. */
export const otherSegments = signal<Segments | null>(null);

/** How the cuts of ours agree with those. */
export const cutScores = signal<readonly CutScore[]>([]);

/** All methods of segmentation; empty until they are known. */
export const segmentMethods = signal<readonly SegmentMethod[]>([]);

/** All methods of detection; empty until they are known. */
export const methods = signal<readonly MethodFacts[]>([]);

/** Why the last file could not be opened; the clip before it stays. */
export const failure = signal<Refusal | null>(null);

/** What is being opened right now. */
export const task = signal<Task | null>(null);

/** What is being done for the clip on show and may take long, in the order of its beginning. */
export const work = signal<readonly Work[]>([]);

/** What the detector is asked for; kept from clip to clip. */
export const options = signal<DetectOptions>({ method: "robust", r: 0.001, w: 1 });

/** What segmentation is asked for; the method is kept from clip to clip. */
export const segmentOptions = signal<SegmentOptions>({ method: "auto" });

/** What a person corrected about the clip on show. */
export const overrides = signal<Overrides>({});

/** The moment on show in frames; between two frames while playing. */
export const playhead = signal(0);

export const playing = signal(false);

/** Speed of playback: 1 is as recorded. */
export const speed = signal(1);

/** What playback repeats. */
export const loop = signal<Loop>("clip");

/** The frames a loop of one plant or segment repeats, half-open. */
export const loopRegion = signal<TimeView | null>(null);

/** Those frames as long as such a loop is on. */
export const looped = computed(() =>
  loop.value === "plant" || loop.value === "segment" ? loopRegion.value : null,
);

/** The part of the clip the timeline shows. */
export const timeView = signal<TimeView>({ start: 0, end: 1 });

/** The side the camera was last asked to look from. */
export const cameraView = signal<CameraView>("perspective");

/** Counts those requests: asking again for the same side turns back to it. */
export const cameraRequests = signal(0);

export function look(view: CameraView) {
  cameraView.value = view;
  cameraRequests.value++;
}

/** The camera travels with the character. */
export const follow = signal(true);

/** The ways of toes and hips are drawn. */
export const trails = signal(false);

/** Counts requests to frame everything; the viewer answers each one. */
export const frameAllRequests = signal(0);

export const tab = signal<Tab>("detect");

/** The segment whose name is asked for; the panel's field for it takes the focus. */
export const renaming = signal<Action | null>(null);

/** On a phone the panel is a sheet; this is whether it is up. */
export const sheetOpen = signal(false);

export const dialog = signal<"keys" | "notices" | "share" | null>(null);

/** Files are being dragged over the page. */
export const dragging = signal(false);

/** What a screen reader is told next. */
export const announcement = signal("");

export const phase = computed(() => {
  if (failure.value) return "error";
  if (task.value) return "loading";
  if (!openClip.value) return "empty";
  return work.value.length && !segmentation.value ? "loading" : "ready";
});

/** The clip a person opened: nothing while the page is empty. */
export const openClip = computed(() => (hero.value ? null : clip.value));

/** Whole frame under the playhead. */
export const frame = computed(() => Math.floor(playhead.value + 1e-6));

export const plants = computed(() => (detection.value ? plantsOf(detection.value) : []));

export const edges = computed(() => plantEdges(plants.value, clip.value?.frames ?? 1));

/** The segments with what people call them. */
export const actions = computed(() =>
  actionsOf(segmentation.value?.segments ?? [], segmentNames.value),
);

/** The first frame of each segment but the first. */
export const cuts = computed(() => cutsOf(actions.value));

/** The segment that is looped. */
export const chosen = computed(() => {
  const start = loop.value === "segment" ? loopRegion.value?.start : undefined;
  return actions.value.find((action) => action.start === start);
});

/** Everything the reader and the detector had to say. */
export const notices = computed(() => [
  ...(openClip.value?.notices ?? []),
  ...(openClip.value && detection.value ? detection.value.notices : []),
]);
