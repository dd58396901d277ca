import { removeCompanion } from "../actions/companions";
import { companions } from "../store/companions";
import { Icon } from "../ui/icons";

/** The clips beside the one on show, by name. */
export function Companions() {
  if (!companions.value.length) return null;
  return (
    <ul class="companions" aria-label="Beside it">
      {companions.value.map(({ source }) => (
        <li key={source.name} class="chip">
          <span>{source.name}</span>
          <button
            type="button"
            aria-label={`Take ${source.name} away`}
            title="Take away"
            onClick={() => removeCompanion(source)}
          >
            <Icon name="close" />
          </button>
        </li>
      ))}
    </ul>
  );
}
