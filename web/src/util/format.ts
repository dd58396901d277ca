/** Formats a time: `0:12.875`, or `1:02:05.000` from one hour. */
export function formatClock(seconds: number): string {
  const total = Math.max(0, Math.round(seconds * 1000));
  const ms = String(total % 1000).padStart(3, "0");
  const s = String(Math.floor(total / 1000) % 60).padStart(2, "0");
  const minutes = Math.floor(total / 60_000);
  if (minutes < 60) return `${minutes}:${s}.${ms}`;
  const m = String(minutes % 60).padStart(2, "0");
  return `${Math.floor(minutes / 60)}:${m}:${s}.${ms}`;
}

/** Formats a duration: `0.42 s`, `31.0 s`, `12 min 5 s`. */
export function formatDuration(seconds: number): string {
  if (seconds < 10) return `${seconds.toFixed(2)} s`;
  if (seconds < 60) return `${seconds.toFixed(1)} s`;
  const rounded = Math.round(seconds);
  return `${Math.floor(rounded / 60)} min ${rounded % 60} s`;
}

/** Formats a frame rate without trailing zeros: `120 Hz`, `59.94 Hz`. */
export function formatRate(rate: number): string {
  return `${Number(rate.toFixed(2))} Hz`;
}

/**
 * Formats a half-open range of frames as users count them, with its first and its last frame:
 * `12–40`, or `12` for a single frame.
 */
export function formatRange({ start, end }: { start: number; end: number }): string {
  return end - start > 1 ? `${formatCount(start)}–${formatCount(end - 1)}` : formatCount(start);
}

/** Describes a half-open range of frames for screen readers: `frames 12 to 40`, `frame 12`. */
export function spokenRange({ start, end }: { start: number; end: number }): string {
  return end - start > 1 ? `frames ${start} to ${end - 1}` : `frame ${start}`;
}

/** Formats a number with a fixed number of decimals and a minus sign: `−0.5`; never `−0`. */
export function formatNumber(value: number, decimals: number): string {
  const text = value.toFixed(decimals);
  return Number(text) < 0 ? text.replace("-", "−") : text.replace("-", "");
}

/** Returns a text with a capital first letter. */
export const capitalize = (text: string) => text.charAt(0).toUpperCase() + text.slice(1);

/** Joins words: `height`, `height and speed`, `heel, toe and speed`. */
export const joinWords = (words: readonly string[]) =>
  [words.slice(0, -1).join(", "), ...words.slice(-1)].filter(Boolean).join(" and ");

/** Formats a count with its noun: `1 plant`, `2 plants`. */
export function plural(n: number, noun: string): string {
  return `${formatCount(n)} ${noun}${n === 1 ? "" : "s"}`;
}

/** Formats a count with thin spaces between thousands: `432 000`. */
export function formatCount(n: number): string {
  return String(n).replace(/\B(?=(\d{3})+$)/g, "\u202f");
}

/** Formats a file size: `12.4 MB`. */
export function formatBytes(n: number): string {
  if (n < 1000) return `${n} B`;
  if (n < 1e6) return `${(n / 1e3).toFixed(0)} kB`;
  if (n < 1e9) return `${(n / 1e6).toFixed(1)} MB`;
  return `${(n / 1e9).toFixed(2)} GB`;
}
