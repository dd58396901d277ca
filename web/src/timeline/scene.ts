import type { PlantRef } from "../model/edits";
import type { Plant } from "../model/plants";
import type { NamedSegment } from "../model/segments";
import type { TimeView } from "../model/time-view";
import type { SegmentAnnotation, Segmentation, Tracks } from "../model/types";
import type { CanvasTheme } from "../ui/canvas-theme";
import type { Layout } from "./layout";

/** All that a picture of the timeline depends on. */
export interface Scene {
  layout: Layout;
  ink: CanvasTheme;
  view: TimeView;
  frames: number;
  rate: number;
  width: number;
  plants: readonly Plant[];
  /** The part of the feet that the plants are of. */
  tracks: Tracks | undefined;
  segmentation: Segmentation | null;
  namedSegments: readonly NamedSegment[];
  /** The action that is looped. */
  loopedSegment: NamedSegment | undefined;
  referenceSegments: SegmentAnnotation | null;
  loop: TimeView | null;
  /** The bar that is edited, as it is or as a drag would leave it. */
  selected: PlantRef | null;
}

/** Room at the right edge, so that the last number and the playhead's handle are whole. */
export const margin = 14;

export const font = (size: number, weight = 450) =>
  `${weight} ${size}px "Inter Variable", system-ui, sans-serif`;
