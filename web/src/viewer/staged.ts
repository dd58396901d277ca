import { signal } from "@preact/signals";
import type { CameraView } from "../app/state";
import type { Showing } from "../lib/showing";
import type { Stage } from "./stage";

/** The stage, once there is one: for whoever asks what it shows. */
export const staged = signal<Stage | null>(null);

/** What a link says of the camera; nothing of what it does by itself. */
export function sightNow(view: CameraView): Pick<Showing, "view" | "eye" | "at"> {
  const named = view === "perspective" ? {} : { view };
  return { ...named, ...staged.peek()?.sight(view) };
}
