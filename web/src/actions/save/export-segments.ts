/** Saving segments. */

import { engine } from "../../engine";
import { segmentFileNames } from "../../model/segments/file-names";
import { segmentTitle } from "../../model/segments/segments";
import type { FileFormat } from "../../model/types";
import { runJob } from "../../store/jobs";
import { namedSegments } from "../../store/session";
import { segmentingDone } from "../analyse/segment";
import { download, ofOpenClip } from "./download";
import { downloadAs, stem } from "./export";

/**
 * Downloads the segments under their names. The worker writes those of the chosen method, so their names are known
 * when they are shown.
 */
export async function exportSegments(format: FileFormat): Promise<void> {
  const save = () => {
    const names = namedSegments.value.map(segmentTitle);
    const actions = namedSegments.value.map(({ action = "" }) => action);
    return engine.saveSegments(format.name, names, actions);
  };
  await downloadAs(format, save, segmentingDone);
}

/** Downloads an archive with each segment as a BVH file. */
export async function exportClips(): Promise<void> {
  const cut = () => {
    const names = segmentFileNames(namedSegments.value, stem());
    const parts = namedSegments.value.map(({ start, end }, i) => ({
      name: names[i] ?? "",
      start,
      end,
    }));
    return runJob({ title: "Cutting" }, new AbortController(), (options) =>
      engine.cut(parts, options),
    );
  };
  await download(`${stem()}.segments.zip`, ofOpenClip(cut, segmentingDone));
}
