import { keyTable } from "../actions/commands";
import { locationText } from "../model/batch/report";
import { tableVisible } from "../store/batch";
import { classicKeys } from "../store/preferences";
import { clipTitle, notices, openClip } from "../store/session";
import { showHint } from "../store/tour";
import { dialog } from "../store/view";
import { Dialog } from "../ui/Dialog";
import { ShareDialog } from "./ShareDialog";
import { ThirdPartyLink } from "./ThirdParty";
import { ThirdPartyDialog } from "./ThirdPartyDialog";

/** The open dialog, if any. */
export function Dialogs() {
  if (dialog.value === "keys") return <KeysDialog />;
  if (dialog.value === "notices") return <NoticesDialog />;
  if (dialog.value === "share") return <ShareDialog />;
  if (dialog.value === "third-party") return <ThirdPartyDialog />;
  return null;
}

function KeysDialog() {
  return (
    <Dialog title="Keyboard shortcuts">
      <div class="key-groups">
        {keyTable().map(({ group, rows }) => (
          <section key={group}>
            <h3>{group}</h3>
            <dl>
              {rows.map(({ keys, help }) => (
                <div key={help}>
                  <dt>
                    {keys.map((key) => (
                      <kbd key={key}>{key}</kbd>
                    ))}
                  </dt>
                  <dd>{help}</dd>
                </div>
              ))}
            </dl>
          </section>
        ))}
      </div>
      <label class="checkbox-row">
        <input
          type="checkbox"
          checked={classicKeys.value}
          onChange={(event) => classicKeys.set(event.currentTarget.checked)}
        />
        Former keys: L loops, K splits, comma and full stop change the speed
      </label>
      <p class="note">
        View: drag to orbit, right-drag to pan, scroll to zoom. Q and W move the selected edge, or
        the one nearest to the playhead. Timeline: scroll to zoom, Shift and scroll or drag with the
        middle button to pan, click a bar to go to its start, drag its edge to move it, double-click
        an empty place of a track to add a plant, double-click a segment to rename it, Shift and
        drag on the ruler to loop a range. Plots: ← and → step by frames, Enter goes to the frame.
      </p>
      {openClip.value && !tableVisible.value && (
        <button
          type="button"
          class="button"
          onClick={() => {
            dialog.value = null;
            showHint(0);
          }}
        >
          Show the tour
        </button>
      )}
      <p class="note">
        <ThirdPartyLink />
      </p>
    </Dialog>
  );
}

function NoticesDialog() {
  return (
    <Dialog title={`Notices for ${clipTitle}`}>
      <ul class="notices">
        {notices.value.map((notice, i) => (
          <li key={i}>
            <p>{notice.text}</p>
            <p class="muted">
              <code>{notice.code}</code>
              {locationText(notice) && ` ${locationText(notice)}`}
            </p>
          </li>
        ))}
      </ul>
    </Dialog>
  );
}
