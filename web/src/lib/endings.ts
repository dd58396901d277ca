/** How files that are saved end, and what they are. */

import type { SaveFormat, SegmentFormat } from "../worker/types";

type Ending = readonly [suffix: string, type: string];

export const labelEndings: Record<SaveFormat, Ending> = {
  json: [".plants.json", "application/json"],
  csv: [".frames.csv", "text/csv"],
  intervals: [".intervals.csv", "text/csv"],
  events: [".events.csv", "text/csv"],
  npz: [".contacts.npz", "application/zip"],
  blender: [".blender.py", "text/x-python"],
};

export const segmentEndings: Record<SegmentFormat, Ending> = {
  json: [".segments.json", "application/json"],
  csv: [".segments.csv", "text/csv"],
  babel: [".babel.json", "application/json"],
};
