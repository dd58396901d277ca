import { commandOf, tooltip } from "../actions/commands";
import { similar } from "../store/session";
import { Icon } from "../ui/icons";
import { plural } from "../util/format";

/** Offers to apply the edits to similar plants, whose changes are drawn on the timeline. */
export function SimilarOffer() {
  const found = similar.value;
  const text = found && `Preview: ${plural(found.plants, "similar plant")} would change`;
  return (
    <div class="similar-offer" role="status" hidden={!found}>
      {found && (
        <>
          <span class="similar-key" aria-hidden="true" />
          <p>{text}</p>
          <button
            type="button"
            class="button primary"
            title={tooltip("apply-similar")}
            onClick={commandOf("apply-similar").run}
          >
            Apply
          </button>
          <button
            type="button"
            class="button flat icon-only"
            aria-label={commandOf("dismiss-similar").label}
            title={tooltip("dismiss-similar")}
            onClick={commandOf("dismiss-similar").run}
          >
            <Icon name="close" />
          </button>
        </>
      )}
    </div>
  );
}
