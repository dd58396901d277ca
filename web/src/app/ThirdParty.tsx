import { embedded } from "../store/embedded";
import { dialog } from "../store/view";

export const title = "Third-party software";

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
