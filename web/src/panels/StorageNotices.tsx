import {
  discardUnreadable,
  dismissChangesElsewhere,
  saveUnreadable,
  useChangesElsewhere,
} from "../actions/stored/persist";
import { changedElsewhere, persistError, unreadable } from "../store/session";

/** What is wrong with the storage of edits, or new in it, and what can be done. */
export function StorageNotices() {
  return (
    <div class="storage-notices" role="status">
      {persistError.value && <p class="storage-notice">{persistError.value}</p>}
      {unreadable.value.length > 0 && <Unreadable />}
      {changedElsewhere.value && <ChangedElsewhere isConflict={!!changedElsewhere.value.remote} />}
    </div>
  );
}

function Unreadable() {
  const isNewer = unreadable.value.some(({ kind }) => kind === "newer");
  return (
    <div class="storage-notice">
      <p>
        {isNewer
          ? "This browser has edits of this clip from a newer version of the app, which this version cannot read. Reload the page to get the newer version. The edits are preserved, even if you edit the clip here."
          : "This browser has stored edits of this clip that are damaged and cannot be read. They are preserved, but not applied."}
      </p>
      <p class="storage-actions">
        <button type="button" class="button" onClick={saveUnreadable}>
          Download them
        </button>
        <button type="button" class="button" onClick={discardUnreadable}>
          Delete them
        </button>
      </p>
    </div>
  );
}

function ChangedElsewhere({ isConflict }: { isConflict: boolean }) {
  return (
    <div class="storage-notice">
      <p>
        {isConflict
          ? "The same plants were edited in another tab. The edits of both tabs are applied; where they differ, those of this tab take precedence."
          : "Edits of this clip were changed in another tab. The changes are shown here."}
      </p>
      <p class="storage-actions">
        {isConflict && (
          <button type="button" class="button" onClick={useChangesElsewhere}>
            Use those of the other tab
          </button>
        )}
        <button type="button" class="button" onClick={dismissChangesElsewhere}>
          {isConflict ? "Keep both" : "Dismiss"}
        </button>
      </p>
    </div>
  );
}
