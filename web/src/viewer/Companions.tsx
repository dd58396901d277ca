import { removeCompanion } from "../actions/open/companions";
import { titleOfSource } from "../model/sources/source";
import { shownCompanions } from "../store/companions";
import { Icon } from "../ui/icons";

/** Lists the clips that are shown for comparison, each with a button to remove it. */
export function Companions() {
  if (!shownCompanions.value.length) return null;
  return (
    <ul class="companions" aria-label="Comparison clips">
      {shownCompanions.value.map(({ source }, i) => (
        <li key={i} class="chip">
          <span>{titleOfSource(source)}</span>
          <button
            type="button"
            aria-label={`Remove ${titleOfSource(source)} from the comparison`}
            title="Remove from the comparison"
            onClick={() => removeCompanion(source)}
          >
            <Icon name="close" />
          </button>
        </li>
      ))}
    </ul>
  );
}
