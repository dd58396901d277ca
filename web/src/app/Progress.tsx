import { cancelOpening } from "./open";
import { task } from "./state";

const stages = { fetch: "Downloading", read: "Reading", detect: "Finding plants in" } as const;

/** What is being opened. The style sheet holds it back for 200 ms: most clips are faster. */
export function Progress() {
  const held = task.value;
  if (!held) return null;
  return (
    <div class="progress" role="status">
      <p>
        {stages[held.stage]} <strong>{held.name}</strong>
      </p>
      <progress aria-label={`${stages[held.stage]} ${held.name}`} value={held.share} max={1} />
      <button type="button" class="button" onClick={cancelOpening}>
        Cancel
      </button>
    </div>
  );
}
