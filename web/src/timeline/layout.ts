import { principalPart } from "../lib/plants";
import type { Detection, Labelling, Part, Side, Track } from "../worker/types";

/** Bars of one part of one foot. */
export interface Bars {
  kind: Part;
  side: Side;
  track: Track;
  y: number;
  height: number;
}

/** The same part of the same foot as someone else labels it. */
export interface OtherBars {
  kind: "other";
  side: Side;
  name: string;
  /** 1 planted, 0 not, −1 unknown, per frame. */
  labels: Int8Array;
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

export type Lane = Bars | OtherBars | Curves;

export const isBars = (lane: Lane): lane is Bars => "track" in lane;

export interface Layout {
  lanes: readonly Lane[];
  /** Where the lanes end and the minimap begins, CSS pixels. */
  minimap: { y: number; height: number };
  ruler: { height: number };
  /** Width of the label column. */
  labels: number;
  height: number;
}

/** Sizes of a wide page and of a phone, where tracks grow to be touched. */
const wide = {
  labels: 118,
  ruler: 30,
  contact: 12,
  bar: 16,
  other: 8,
  gap: 3,
  group: 10,
  curve: 40,
  map: 18,
};
const narrow = {
  labels: 100,
  ruler: 30,
  contact: 16,
  bar: 28,
  other: 10,
  gap: 3,
  group: 10,
  curve: 48,
  map: 28,
};

const order = ["contact", "heel", "toe"] as const;

/**
 * The lanes from top to bottom: per foot contact, heel and toe, whichever the method
 * knows, each with someone else's below it, then as many curves as find room, which
 * share what is left.
 */
export function layOut(
  detection: Detection | null,
  other: Labelling | null,
  width: number,
  room: number,
): Layout {
  const size = width <= 720 ? narrow : wide;
  const ours = detection?.parts ?? {};
  const compared = detection && other ? comparedParts(ours, other, size, room) : [];
  const lanes: Lane[] = [];
  let y = size.ruler + 6;
  const add = (lane: Omit<Bars, "y"> | Omit<OtherBars, "y">) => {
    lanes.push({ ...lane, y });
    y += lane.height + size.gap;
  };
  for (const side of ["left", "right"] as const) {
    const before = lanes.length;
    for (const kind of order) {
      const track = ours[kind]?.[side];
      if (track) add({ kind, side, track, height: kind === "contact" ? size.contact : size.bar });
      const labels = compared.includes(kind) && other?.parts[kind]?.[side];
      if (other && labels) {
        add({ kind: "other", side, name: other.name, labels, height: size.other });
      }
    }
    if (lanes.length > before) y += size.group - size.gap;
  }
  const part = ours.toe ? "toe" : principalPart(ours);
  const tracks = part && ours[part];
  if (tracks) {
    const left = room - y - size.map - 12;
    const fit = Math.min(Math.floor(left / (size.curve + 8)), 2);
    const height = Math.min(left / Math.max(fit, 1) - 8, size.curve + 60);
    for (const kind of (["height", "speed"] as const).slice(0, Math.max(fit, 0))) {
      lanes.push({ kind, part, left: tracks.left, right: tracks.right, y, height });
      y += height + 8;
    }
  }
  const mapY = Math.max(y, room - size.map - 10);
  return {
    lanes,
    minimap: { y: mapY, height: size.map },
    ruler: { height: size.ruler },
    labels: size.labels,
    height: mapY + size.map + 10,
  };
}

/** The parts of someone else's labels that are shown: all, or the principal one where room is short. */
function comparedParts(
  ours: Detection["parts"],
  other: Labelling,
  size: typeof wide,
  room: number,
): readonly Part[] {
  const theirs = order.filter((part) => other.parts[part]);
  const heights = order
    .filter((part) => ours[part])
    .map((part) => (part === "contact" ? size.contact : size.bar) + size.gap);
  const own = heights.reduce((sum, height) => sum + height, 0);
  const all = own + theirs.length * (size.other + size.gap) + size.group;
  const principal = principalPart(other.parts);
  const fits = size.ruler + 6 + 2 * all + size.map + 10 <= room;
  return fits ? theirs : theirs.filter((part) => part === principal);
}
