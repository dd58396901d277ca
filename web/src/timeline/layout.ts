import { principalPart } from "../model/plants";
import type { Companion } from "../model/source";
import type {
  Annotation,
  Detection,
  Part,
  SegmentAnnotation,
  Segmentation,
  Side,
  Track,
} from "../model/types";

/** Bars of one part of one foot. */
export interface Bars {
  kind: Part;
  side: Side;
  track: Track;
  y: number;
  height: number;
}

/** The same part of the same foot as someone else labels it. */
export interface ReferenceBars {
  kind: "reference";
  side: Side;
  name: string;
  /** 1 planted, 0 not, −1 unknown, per frame. */
  labels: Int8Array;
  y: number;
  height: number;
}

/** The plants of another clip beside ours. */
export interface CompanionBars {
  kind: "companion";
  companion: Companion;
  y: number;
  height: number;
}

/** A curve of both feet. */
export interface Curves {
  kind: "height" | "speed";
  part: Part;
  left: Track;
  right: Track;
  y: number;
  height: number;
}

/** The segments, their motifs, someone else's segments, or what the method looks at. */
export interface SegmentLane {
  kind: "segments" | "motifs" | "reference-segments" | "curve";
  y: number;
  height: number;
}

export type Lane = Bars | ReferenceBars | CompanionBars | Curves | SegmentLane;

export const isBars = (lane: Lane): lane is Bars => "track" in lane;
export const isCurves = (lane: Lane): lane is Curves => "part" in lane;

/** What there is to lay out. */
export interface LayoutInput {
  detection: Detection | null;
  reference: Annotation | null;
  segmentation: Segmentation | null;
  referenceSegments: SegmentAnnotation | null;
  /** Other clips side by side. */
  companions: readonly Companion[];
}

export interface Layout {
  lanes: readonly Lane[];
  /** Where the lanes end and the minimap begins, CSS pixels. */
  minimap: { y: number; height: number };
  ruler: { height: number };
  /** Width of the label column. */
  labels: number;
  height: number;
}

/** A lane before it has its place. */
type Placeless<T> = T extends unknown ? Omit<T, "y"> : never;

/** Sizes of a wide page, of a phone, where tracks grow to be touched, and of a short phone. */
const wide = {
  labels: 118,
  ruler: 30,
  contact: 12,
  bar: 16,
  reference: 8,
  companion: 16,
  segments: 20,
  motifs: 13,
  referenceSegments: 14,
  gap: 3,
  group: 10,
  curve: 30,
  map: 18,
};
const narrow: Sizes = {
  ...wide,
  labels: 100,
  contact: 16,
  bar: 28,
  reference: 10,
  companion: 12,
  segments: 28,
  motifs: 14,
  referenceSegments: 16,
  curve: 34,
  map: 28,
};
const short: Sizes = { ...narrow, contact: 12, bar: 24, segments: 24, group: 7, map: 24 };

type Sizes = typeof wide;

function sizesOf(width: number, room: number): Sizes {
  if (width > 720) return wide;
  return room < 300 ? short : narrow;
}

/** The tallest a curve grows, as so much more than the least. */
const grow = 44;

const order = ["contact", "heel", "toe"] as const;

/**
 * The lanes from top to bottom: per foot contact, heel and toe, whichever the method
 * knows, each with someone else's below it; clips beside; curves of the feet; the segments with their
 * motifs, someone else's and the method's curve. Curves share what room is left.
 */
export function layoutTimeline(shown: LayoutInput, width: number, room: number): Layout {
  const { detection, reference } = shown;
  const size = sizesOf(width, room);
  const ours = detection?.parts ?? {};
  const segments = segmentRows(shown, size);
  const segmentsHeight = segments.reduce((sum, { height }) => sum + height + size.gap, 0);
  const least = size.map + 10 + segmentsHeight + (segments.length ? size.gap : 0);
  const compared = detection && reference ? comparedParts(ours, reference, size, room - least) : [];
  const lanes: Lane[] = [];
  let y = size.ruler + 6;
  const add = (lane: Placeless<Exclude<Lane, Curves>>) => {
    lanes.push({ ...lane, y });
    y += lane.height + size.gap;
  };
  for (const side of ["left", "right"] as const) {
    const before = lanes.length;
    for (const kind of order) {
      const track = ours[kind]?.[side];
      if (track) add({ kind, side, track, height: kind === "contact" ? size.contact : size.bar });
      const labels = compared.includes(kind) && reference?.parts[kind]?.[side];
      if (reference && labels) {
        add({ kind: "reference", side, name: reference.name, labels, height: size.reference });
      }
    }
    if (lanes.length > before) y += size.group - size.gap;
  }
  for (const companion of shown.companions) {
    add({ kind: "companion", companion, height: size.companion });
  }
  if (shown.companions.length) y += size.group - size.gap;
  const part = ours.toe ? "toe" : principalPart(ours);
  const tracks = part && ours[part];
  const left = room - y - least - 2;
  const wanted = [
    tracks && "height",
    shown.segmentation?.curve.values.length && "curve",
    tracks && "speed",
  ].filter(Boolean);
  const fit = Math.min(Math.max(0, Math.floor(left / (size.curve + 8))), wanted.length);
  const height = Math.min(left / Math.max(fit, 1) - 8, size.curve + grow);
  const curves = wanted.slice(0, fit);
  for (const kind of ["height", "speed"] as const) {
    if (!tracks || !curves.includes(kind)) continue;
    lanes.push({ kind, part, left: tracks.left, right: tracks.right, y, height });
    y += height + 8;
  }
  // Without feet the reason for it stands where they would be.
  if (!lanes.length) y = room - least - (fit ? height + 8 : 0);
  for (const row of segments) add(row);
  if (curves.includes("curve")) {
    add({ kind: "curve", height });
    y += 8 - size.gap;
  } else if (segments.length) y += size.gap;
  const mapY = Math.max(y, room - size.map - 10);
  return {
    lanes,
    minimap: { y: mapY, height: size.map },
    ruler: { height: size.ruler },
    labels: size.labels,
    height: mapY + size.map + 10,
  };
}

/** What there is of segments but the curve. */
function segmentRows({ segmentation, referenceSegments }: LayoutInput, size: Sizes) {
  const rows: Omit<SegmentLane, "y">[] = [];
  if (segmentation) rows.push({ kind: "segments", height: size.segments });
  if (segmentation?.motifs.length) rows.push({ kind: "motifs", height: size.motifs });
  if (referenceSegments) rows.push({ kind: "reference-segments", height: size.referenceSegments });
  return rows;
}

/** The parts of someone else's labels that are shown: all, or the principal one where room is short. */
function comparedParts(
  ours: Detection["parts"],
  reference: Annotation,
  size: Sizes,
  room: number,
): readonly Part[] {
  const theirs = order.filter((part) => reference.parts[part]);
  const heights = order
    .filter((part) => ours[part])
    .map((part) => (part === "contact" ? size.contact : size.bar) + size.gap);
  const own = heights.reduce((sum, height) => sum + height, 0);
  const all = own + theirs.length * (size.reference + size.gap) + size.group;
  const principal = principalPart(reference.parts);
  const fits = size.ruler + 6 + 2 * all <= room;
  return fits ? theirs : theirs.filter((part) => part === principal);
}
