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
import { keepOffline } from "./offline";
import { releaseFocus } from "./release-focus";
import { SidePanel } from "./SidePanel";
import { StartPage } from "./StartPage";
import { Toasts } from "./Toasts";
import { hinted, Tour } from "./Tour";

export function App() {
  useEffect(() => {
    const off = new AbortController();
    const options = { signal: off.signal };
    addEventListener("keydown", onKey, options);
    addEventListener("hashchange", () => void openFromAddress(), options);
    listenForDrops(off.signal);
    releaseFocus(off.signal);
    void openFromAddress();
    keepOffline();
    return () => off.abort();
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
      data-hint={hinted()}
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
        {/* An open dialog shows it, as nothing else can be clicked then. */}
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
        <div class="drop">
          <p>Drop to open</p>
        </div>
      )}
    </div>
  );
}
