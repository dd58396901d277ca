import { safeFileName, startOf } from "../../util/file-names";
import type { NamedSegment } from "./segments";

/** Returns a file name for each segment, in order: `walk-03-turn.bvh`. */
export function segmentFileNames(segments: readonly NamedSegment[], clip: string): string[] {
  const digits = Math.max(2, String(segments.length).length);
  return segments.map((segment) => {
    // Names may contain characters that file systems do not allow.
    const suffix = segment.name
      .trim()
      .replace(/[^\p{L}\p{N}]+/gu, "-")
      .replace(/^-|-$/g, "");
    const parts = [safeFileName(clip), String(segment.number).padStart(digits, "0"), suffix];
    // File systems allow 255 bytes.
    return `${startOf(parts.filter(Boolean).join("-"), 251)}.bvh`;
  });
}
