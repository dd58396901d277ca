import { principalPart } from "../model/plants/plants";
import type { Companion } from "../model/sources/source";
import type {
  Annotation,
  Detection,
  Part,
  SegmentAnnotation,
  Segmentation,
  Side,
  Track,
} from "../model/types";
import type { TrackGroup } from "../store/preferences";

/** Contact intervals of one part of one foot. */
export interface Bars {
  kind: Part;
  side: Side;
  track: Track;
  /** True for the part that defines the plants, whose bars are higher and numbered. */
  isPrincipal: boolean;
  y: number;
  height: number;
}

/** Reference labels of one part of one foot. */
export interface ReferenceBars {
  kind: "reference";
  side: Side;
  name: string;
  /** 1 planted, 0 not, −1 unknown, per frame. */
  labels: Int8Array;
  /** The labels that are compared with the reference. */
  track: Track | undefined;
  y: number;
  height: number;
}

/** The plants of a comparison clip. */
export interface CompanionBars {
  kind: "companion";
  companion: Companion;
  y: number;
  height: number;
}

/** Height or speed curves of both feet. */
export interface Curves {
  kind: "height" | "speed";
  part: Part;
  left: Track;
  right: Track;
  y: number;
  height: number;
}

/** The segments, their motifs, the reference segments, or the curve of the segmentation method. */
export interface SegmentLane {
  kind: "segments" | "motifs" | "reference-segments" | "curve";
  y: number;
  height: number;
}

export type Lane = Bars | ReferenceBars | CompanionBars | Curves | SegmentLane;

export const isBars = (lane: Lane): lane is Bars => "isPrincipal" in lane;
export const isCurves = (lane: Lane): lane is Curves =>
  lane.kind === "height" || lane.kind === "speed";

/** Data that determines which lanes are shown. */
export interface LayoutInput {
  detection: Detection | null;
  reference: Annotation | null;
  segmentation: Segmentation | null;
  referenceSegments: SegmentAnnotation | null;
  /** Comparison clips. */
  companions: readonly Companion[];
  /** Groups of tracks that the user has hidden. */
  hidden: readonly TrackGroup[];
  /** True if lanes are touched by fingers. */
  isTouch: boolean;
}

/** Tracks that are left out if the timeline is too small for all. */
export type OmittedTrack =
  | "parts"
  | "references"
  | "companions"
  | "height"
  | "speed"
  | "segments"
  | "curve";

export interface Layout {
  lanes: readonly Lane[];
  /** Tracks that do not fit, without those that the user has hidden. */
  omitted: readonly OmittedTrack[];
  /** Position of the minimap below the lanes, in CSS pixels. */
  minimap: { y: number; height: number };
  ruler: { height: number };
  /** Width of the label column, in pixels. */
  labelWidth: number;
  height: number;
}

/** A lane without its vertical position. */
type WithoutY<T> = T extends unknown ? Omit<T, "y"> : never;

/** Sizes for a pointer, for fingers, and for fingers on a short page. */
const wideSizes = {
  labelWidth: 118,
  ruler: 30,
  principal: 22,
  part: 9,
  reference: 9,
  companion: 16,
  segments: 20,
  motifs: 13,
  referenceSegments: 14,
  gap: 3,
  group: 10,
  curve: 30,
  minimap: 18,
  bottom: 10,
};
const narrowSizes: Sizes = {
  ...wideSizes,
  labelWidth: 100,
  principal: 32,
  part: 24,
  reference: 10,
  companion: 12,
  segments: 28,
  motifs: 14,
  referenceSegments: 16,
  curve: 34,
  minimap: 28,
};
const shortSizes: Sizes = {
  ...narrowSizes,
  principal: 28,
  part: 20,
  segments: 24,
  group: 7,
  minimap: 24,
};

/** Sizes in landscape on a phone: both feet and the segments fit. */
const landscapeSizes: Sizes = { ...shortSizes, segments: 20, group: 5, minimap: 18 };

/** Sizes if these do not suffice: both feet with their references and the segments fit. */
const denseSizes: Sizes = {
  ...landscapeSizes,
  ruler: 24,
  reference: 8,
  companion: 8,
  segments: 16,
  group: 3,
  minimap: 14,
  bottom: 6,
};

type Sizes = typeof wideSizes;

/** Wider timelines have the sizes for a pointer, unless they are touched. */
const maxNarrowWidth = 560;

/** Returns the sizes that are possible, the largest first. */
function possibleSizes(width: number, availableHeight: number, isTouch: boolean): Sizes[] {
  const isNarrow = width <= maxNarrowWidth;
  if (!isNarrow && !isTouch) return [wideSizes, denseSizes];
  const { labelWidth } = isNarrow ? narrowSizes : wideSizes;
  const largest = availableHeight < 170 ? 2 : availableHeight < 300 ? 1 : 0;
  return [narrowSizes, shortSizes, landscapeSizes, denseSizes]
    .slice(largest)
    .map((size) => ({ ...size, labelWidth }));
}

/** Greatest height of a curve lane beyond its minimum, in pixels. */
const maxCurveGrowth = 44;

const partOrder = ["contact", "heel", "toe"] as const;

/**
 * Lays out the lanes from top to bottom: for each foot the principal part and the others as far as they
 * are labelled, each above its reference; comparison clips; curves of the feet; segments, motifs and
 * reference segments; the curve of the segmentation method. Curves divide the remaining height evenly, and
 * are left out if it is too small, as are the parts that do not define the plants, then the segments and then
 * comparison clips; `omitted` lists what is left out. Sizes are in CSS pixels.
 */
export function layoutTimeline(input: LayoutInput, width: number, availableHeight: number): Layout {
  const { detection, reference, hidden } = input;
  const parts = detection?.parts ?? {};
  const principal = principalPart(parts);
  const possible = possibleSizes(width, availableHeight, input.isTouch);
  const fits = (size: Sizes) => {
    const { feet, companions, segments } = minHeights(input, size);
    return feet + companions + segments <= availableHeight;
  };
  const size = possible.find(fits) ?? (possible.at(-1) as Sizes);
  const needed = minHeights(input, size);
  // On a very short timeline the feet come first, then the comparison clips.
  const allSegments = segmentLanes(input, size);
  const segments = fits(size) || !principal ? allSegments : [];
  const segmentsHeight = segments.length ? needed.segments : 0;
  const companions = input.companions.slice(
    0,
    companionCount(size, availableHeight - needed.feet - segmentsHeight),
  );
  const companionsHeight = companionLanesHeight(companions.length, size);
  const reservedHeight = size.minimap + size.bottom + segmentsHeight;
  const referenced =
    detection && reference ? partOrder.filter((part) => reference.parts[part]) : [];
  const wantedParts = partOrder.filter(
    (part) => parts[part] && (part === principal || !hidden.includes("parts")),
  );
  const visible = visibleParts(
    wantedParts,
    referenced,
    principal,
    size,
    availableHeight - reservedHeight - companionsHeight,
  );
  const lanes: Lane[] = [];
  let y = size.ruler + 6;
  const add = (lane: WithoutY<Exclude<Lane, Curves>>) => {
    lanes.push({ ...lane, y });
    y += lane.height + size.gap;
  };
  for (const side of ["left", "right"] as const) {
    const laneCount = lanes.length;
    for (const kind of partOrder) {
      const track = parts[kind]?.[side];
      const isPrincipal = kind === principal;
      if (track && visible.parts.includes(kind))
        add({ kind, side, track, isPrincipal, height: isPrincipal ? size.principal : size.part });
      const labels = visible.referenced.includes(kind) && reference?.parts[kind]?.[side];
      if (reference && labels) {
        const { name } = reference;
        add({ kind: "reference", side, name, labels, track, height: size.reference });
      }
    }
    if (lanes.length > laneCount) y += size.group - size.gap;
  }
  for (const companion of companions) {
    add({ kind: "companion", companion, height: size.companion });
  }
  if (companions.length) y += size.group - size.gap;
  const part = parts.toe ? "toe" : principalPart(parts);
  const tracks = part && parts[part];
  const remaining = availableHeight - y - reservedHeight - 2;
  const wantedCurves: ("height" | "curve" | "speed")[] = [];
  if (!hidden.includes("curves")) {
    if (tracks) wantedCurves.push("height");
    if (input.segmentation?.curve.values.length) wantedCurves.push("curve");
    if (tracks) wantedCurves.push("speed");
  }
  const curveCount = Math.min(
    Math.max(0, Math.floor(remaining / (size.curve + 8))),
    wantedCurves.length,
  );
  const height = Math.min(remaining / Math.max(curveCount, 1) - 8, size.curve + maxCurveGrowth);
  const visibleCurves = wantedCurves.slice(0, curveCount);
  for (const kind of ["height", "speed"] as const) {
    if (!tracks || !visibleCurves.includes(kind)) continue;
    lanes.push({ kind, part, left: tracks.left, right: tracks.right, y, height });
    y += height + 8;
  }
  // Without labels a message replaces the lanes of the feet.
  if (!lanes.length) y = availableHeight - reservedHeight - (curveCount ? height + 8 : 0);
  for (const lane of segments) add(lane);
  if (visibleCurves.includes("curve")) {
    add({ kind: "curve", height });
    y += 8 - size.gap;
  } else if (segments.length) y += size.gap;
  const omitted: OmittedTrack[] = wantedCurves.slice(curveCount);
  if (segments.length < allSegments.length) omitted.unshift("segments");
  if (companions.length < input.companions.length) omitted.unshift("companions");
  if (visible.referenced.length < referenced.length) omitted.unshift("references");
  if (visible.parts.length < wantedParts.length) omitted.unshift("parts");
  const minimapY = Math.max(y, availableHeight - size.minimap - size.bottom);
  return {
    lanes,
    omitted,
    minimap: { y: minimapY, height: size.minimap },
    ruler: { height: size.ruler },
    labelWidth: size.labelWidth,
    height: minimapY + size.minimap + size.bottom,
  };
}

/**
 * Returns the heights of what is not left out if it fits: ruler, principal part of both feet and minimap, each
 * foot with one reference; comparison clips; segments.
 */
function minHeights(input: LayoutInput, size: Sizes) {
  const { detection, reference, companions } = input;
  const referenceHeight = reference ? size.reference + size.gap : 0;
  const footHeight = size.principal + size.group + referenceHeight;
  const feetHeight = principalPart(detection?.parts ?? {}) ? 2 * footHeight : 0;
  const segments = segmentLanes(input, size);
  return {
    feet: size.ruler + 6 + feetHeight + size.minimap + size.bottom,
    companions: companionLanesHeight(companions.length, size),
    segments: segments.reduce(
      (sum, { height }) => sum + height + size.gap,
      segments.length ? size.gap : 0,
    ),
  };
}

/** Returns the height of the lanes of comparison clips. */
const companionLanesHeight = (count: number, size: Sizes) =>
  count ? count * (size.companion + size.gap) + size.group - size.gap : 0;

/** Returns how many comparison clips fit. */
const companionCount = (size: Sizes, availableHeight: number) =>
  Math.max(0, Math.floor((availableHeight - size.group + size.gap) / (size.companion + size.gap)));

/** Returns the lanes of segments, without the curve. */
function segmentLanes({ segmentation, referenceSegments, hidden }: LayoutInput, size: Sizes) {
  if (hidden.includes("segments")) return [];
  const lanes: Omit<SegmentLane, "y">[] = [];
  if (segmentation) lanes.push({ kind: "segments", height: size.segments });
  if (segmentation?.motifs.length) lanes.push({ kind: "motifs", height: size.motifs });
  if (referenceSegments) lanes.push({ kind: "reference-segments", height: size.referenceSegments });
  return lanes;
}

/**
 * Returns the parts of the feet and of the reference that fit: all, else one reference, else the principal
 * part alone.
 */
function visibleParts(
  parts: readonly Part[],
  referenced: readonly Part[],
  principal: Part | undefined,
  size: Sizes,
  availableHeight: number,
) {
  const fits = (shown: readonly Part[], compared: readonly Part[]) => {
    const heights = shown.map((part) => (part === principal ? size.principal : size.part));
    const barsHeight = heights.reduce((sum, height) => sum + height + size.gap, 0);
    const footHeight = barsHeight + compared.length * (size.reference + size.gap) + size.group;
    return size.ruler + 6 + 2 * footHeight <= availableHeight;
  };
  const firstReferenced = partOrder.filter((part) => referenced.includes(part)).slice(0, 1);
  const main = parts.filter((part) => part === principal);
  if (fits(parts, referenced)) return { parts, referenced };
  if (fits(parts, firstReferenced)) return { parts, referenced: firstReferenced };
  return { parts: main, referenced: firstReferenced };
}
