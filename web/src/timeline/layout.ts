import type { Detection, Side, Track } from "../worker/types";

/** Bars of one part of one foot. */
export interface Bars {
  kind: "contact" | "heel" | "toe";
  side: Side;
  track: Track;
  y: number;
  height: number;
}

/** A curve of both feet. */
export interface Curves {
  kind: "height" | "speed";
  left: Track;
  right: Track;
  y: number;
  height: number;
}

export type Lane = Bars | Curves;

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
  ruler: 26,
  contact: 12,
  bar: 16,
  gap: 3,
  group: 10,
  curve: 40,
  map: 18,
};
const narrow = {
  labels: 100,
  ruler: 26,
  contact: 16,
  bar: 28,
  gap: 3,
  group: 10,
  curve: 48,
  map: 28,
};

/**
 * The lanes from top to bottom: per foot contact, heel and toe, whichever the method
 * knows, then as many curves as find room, which share what is left.
 */
export function layOut(detection: Detection | null, width: number, room: number): Layout {
  const size = width <= 720 ? narrow : wide;
  const lanes: Lane[] = [];
  let y = size.ruler + 6;
  if (detection) {
    const { contact, heel, toe } = detection.parts;
    for (const side of ["left", "right"] as const) {
      const parts = [
        ["contact", contact?.[side], size.contact],
        ["heel", heel?.[side], size.bar],
        ["toe", toe[side], size.bar],
      ] as const;
      for (const [kind, track, height] of parts) {
        if (!track) continue;
        lanes.push({ kind, side, track, y, height });
        y += height + size.gap;
      }
      y += size.group - size.gap;
    }
    const left = room - y - size.map - 12;
    const fit = Math.min(Math.floor(left / (size.curve + 8)), 2);
    const height = Math.min(left / Math.max(fit, 1) - 8, size.curve + 60);
    for (const kind of (["height", "speed"] as const).slice(0, Math.max(fit, 0))) {
      lanes.push({ kind, left: toe.left, right: toe.right, y, height });
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
