/**
 * Messages between a page in a frame and its host, the document that contains the frame: a notebook, for
 * example. The page asks for a clip when it has loaded; both then report changes of edits and settings.
 */

import type { StoredChanges } from "../batch/batch";
import type { ViewState } from "../stored/view-state";
import type { ThemeChoice } from "../types";

/** Settings that determine the labels of the method; absent ones have their default values. */
export type DetectSettings = Pick<
  ViewState,
  "method" | "r" | "w" | "height" | "speed" | "rate" | "up" | "unit" | "joints"
>;

/** State that host and page share. */
export interface HostedState extends Pick<StoredChanges, "edits" | "names"> {
  settings: DetectSettings;
}

/** A message to the page. */
export type HostMessage =
  | {
      type: "plantigrade-open";
      /** Name of the clip. */
      name: string;
      /** The clip as a BVH file. */
      data: BlobPart;
      state: HostedState;
    }
  | { type: "plantigrade-state"; state: HostedState }
  | { type: "plantigrade-theme"; theme: ThemeChoice };

/** A message to the host. */
export type PageMessage =
  | { type: "plantigrade-ready" }
  | { type: "plantigrade-state"; state: HostedState };
