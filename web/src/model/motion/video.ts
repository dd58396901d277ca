/** A video next to the clip: its alignment with the clip, and the record of it that the browser stores. */

/** Alignment of a video with a clip. */
export interface VideoAlignment {
  /** Time of the clip at which the video begins, in seconds; negative if the video begins before the clip. */
  offset: number;
  /** Seconds of the video per second of the clip; 0.25 for a video that shows a quarter of real time per second. */
  rate: number;
}

/** A video next to a clip. */
export interface Video extends VideoAlignment {
  /** Name and size of the file. */
  name: string;
  size: number;
  /** Object URL of the file; absent after a reload, until the user chooses the file again. */
  url?: string;
  /** Reason why the video cannot be shown. */
  problem?: string;
}

export const defaultAlignment: VideoAlignment = { offset: 0, rate: 1 };

/** Limits of the rate. */
export const videoRates = { min: 0.01, max: 100 } as const;

/** Largest absolute offset, in seconds: a day. */
export const maxVideoOffset = 86_400;

/** Returns the time of the video, in seconds, at a moment of the clip in frames. */
export const toVideoTime = (moment: number, clipRate: number, { offset, rate }: VideoAlignment) =>
  (moment / clipRate - offset) * rate;

/** Returns the moment of the clip, in frames, at a time of the video in seconds. */
export const toMoment = (time: number, clipRate: number, { offset, rate }: VideoAlignment) =>
  (time / rate + offset) * clipRate;

/** Version of the stored records. */
const currentVersion = 1;

/** Returns the text of the record of a video: its name, size and alignment, not its content. */
export function formatStoredVideo({ name, size, offset, rate }: Video): string {
  return JSON.stringify({ version: currentVersion, name, size, offset, rate });
}

/** Parses the record of a video; undefined if there is none or it is invalid. */
export function parseStoredVideo(text: string | null): Video | undefined {
  let value: unknown;
  try {
    value = JSON.parse(text ?? "null");
  } catch {
    return undefined;
  }
  if (typeof value !== "object" || value === null) return undefined;
  const { version, name, size, offset, rate } = value as Record<string, unknown>;
  const isValid =
    version === currentVersion &&
    typeof name === "string" &&
    Number.isInteger(size) &&
    isOffset(offset) &&
    isVideoRate(rate);
  return isValid ? { name, size: Number(size), offset, rate } : undefined;
}

export const isOffset = (value: unknown): value is number =>
  typeof value === "number" && Math.abs(value) <= maxVideoOffset;

export const isVideoRate = (value: unknown): value is number =>
  typeof value === "number" && value >= videoRates.min && value <= videoRates.max;
