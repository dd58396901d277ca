import { engine } from "./engine";
import { messageOf } from "./failing";
import { announcement, clip, detection, failure, openClip } from "./state";

export type SaveFormat = Parameters<typeof engine.save>[0];

const endings: Record<SaveFormat, readonly [suffix: string, type: string]> = {
  json: [".plants.json", "application/json"],
  csv: [".frames.csv", "text/csv"],
  intervals: [".intervals.csv", "text/csv"],
  events: [".events.csv", "text/csv"],
};

/** Hands the labels to the browser as a download. */
export async function save(format: SaveFormat): Promise<void> {
  if (!openClip.value || !detection.value) return;
  const name = clip.value?.name ?? "clip";
  const [suffix, type] = endings[format];
  const file = name.replace(/\.bvh$/i, "") + suffix;
  try {
    const text = await engine.save(format);
    const url = URL.createObjectURL(new Blob([text], { type }));
    const link = document.createElement("a");
    link.href = url;
    link.download = file;
    link.click();
    setTimeout(() => URL.revokeObjectURL(url), 10_000);
    announcement.value = `Saved ${file}`;
  } catch (error) {
    failure.value = { name: file, failure: { message: messageOf(error) } };
  }
}
