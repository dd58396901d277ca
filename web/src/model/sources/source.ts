import type { AnyEdit } from "../segments/cut-edits";
import type { SegmentName } from "../segments/segments";
import type { ViewState } from "../stored/view-state";
import type { Clip, Detection, Notice } from "../types";
import type { Origin } from "./link";

/** A clip that can be opened: a dropped file, a sample or a download. */
export interface Source {
  name: string;
  /** Folder in what was dropped, ending with a slash; empty for a single file. */
  folder?: string;
  /** Folder and name, if another clip of the drop has the same name. */
  title?: string;
  data: Blob;
  /** Notices on how the file was obtained. */
  notices?: readonly Notice[];
  /** URL of reference labels, if any. */
  truthUrl?: string;
  /** Public address of the clip; absent for a local file. */
  origin?: Origin;
  /** True if values that are not numbers were replaced by those of the previous frame. */
  lenient?: boolean;
  /** View and settings of a link or a shared page. */
  view?: ViewState;
  /** Edits and names in a shared page; `id` distinguishes several shares of one clip. */
  shared?: { id: string; edits: readonly AnyEdit[]; names: readonly SegmentName[] };
  /** Labels and segments of the same drop whose file names start with that of the clip. */
  labels?: readonly Source[];
}

/** Returns the name of a clip, with its folder if another clip of the drop has the same name. */
export const titleOfSource = ({ title, name }: Pick<Source, "title" | "name">) => title ?? name;

/** Another clip that is shown side by side with the open one. */
export interface Companion {
  source: Source;
  /** The clip that was open when this one was added. */
  addedTo: Source | null;
  /** Number of the table from which it was added. */
  table: number;
  clip: Clip;
  /** Null if the clip has no feet. */
  detection: Detection | null;
}
