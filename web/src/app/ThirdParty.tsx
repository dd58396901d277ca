import { blockText, noticesId } from "../model/sources/player-html";
import { embedded } from "../store/embedded";
import { dialog } from "../store/view";
import { Dialog } from "../ui/Dialog";

const title = "Third-party software";

/** Opens the notices of third-party software: a page of the site, or a dialog of a shared page. */
export function ThirdPartyLink() {
  if (!embedded) {
    return (
      <a class="credit link" href="./third-party.html" target="_blank" rel="noreferrer">
        {title}
      </a>
    );
  }
  return (
    <button
      type="button"
      class="credit link"
      aria-haspopup="dialog"
      onClick={() => {
        dialog.value = "third-party";
      }}
    >
      {title}
    </button>
  );
}

export function ThirdPartyDialog() {
  return (
    <Dialog title={title}>
      {/* biome-ignore lint/a11y/noNoninteractiveTabindex: a scroll container must be focusable by keyboard */}
      <pre class="third-party" tabIndex={0}>
        {blockText(noticesId).trim()}
      </pre>
    </Dialog>
  );
}
