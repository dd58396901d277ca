import { useEffect, useRef } from "preact/hooks";
import { Batch } from "../batch/Batch";
import { Panel } from "../panels/Panel";
import { Timeline } from "../timeline/Timeline";
import { Viewer } from "../viewer/Viewer";
import { tableShown } from "./batch";
import { Dialogs } from "./Dialogs";
import { listenForDrops } from "./drop";
import { Empty } from "./Empty";
import { FailureCard } from "./FailureCard";
import { releaseFocus } from "./focus";
import { Head } from "./Head";
import { onKey } from "./keys";
import { keepOffline } from "./offline";
import { openFiles, openFromAddress } from "./open";
import { Progress } from "./Progress";
import { Remarks } from "./RemarkList";
import { announcement, dialog, dragging, openClip, phase } from "./state";
import { hinted, Tour } from "./Tour";

export function App() {
  const picker = useRef<HTMLInputElement>(null);
  const pick = () => picker.current?.click();
  useEffect(() => {
    const off = new AbortController();
    const quiet = { signal: off.signal };
    addEventListener("keydown", (event) => onKey(event, pick), quiet);
    addEventListener("hashchange", () => void openFromAddress(), quiet);
    listenForDrops(off.signal);
    releaseFocus(off.signal);
    void openFromAddress();
    keepOffline();
    return () => off.abort();
  }, []);
  const held = openClip.value;
  useEffect(() => {
    document.title = held ? `${held.name} – Plantigrade` : "Plantigrade";
  }, [held]);
  return (
    <div
      class="shell"
      data-state={phase.value}
      data-clip={held ? "open" : "none"}
      data-hint={hinted()}
    >
      <Head pick={pick} />
      <main>
        <Viewer />
        {held ? <Timeline /> : <Empty pick={pick} />}
        <input
          ref={picker}
          hidden
          type="file"
          accept=".bvh,.json,.csv,.npz,.zip,text/plain"
          multiple
          onChange={(event) => {
            const input = event.currentTarget;
            void openFiles({ files: [...(input.files ?? [])] });
            // The same file may be chosen again after it was changed.
            input.value = "";
          }}
        />
        <FailureCard />
        {/* An open dialog has it, as nothing else can be pressed then. */}
        {!dialog.value && <Progress />}
      </main>
      {held && (
        <Panel
          open={
            <button type="button" class="button open-low" onClick={pick}>
              Open
            </button>
          }
        />
      )}
      <Tour />
      {tableShown.value && <Batch />}
      <Dialogs />
      <Remarks />
      <p class="hidden" role="status">
        {announcement}
      </p>
      {dragging.value && (
        <div class="drop">
          <p>Drop to open</p>
        </div>
      )}
    </div>
  );
}
