/** Accepting or declining the offer to apply edits to similar plants. */

import { session } from "../../store/clip-session";
import { similar } from "../../store/session";
import { notify } from "../../store/view";
import { plural } from "../../util/format";
import { commitEdits, inOrder } from "./edit";

/** Accepts the changes as one edit. */
export const applySimilar = () =>
  inOrder(async () => {
    const found = similar.value;
    if (!found) return;
    const clipSession = session.value;
    clipSession.similar.value = null;
    const next = [...clipSession.edits.value, ...found.changes];
    // Nothing is offered again until the next edit, although accepted changes are examples, too.
    clipSession.similarSettledFor.value = next;
    await commitEdits(next, `Applied to ${plural(found.plants, "similar plant")}`);
  });

/** Does not offer the changes again until the next edit. */
export function dismissSimilar() {
  const clipSession = session.value;
  clipSession.similarSettledFor.value = clipSession.edits.value;
  clipSession.similar.value = null;
  notify("Similar plants stay as they are");
}
