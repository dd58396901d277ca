/** Settings of detection and segmentation; they do not change when another clip is opened. */

import { signal } from "@preact/signals";
import { sensitivity } from "../model/plants/sensitivity";
import type {
  DetectionMethod,
  DetectOptions,
  FileFormat,
  SegmentationMethod,
  SegmentOptions,
} from "../model/types";

/** Options of the next detection. */
export const detectOptions = signal<DetectOptions>({
  method: "robust",
  r: sensitivity.default,
  w: 1,
});

/** Options of the next segmentation. */
export const segmentOptions = signal<SegmentOptions>({ method: "auto" });

/** All detection methods, the default first; empty until the worker has listed them. */
export const detectMethods = signal<readonly DetectionMethod[]>([]);

/** All segmentation methods, the default first; empty until the worker has listed them. */
export const segmentMethods = signal<readonly SegmentationMethod[]>([]);

/** All file formats of plants, the default first; empty until the worker has listed them. */
export const plantFormats = signal<readonly FileFormat[]>([]);

/** All file formats of gait, the default first; empty until the worker has listed them. */
export const gaitFormats = signal<readonly FileFormat[]>([]);

/** All file formats of segments, the default first; empty until the worker has listed them. */
export const segmentFormats = signal<readonly FileFormat[]>([]);
