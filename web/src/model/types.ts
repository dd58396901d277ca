/**
 * Types that the workers exchange with the page. Positions are in metres, Y up, right-handed;
 * times are in seconds; frames count from 0 and frame ranges are half-open.
 */

import type { CurveSummary } from "../util/min-max-pyramid";
import type {
  CleanedPlantInfo,
  ClipInfo,
  DetectOptions as CoreDetectOptions,
  Failure as CoreFailure,
  SegmentOptions as CoreSegmentOptions,
  EvidenceInfo,
  GroundInfo,
  NoiseInfo,
  NoticeInfo,
  SegmentInfo,
  ThresholdInfo,
} from "../wasm/plantigrade";

export type {
  ActionInfo as GaitAction,
  CleanedPlantInfo as CleanedPlant,
  CurveInfo as AngleCurve,
  CutEditInfo as CutEdit,
  CutScore,
  DisagreementInfo as Disagreement,
  EditInfo as Edit,
  FootFrames,
  FormatInfo as FileFormat,
  GaitInfo as Gait,
  GroundInfo as Ground,
  InstantInfo as Instant,
  JointInfo as Joint,
  MethodInfo as DetectionMethod,
  NoticeInfo as Notice,
  Overrides,
  ScoreInfo as Score,
  SegmentInfo as Segment,
  SegmentMethodInfo as SegmentationMethod,
  SimilarInfo as Similar,
  SlideInfo as Slide,
  StepInfo as Step,
} from "../wasm/plantigrade";

/** The reason why something failed, for display. */
export interface Failure extends CoreFailure {
  /** True if the program failed, so that it may succeed when it is tried again. */
  canRetry?: boolean;
}

/** A signed axis of the file that points up. */
export type Up = ClipInfo["up"];
export type Side = "left" | "right";
export type Part = "contact" | "toe" | "heel";

/** The colour theme, or that of the system. */
export type ThemeChoice = "system" | "light" | "dark";

/** Options of a detection, as the panel shows them. */
export type DetectOptions = CoreDetectOptions &
  Required<Pick<CoreDetectOptions, "method" | "r" | "w">>;

/** Options of a segmentation, as the panel shows them. */
export type SegmentOptions = CoreSegmentOptions & Required<Pick<CoreSegmentOptions, "method">>;

/** The outcome of a call that may fail for a reason that concerns the user. */
export type Result<T> = ({ ok: true } & T) | { ok: false; failure: Failure };

/** Receives the completed fraction, 0 to 1. */
export type OnProgress = (fraction: number) => void;

/** A clip as read, with its description. */
export interface Clip extends ClipInfo {
  name: string;
  /** max(frames, 1) × joints × 3; the rest pose if there is no motion. */
  positions: Float32Array;
}

/** Labels and signals of one part (contact, toe or heel) of one foot. */
export interface Track {
  /** 0 or 1 per frame. */
  planted: Uint8Array;
  /** Probability that the label is correct, per frame, 0.5 to 1. */
  confidence: Float32Array;
  /** Plants as frame ranges: start, end, start, end, …. */
  intervals: Uint32Array;
  /**
   * For each interval the time of the foot strike, its uncertainty (standard deviation), the time of
   * the foot off and its uncertainty, in seconds; NaN where an instant is known to the frame only.
   */
  instants: Float64Array;
  /** For each interval 1 if an edit determines it, else 0. */
  edited: Uint8Array;
  /** Ranges of planted frames with a confidence below 0.75: start, end, start, end, …. */
  uncertain: Uint32Array;
  /** Height of the part above the ground, in metres, per frame. */
  height: Float32Array;
  /** Speed of the part, in m/s, per frame. */
  speed: Float32Array;
  /** Summaries of both curves, for drawing. */
  summaries: Record<"height" | "speed", CurveSummary>;
}

/** The fields of a track that edits change. */
export type Labels = Pick<
  Track,
  "planted" | "confidence" | "intervals" | "instants" | "edited" | "uncertain"
>;

/** The labels with edits applied, of every detected part. */
export type EditedParts = Partial<Record<Part, Record<Side, Labels>>>;

export interface Tracks {
  left: Track;
  right: Track;
}

export interface Detection {
  /** Options of the detection. */
  options: DetectOptions;
  /** Labelled parts: contact, toe and heel, or toe only, or contact only. */
  parts: Partial<Record<Part, Tracks>>;
  /** Height of the ground in the positions of the clip, in metres. */
  floor: number;
  /** Ground on which the feet stand, in the positions of the clip. */
  ground: GroundInfo;
  /** Noise of planted feet; undefined if no foot is planted. */
  noise?: NoiseInfo;
  notices: NoticeInfo[];
}

/** A height in metres and a speed in m/s. */
export interface HeightSpeed {
  height: number;
  speed: number;
}

/** The evidence for the labels of one part. */
export interface Evidence {
  part: Part;
  /** Thresholds on height and speed, if the method has any. */
  thresholds: ThresholdInfo;
  /** The clustering of the samples, if the method clusters them. */
  clustering?: Clustering;
}

/** A clustering of the samples of both feet by a threshold on their decision values. */
export interface Clustering extends EvidenceInfo {
  /** Number of samples. */
  count: number;
  /** Indices of the following values in the sorted norms: evenly spaced, and the knee. */
  ranks: Float32Array;
  /** Norm at each of these indices. */
  norms: Float32Array;
  /** Variance of the sorted norms up to each of these indices. */
  variances: Float32Array;
  /** Norm and decision value per frame of the clip; NaN where a frame was not clustered. */
  feet: Record<Side, { norms: Float32Array; values: Float32Array }>;
  /** Decision values of arbitrary heights and speeds, if the method defines them. */
  field?: DecisionField;
}

/** Decision values on a grid of heights and speeds whose steps grow quadratically. */
export interface DecisionField {
  /** Largest height and speed of the grid. */
  max: HeightSpeed;
  /** Points per axis; point i is at (i / (size − 1))² of the maximum. */
  size: number;
  /** size × size, row by row of constant height. */
  values: Float32Array;
}

/** The curve that a segmentation method evaluates. */
export interface Curve {
  title: string;
  /** Positions of the values, in fractional frames, ascending. */
  frames: Float32Array;
  values: Float32Array;
  /** Threshold at each value; empty if there is none. */
  threshold: Float32Array;
  /** Indices of the extrema, if the method uses them. */
  extrema: Uint32Array;
}

export interface Segmentation {
  /** Options of the segmentation. */
  options: SegmentOptions;
  /** In order; they cover the clip without gaps. */
  segments: readonly SegmentInfo[];
  /** The segments before cuts were edited; absent if none were. */
  detected?: readonly SegmentInfo[];
  /** Transitions between actions: start, end, start, end, …. */
  transitions: Uint32Array;
  /** Motifs, the intervals between turning points: start, end, start, end, …. */
  motifs: Uint32Array;
  /** Class of each motif, from 1; similar motifs share a class. */
  classes: Uint32Array;
  curve: Curve;
  notices: NoticeInfo[];
}

/** Reference labels: 1 planted, 0 not planted, −1 unknown, per frame. */
export interface Annotation {
  name: string;
  parts: Partial<Record<Part, Record<Side, Int8Array>>>;
}

/** Reference segments; they cover the clip without gaps. */
export interface SegmentAnnotation {
  name: string;
  segments: readonly SegmentInfo[];
}

/** The clip without foot skate. */
export interface CleanedClip {
  /** Same layout as `Clip.positions`. */
  positions: Float32Array;
  /** Result for every plant: those of the left foot, then those of the right. */
  plants: readonly CleanedPlantInfo[];
  notices: NoticeInfo[];
}

/** A part of the clip that is saved as a file. */
export interface ClipPart {
  name: string;
  start: number;
  end: number;
}
