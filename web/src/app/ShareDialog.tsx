import { useComputed, useSignal } from "@preact/signals";
import { useRef } from "preact/hooks";
import { currentLink, savePage, savePicture } from "../actions/share";
import { embedded } from "../store/embedded";
import { playhead } from "../store/playback";
import { clip, edits, segmentNames } from "../store/session";
import { announcement, stageHandle } from "../store/view";
import { Dialog } from "../ui/Dialog";
import { formatClock } from "../util/format";
import { MadeWith } from "./MadeWith";

export function ShareDialog() {
  const link = useComputed(currentLink).value;
  const isMaking = useSignal(false);
  const makePage = async () => {
    isMaking.value = true;
    await savePage();
    isMaking.value = false;
  };
  return (
    <Dialog title={`Share ${clip.value?.name ?? ""}`}>
      <div class="ways">
        {link ? <LinkWay link={link} /> : <NoLink />}
        <section>
          <h3>Page</h3>
          <p>
            One HTML file with the clip, its labels and this player. It opens from disk, without a
            network.
          </p>
          <button
            type="button"
            class={`button ${link ? "" : "primary"}`}
            disabled={isMaking.value}
            onClick={makePage}
          >
            {isMaking.value ? "Making…" : "Save page"}
          </button>
        </section>
        <section>
          <h3>Picture</h3>
          <p>The view at {formatClock(playhead.value / (clip.value?.rate ?? 1))}, as PNG.</p>
          <button type="button" class="button" disabled={!stageHandle.value} onClick={savePicture}>
            Save picture
          </button>
        </section>
      </div>
      {embedded && <MadeWith />}
    </Dialog>
  );
}

function LinkWay({ link }: { link: string }) {
  const field = useRef<HTMLInputElement>(null);
  const said = useSignal("Copy");
  const copy = async () => {
    field.current?.select();
    try {
      await navigator.clipboard.writeText(link);
      said.value = "Copied";
    } catch {
      // Not everywhere may a page write to the clipboard; the link is selected by now.
      said.value = "Press Ctrl C";
    }
    announcement.value = said.value;
  };
  const changed = edits.value.length > 0 || segmentNames.value.length > 0;
  return (
    <section class="link-way">
      <h3>
        <label for="share-link">Link</label>
      </h3>
      <p>
        Opens this clip at this moment, with this view and these settings.
        {changed && " Corrections and names are not in it: the page below has them."}
      </p>
      <input
        ref={field}
        id="share-link"
        class="input"
        readOnly
        value={link}
        onFocus={(event) => event.currentTarget.select()}
      />
      <button type="button" class="button primary" onClick={copy}>
        {said.value}
      </button>
    </section>
  );
}

function NoLink() {
  return (
    <section>
      <h3>Link</h3>
      <p>
        {embedded
          ? "This page is a file, and no link leads to it: send it as it is, or save it with your changes."
          : "A link cannot carry a file of your own: nothing of it has left your computer. Send the page instead, which holds the clip."}
      </p>
    </section>
  );
}
