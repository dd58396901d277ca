import { changedElsewhere, persistError, unreadable } from "../store/session";
import { showTab } from "../store/view";
import { Icon } from "../ui/icons";

function statusText(): string {
  if (persistError.value) return "Edits are not stored";
  if (unreadable.value.length) return "Stored edits cannot be read";
  if (changedElsewhere.value?.remote) return "Edits conflict with those of another tab";
  return changedElsewhere.value ? "Edits were changed in another tab" : "";
}

/** A line above the timeline if the storage of edits needs attention; the Labels tab has details. */
export function StorageStatus() {
  const text = statusText();
  return (
    <div class="storage-status" role="status" hidden={!text}>
      <Icon name="warning" />
      <p>{text}</p>
      <button type="button" class="link" onClick={() => showTab("labels")}>
        Details
      </button>
    </div>
  );
}
