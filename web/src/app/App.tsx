import { useEffect } from "preact/hooks";
import { openFromAddress } from "../actions/open-address";
import { openPickedFiles, setFileInput } from "../actions/pick-files";
import { Batch } from "../batch/Batch";
import { tableVisible } from "../store/batch";
import { phase } from "../store/phase";
import { openClip } from "../store/session";
import { announcement, dialog, filesDragged } from "../store/view";
import { Timeline } from "../timeline/Timeline";
import { Progress } from "../ui/Progress";
import { Viewer } from "../viewer/Viewer";
import { Dialogs } from "./Dialogs";
import { listenForDrops } from "./drop";
import { ErrorCard } from "./ErrorCard";
import { Head } from "./Head";
import { onKey } from "./key-handler";
import { registerServiceWorker } from "./offline";
import { releaseFocus } from "./release-focus";
import { SidePanel } from "./SidePanel";
import { StartPage } from "./StartPage";
import { Toasts } from "./Toasts";
import { hintTarget, Tour } from "./Tour";

/** The page. */
export function App() {
  useEffect(() => {
    const controller = new AbortController();
    const { signal } = controller;
    addEventListener("keydown", onKey, { signal });
    addEventListener("hashchange", () => void openFromAddress(), { signal });
    listenForDrops(signal);
    releaseFocus(signal);
    void openFromAddress();
    registerServiceWorker();
    return () => controller.abort();
  }, []);
  const clip = openClip.value;
  useEffect(() => {
    document.title = clip ? `${clip.name} – Plantigrade` : "Plantigrade";
  }, [clip]);
  return (
    <div
      class="shell"
      data-state={phase.value}
      data-clip={clip ? "open" : "none"}
      data-hint={hintTarget()}
    >
      <Head />
      <main>
        <Viewer />
        {clip ? <Timeline /> : <StartPage />}
        <input
          ref={setFileInput}
          hidden
          type="file"
          accept=".bvh,.json,.csv,.npz,.zip,text/plain"
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
