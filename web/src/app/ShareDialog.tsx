import { useComputed, useSignal } from "@preact/signals";
import { useRef } from "preact/hooks";
import { keyText } from "../actions/key-bindings";
import { currentLink, savePage, savePicture } from "../actions/save/share";
import { embedded, isHosted } from "../store/embedded";
import { playhead } from "../store/playback";
import { clip, clipTitle, edits, segmentNames } from "../store/session";
import { announce, stageHandle } from "../store/view";
import { Dialog } from "../ui/Dialog";
import { formatClock } from "../util/format";
import { MadeWith } from "./MadeWith";
import { ThirdPartyLink } from "./ThirdParty";

/** Ways to share the open clip: a link, a single-file page, a picture. */
export function ShareDialog() {
  const link = useComputed(currentLink).value;
  const isCreating = useSignal(false);
  const createPage = async () => {
    isCreating.value = true;
    await savePage();
    isCreating.value = false;
  };
  return (
    <Dialog title={`Share ${clipTitle}`}>
      <div class="share-options">
        {link ? <ShareLink link={link} /> : !isHosted && <NoLink />}
        <section>
          <h3>Page</h3>
          <p>
            A single HTML file with the clip, its labels and this player. It opens from disk,
            without a network connection.
          </p>
          <button
            type="button"
            class={`button ${link ? "" : "primary"}`}
            disabled={isCreating.value}
            onClick={createPage}
          >
            {isCreating.value ? "Creating…" : "Save page"}
          </button>
        </section>
        <section>
          <h3>Picture</h3>
          <p>The view at {formatClock(playhead.value / (clip.value?.rate ?? 1))} as a PNG file.</p>
          <button type="button" class="button" disabled={!stageHandle.value} onClick={savePicture}>
            Save picture
          </button>
        </section>
      </div>
      {embedded && (
        <p class="credits">
          <MadeWith />
          <ThirdPartyLink />
        </p>
      )}
    </Dialog>
  );
}

function ShareLink({ link }: { link: string }) {
  const field = useRef<HTMLInputElement>(null);
  const copyLabel = useSignal("Copy");
  const copy = async () => {
    field.current?.select();
    try {
      await navigator.clipboard.writeText(link);
      copyLabel.value = "Copied";
    } catch {
      // The page may not write to the clipboard; the link is already selected.
      copyLabel.value = `Press ${keyText({ key: "c", mod: true })}`;
    }
    announce(copyLabel.value);
  };
  const hasChanges = edits.value.length > 0 || segmentNames.value.length > 0;
  return (
    <section class="share-link">
      <h3>
        <label for="share-link">Link</label>
      </h3>
      <p>
        Opens this clip at the current time, with the current view and settings.
        {hasChanges && " Edits and segment names are not included; save a page to share them."}
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
        {copyLabel.value}
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
          ? "This page is a file, so there is no link to it. Send the file, or save a page with your changes."
          : "Links work for samples and URLs only, since files are not uploaded. Save a page to share this clip."}
      </p>
    </section>
  );
}
