import { takeAway } from "../app/beside";
import { Icon } from "../app/icons";
import { besides } from "../app/state";

/** The clips beside the one on show, by name. */
export function Companions() {
  if (!besides.value.length) return null;
  return (
    <ul class="companions" aria-label="Beside it">
      {besides.value.map(({ source }) => (
        <li key={source.name} class="chip">
          <span>{source.name}</span>
          <button
            type="button"
            aria-label={`Take ${source.name} away`}
            title="Take away"
            onClick={() => takeAway(source)}
          >
            <Icon name="close" />
          </button>
        </li>
      ))}
    </ul>
  );
}
