import type { Stay } from "../lib/edits";
import type { Plant } from "../lib/plants";
import type { Action } from "../lib/segments";
import type { TimeView } from "../lib/timeView";
import type { Segmentation, Segments, Tracks } from "../worker/types";
import type { Ink } from "./ink";
import type { Layout } from "./layout";

/** All that a picture of the timeline depends on. */
export interface Scene {
  layout: Layout;
  ink: Ink;
  view: TimeView;
  frames: number;
  rate: number;
  width: number;
  plants: readonly Plant[];
  /** The part of the feet that the plants are of. */
  tracks: Tracks | undefined;
  segmentation: Segmentation | null;
  actions: readonly Action[];
  /** The action that is looped. */
  chosen: Action | undefined;
  otherSegments: Segments | null;
  loop: TimeView | null;
  /** The bar that is edited, as it is or as a drag would leave it. */
  selected: Stay | null;
}

/** Room at the right edge, so that the last number and the playhead's handle are whole. */
export const margin = 14;

export const font = (size: number, weight = 450) =>
  `${weight} ${size}px "Inter Variable", system-ui, sans-serif`;
