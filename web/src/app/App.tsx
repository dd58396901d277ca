import { type Signal, useSignalEffect } from "@preact/signals";
import { useEffect, useLayoutEffect } from "preact/hooks";
import { canRedo, canUndo } from "../actions/edit/edit";
import { followHistory } from "../actions/open/navigation";
import { openFromAddress } from "../actions/open/open-address";
import { openPickedFiles, setFileInput } from "../actions/open/pick-files";
import { tableVisible } from "../store/batch";
import { isHosted } from "../store/embedded";
import { phase } from "../store/phase";
import { panelCollapsed, panelWidth } from "../store/preferences";
import { clipTitle, detection, openClip, selected, selectedCut } from "../store/session";
import { hintTarget } from "../store/tour";
import { video } from "../store/video";
import { announcement, dialog, filesDragged, message, sheetOpen } from "../store/view";
import { Timeline } from "../timeline/Timeline";
import { lazy } from "../ui/lazy";
import { Progress } from "../ui/Progress";
import { setSize } from "../ui/Splitter";
import { isTouch } from "../ui/touch";
import { Viewer } from "../viewer/Viewer";
import { listenForDrops } from "./drop";
import { ErrorCard } from "./ErrorCard";
import { returnFocus } from "./focus";
import { Head } from "./Head";
import { onKey } from "./key-handler";
import { registerServiceWorker } from "./offline";
import { preloadPanels, SidePanel } from "./SidePanel";
import { StartPage } from "./StartPage";
import { Toasts } from "./Toasts";

const EditBar = lazy(() => import("../timeline/EditBar").then((module) => module.EditBar));
const VideoPane = lazy(() => import("../viewer/VideoPane").then((module) => module.VideoPane));
const Dialogs = lazy(() => import("./Dialogs").then((module) => module.Dialogs));
const Tour = lazy(() => import("./Tour").then((module) => module.Tour));
const Batch = lazy(() => import("../batch/Batch").then((module) => module.Batch));

/** Time for which a message is displayed or stays in the live region, in milliseconds. */
const messageTime = 5000;

/** Clears a text after some time. Returns a function that prevents this. */
function clearLater(text: Signal<string>) {
  if (!text.value) return undefined;
  const timer = setTimeout(() => {
    text.value = "";
  }, messageTime);
  return () => clearTimeout(timer);
}

/** The buttons for edits, if the page is used by touch and there is something to edit or to undo. */
function TouchEdits() {
  const isEditing = selected.value !== null || selectedCut.value !== null;
  return isTouch() && openClip.value && (isEditing || canUndo.value || canRedo.value) ? (
    <EditBar />
  ) : null;
}

/** The page. */
export function App() {
  // Before the first frame, which would otherwise show the start page to those who follow a link.
  useLayoutEffect(() => {
    const controller = new AbortController();
    const { signal } = controller;
    addEventListener("keydown", onKey, { signal });
    followHistory(signal);
    listenForDrops(signal);
    returnFocus(signal);
    const opened = openFromAddress();
    // The downloads of the service worker would delay the first labels of a link.
    registerServiceWorker(location.hash ? opened : Promise.resolve());
    return () => controller.abort();
  }, []);
  useSignalEffect(() => {
    if (!detection.value) return;
    preloadPanels();
    Dialogs.preload();
    VideoPane.preload();
  });
  // A text that stays in the live region would be read again, out of context.
  useSignalEffect(() => clearLater(announcement));
  useSignalEffect(() => clearLater(message));
  const clip = openClip.value;
  const title = clip ? `${clipTitle} – Plantigrade` : "Plantigrade";
  useEffect(() => {
    document.title = title;
  }, [title]);
  const width = panelWidth.value;
  return (
    <div
      class="shell"
      data-state={phase.value}
      data-clip={clip ? "open" : "none"}
      data-hint={hintTarget}
      data-panel={panelCollapsed.value ? "collapsed" : "shown"}
      data-sheet={sheetOpen.value ? "raised" : "lowered"}
      ref={(element) => setSize(element, "--panel-width", width)}
    >
      <Head />
      <main>
        {/* The table covers them. */}
        <div class="covered" inert={tableVisible.value}>
          <div class="views">
            <Viewer />
            {clip && video.value && <VideoPane />}
          </div>
          {clip ? <Timeline /> : !isHosted && <StartPage />}
          <TouchEdits />
        </div>
        <input
          ref={setFileInput}
          hidden
          type="file"
          multiple
          onChange={(event) => openPickedFiles(event.currentTarget)}
        />
        <div class="status-cards">
          <ErrorCard />
          {/* An open dialog contains it, because only the dialog can be clicked then. */}
          {!dialog.value && <Progress />}
        </div>
      </main>
      {clip && (
        <div class="covered" inert={tableVisible.value}>
          <SidePanel />
        </div>
      )}
      {hintTarget.value && <Tour />}
      {tableVisible.value && <Batch />}
      {dialog.value && <Dialogs />}
      <Toasts />
      {message.value && (
        <p class="message" aria-hidden="true">
          {message}
        </p>
      )}
      <p class="visually-hidden" role="status">
        {announcement}
      </p>
      {filesDragged.value && (
        <div class="drop-overlay">
          <p>Drop to open</p>
        </div>
      )}
    </div>
  );
}
