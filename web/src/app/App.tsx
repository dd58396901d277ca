import { useSignalEffect } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { followHistory } from "../actions/navigation";
import { openFromAddress } from "../actions/open-address";
import { openPickedFiles, setFileInput } from "../actions/pick-files";
import { Batch } from "../batch/Batch";
import { tableVisible } from "../store/batch";
import { isHosted } from "../store/embedded";
import { phase } from "../store/phase";
import { panelCollapsed, panelWidth } from "../store/preferences";
import { openClip } from "../store/session";
import { announcement, dialog, filesDragged, message, sheetOpen } from "../store/view";
import { Timeline } from "../timeline/Timeline";
import { Progress } from "../ui/Progress";
import { setSize } from "../ui/Splitter";
import { VideoPane } from "../viewer/VideoPane";
import { Viewer } from "../viewer/Viewer";
import { Dialogs } from "./Dialogs";
import { listenForDrops } from "./drop";
import { ErrorCard } from "./ErrorCard";
import { returnFocus } from "./focus";
import { Head } from "./Head";
import { onKey } from "./key-handler";
import { registerServiceWorker } from "./offline";
import { SidePanel } from "./SidePanel";
import { StartPage } from "./StartPage";
import { Toasts } from "./Toasts";
import { hintTarget, Tour } from "./Tour";

/** Time for which a message stays in the live region, in milliseconds. */
const announcementTime = 5000;

/** The page. */
export function App() {
  useEffect(() => {
    const controller = new AbortController();
    const { signal } = controller;
    addEventListener("keydown", onKey, { signal });
    followHistory(signal);
    listenForDrops(signal);
    returnFocus(signal);
    void openFromAddress();
    registerServiceWorker();
    return () => controller.abort();
  }, []);
  // A message that stays would be read again, out of context.
  useSignalEffect(() => {
    if (!announcement.value) return;
    const timer = setTimeout(() => {
      announcement.value = "";
      message.value = "";
    }, announcementTime);
    return () => clearTimeout(timer);
  });
  const clip = openClip.value;
  useEffect(() => {
    document.title = clip ? `${clip.name} – Plantigrade` : "Plantigrade";
  }, [clip]);
  const width = panelWidth.value;
  return (
    <div
      class="shell"
      data-state={phase.value}
      data-clip={clip ? "open" : "none"}
      data-hint={hintTarget()}
      data-panel={panelCollapsed.value ? "collapsed" : "shown"}
      data-sheet={sheetOpen.value ? "raised" : "lowered"}
      ref={(element) => setSize(element, "--panel-width", width)}
    >
      <Head />
      <main>
        <div class="views">
          <Viewer />
          {clip && <VideoPane />}
        </div>
        {clip ? <Timeline /> : !isHosted && <StartPage />}
        <input
          ref={setFileInput}
          hidden
          type="file"
          multiple
          onChange={(event) => openPickedFiles(event.currentTarget)}
        />
        <ErrorCard />
        {/* An open dialog contains it, because only the dialog can be clicked then. */}
        {!dialog.value && <Progress />}
      </main>
      {clip && <SidePanel />}
      <Tour />
      {tableVisible.value && <Batch />}
      <Dialogs />
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
