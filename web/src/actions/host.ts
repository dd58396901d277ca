/** The page in a frame: its clip, edits and settings are those of the host. */

import { batch, effect } from "@preact/signals";
import type { HostedState, HostMessage, PageMessage } from "../model/sources/host";
import type { Source } from "../model/sources/source";
import { noChanges } from "../model/stored/stored-changes";
import { type ClipSession, session } from "../store/clip-session";
import { detectOptions } from "../store/settings";
import { themeChoice } from "../store/theme";
import { setOverrides } from "./analyse/detect";
import { commitEdits, replaceEdits } from "./edit/edit";
import { currentDetectSettings, detectOptionsOf, overridesOf } from "./view/view-state";

/** The state that the host knows, as text. */
let known = "";

const post = (message: PageMessage) => parent.postMessage(message, "*");

/** Asks the host for a clip, and follows its messages. `open` opens a clip. */
export function followHost(open: (source: Source) => void) {
  addEventListener("message", ({ source, data }: MessageEvent<HostMessage>) => {
    if (source !== parent) return;
    if (data.type === "plantigrade-theme") themeChoice.value = data.theme;
    if (data.type === "plantigrade-state") takeState(data.state);
    if (data.type === "plantigrade-open") {
      const { name, state } = data;
      const shared = { id: "", edits: state.edits, names: state.names };
      open({
        name,
        data: new Blob([data.data]),
        view: { ...state.settings, lenient: "yes" },
        shared,
      });
    }
  });
  post({ type: "plantigrade-ready" });
}

const stateOf = ({ edits, segmentNames }: ClipSession): HostedState => ({
  settings: currentDetectSettings(),
  edits: edits.value,
  names: segmentNames.value,
});

/** Applies the edits of the host to the clip that it has opened, and reports changes as long as it is open. */
export async function shareWithHost(clipSession: ClipSession): Promise<void> {
  const { edits, names } = clipSession.source?.shared ?? noChanges;
  clipSession.segmentNames.value = names;
  const applied = replaceEdits(clipSession, () => edits);
  known = JSON.stringify(stateOf(clipSession));
  const stop = effect(() => {
    const state = stateOf(clipSession);
    const text = JSON.stringify(state);
    if (text === known) return;
    known = text;
    post({ type: "plantigrade-state", state });
  });
  clipSession.signal.addEventListener("abort", stop);
  await applied;
}

/** Replaces edits and settings by those of the host; the edits can be undone. */
function takeState({ settings, edits, names }: HostedState) {
  const clipSession = session.value;
  const before = stateOf(clipSession);
  batch(() => {
    clipSession.segmentNames.value = names;
    if (JSON.stringify(edits) !== JSON.stringify(before.edits))
      void commitEdits(edits, "Edits replaced by those of the notebook");
    if (JSON.stringify(settings) !== JSON.stringify(before.settings)) {
      detectOptions.value = detectOptionsOf(settings);
      setOverrides(overridesOf(settings));
    }
    known = JSON.stringify(stateOf(clipSession));
  });
}
