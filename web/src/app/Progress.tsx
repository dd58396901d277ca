import { cancelOpening } from "./open";
import { openClip, task, work } from "./state";

const stages = { fetch: "Downloading", read: "Reading", detect: "Finding plants in" } as const;

/** What is being done. The style sheet holds it back for 200 ms: most clips are faster. */
export function Progress() {
  const opening = task.value;
  const held = opening
    ? { id: 0, share: undefined, ...opening, what: stages[opening.stage], stop: cancelOpening }
    : work.value[0] && { name: openClip.value?.name, share: undefined, ...work.value[0] };
  // What the figure behind the empty page needs is nobody's concern.
  if (!held?.name) return null;
  return (
    <div class="progress" role="status" key={held.id}>
      <p>
        {held.what} <strong>{held.name}</strong>
      </p>
      <progress aria-label={`${held.what} ${held.name}`} value={held.share} max={1} />
      <button type="button" class="button" onClick={held.stop}>
        Cancel
      </button>
    </div>
  );
}
