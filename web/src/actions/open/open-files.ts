/** Opening dropped, picked or pasted files. */

import { labelsForTable, tableVisible } from "../../store/batch";
import { isHosted } from "../../store/embedded";
import { reportOpenFailure } from "../../store/errors";
import { showToast } from "../../store/toasts";
import { dialog } from "../../store/view";
import { runBatch } from "../analyse/batch";
import { compareWithAll } from "../analyse/compare";
import { openVideo } from "../view/video";
import { attachLabels, collectFiles, type DroppedFiles } from "./collect-files";
import { replaceTable } from "./history";
import { openSource } from "./open";

/** Aborted when other files are dropped while these are collected. */
let controller = new AbortController();

/**
 * Opens one clip with the labels and the video that were dropped with it, or several clips in a table, whose
 * videos are not shown.
 */
export async function openFiles(dropped: DroppedFiles): Promise<void> {
  controller.abort();
  controller = new AbortController();
  const { signal } = controller;
  // It would cover what is opened.
  dialog.value = null;
  const collected = await collectFiles(dropped);
  if (signal.aborted || !collected) return;
  const { clips, labels, videos, errors } = collected;
  if (isHosted && clips.length) {
    showToast({
      text: "This page shows the clip of its cell in the notebook. To show another clip, use another cell.",
    });
    return;
  }
  const [clip, ...others] = clips;
  if (others.length || (errors.length && clip) || errors.length > 1) {
    const matched = attachLabels(clips, labels);
    reportVideos(videos);
    await runBatch(matched.clips, [...errors, ...matched.errors]);
    return;
  }
  const [error] = errors;
  if (error) reportOpenFailure(error.name, error.failure, { retry: () => void openFiles(dropped) });
  const addToClip = () => {
    const [video, ...others] = videos;
    if (video) openVideo(video);
    reportVideos(others);
    return compareWithAll(labels);
  };
  if (clip) {
    const showClip = replaceTable();
    const whenOpen = () => {
      showClip();
      return addToClip();
    };
    await openSource(clip, { whenOpen });
  } else if (tableVisible.value) {
    reportVideos(videos);
    labelsForTable.value = labels;
  } else await addToClip();
}

/** Reports videos that are not shown. */
function reportVideos(videos: readonly File[]) {
  if (!videos.length) return;
  const names = videos.map(({ name }) => name).join(", ");
  showToast({
    text: `${names} not opened: one video is shown next to one clip. Open its clip, then drop the video.`,
  });
}
