import type { TimeView } from "../model/motion/time-view";
import type { PlantRef } from "../model/plants/edits";
import type { Plant } from "../model/plants/plants";
import type { NamedSegment } from "../model/segments/segments";
import type { Edit, SegmentAnnotation, Segmentation, Tracks } from "../model/types";
import type { CanvasTheme } from "../ui/canvas-theme";
import type { Layout } from "./layout";

/** All data that the timeline canvas shows. */
export interface Scene {
  layout: Layout;
  theme: CanvasTheme;
  view: TimeView;
  frames: number;
  rate: number;
  /** Width of the canvas, in CSS pixels. */
  width: number;
  plants: readonly Plant[];
  /** Tracks of the part that defines the plants. */
  tracks: Tracks | undefined;
  segmentation: Segmentation | null;
  namedSegments: readonly NamedSegment[];
  /** The looped segment. */
  loopedSegment: NamedSegment | undefined;
  /** The selected cut; while it is dragged, where it would be. */
  selectedCut: number | null;
  referenceSegments: SegmentAnnotation | null;
  /** The looped frames. */
  loop: TimeView | null;
  /** The selected bar; while an edge is dragged, with the preview of the edge. */
  selected: PlantRef | null;
  /** The edge of the selected bar that keys move. */
  selectedEdge: "start" | "end" | null;
  /** Changes of labels that are offered. */
  similar: readonly Edit[];
}

/** Margin at the right edge for the last number and the handle of the playhead, in pixels. */
export const margin = 14;

/** Returns the CSS font of canvas text; `size` is in pixels. */
export const font = (size: number, weight = 450) =>
  `${weight} ${size}px "Inter Variable", system-ui, sans-serif`;
