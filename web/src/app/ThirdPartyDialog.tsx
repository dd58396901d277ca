import { blockText, noticesId } from "../model/sources/player-html";
import { Dialog } from "../ui/Dialog";
import { title } from "./ThirdParty";

/** The notices of third-party software in a shared page. */
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
