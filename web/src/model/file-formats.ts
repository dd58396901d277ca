/** How files that are saved end, and what they are. */

import type { SaveFormat, SegmentFormat } from "./types";

type FileFormat = readonly [suffix: string, type: string];

export const labelFormats: Record<SaveFormat, FileFormat> = {
  json: [".plants.json", "application/json"],
  csv: [".frames.csv", "text/csv"],
  intervals: [".intervals.csv", "text/csv"],
  events: [".events.csv", "text/csv"],
  npz: [".contacts.npz", "application/zip"],
  blender: [".blender.py", "text/x-python"],
};

export const segmentFormats: Record<SegmentFormat, FileFormat> = {
  json: [".segments.json", "application/json"],
  csv: [".segments.csv", "text/csv"],
  babel: [".babel.json", "application/json"],
};
