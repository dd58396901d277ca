import type { Plant } from "../lib/plants";
import type { TimeView } from "../lib/timeView";
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
  loop: TimeView | null;
}

/** Room at the right edge, so that the last number and the playhead's handle are whole. */
export const margin = 14;

export const font = (size: number, weight = 450) =>
  `${weight} ${size}px "Inter Variable", system-ui, sans-serif`;
