import { signal } from "@preact/signals";
import { openClip } from "../store/session";
import { Icon } from "../ui/icons";

/** What a new person is shown, and beside which part of the page. */
const hints = [
  [
    "viewer",
    "A lit foot is planted: on the ground and still, lower and slower than elsewhere in this clip. Every plant leaves a numbered print.",
  ],
  [
    "timeline",
    "Each bar is a plant: blue left, orange right, toes solid, heels hatched, dotted where the detector is unsure. Click one to go to it.",
  ],
  [
    "timeline",
    "Drag the end of a bar to correct it, or press E and then I, O, K, M or Delete. Ctrl Z takes it back. Edits are kept in this browser.",
  ],
  [
    "panel",
    "Nothing needs tuning. If you want to: the sensitivity plants feet longer or shorter, live. Labels and clips without foot skate are saved from here.",
  ],
  [
    "head",
    "Drop more: a folder or an archive fills a table, and labels of the clip stand beside yours. Press ? for all keys.",
  ],
] as const;

const key = "plantigrade:tour";

/** Place of the hint on show; the last one past means that the tour is over. */
const at = signal(isDone() ? hints.length : 0);

function isDone() {
  try {
    return localStorage.getItem(key) === "done";
  } catch {
    return true;
  }
}

function go(to: number) {
  at.value = to;
  if (to < hints.length) return;
  try {
    localStorage.setItem(key, "done");
  } catch {
    // Then it is shown again: nothing worse.
  }
}

/** Shows the tour from its beginning. */
export const startTour = () => go(0);

/** The part of the page that the hint on show is about. */
export const hinted = () => (openClip.value && hints[at.value]?.[0]) || undefined;

/** Five hints for whoever is new here, one after the other, in nobody's way. */
export function Tour() {
  const [, text] = hints[at.value] ?? [];
  if (!openClip.value || !text) return null;
  const isLast = at.value === hints.length - 1;
  return (
    <aside class="tour" aria-label="Tour">
      <p aria-live="polite">{text}</p>
      <div class="tour-foot">
        <span class="muted">
          {at.value + 1} of {hints.length}
        </span>
        <span class="spacer" />
        {at.value > 0 && (
          <button type="button" class="button flat" onClick={() => go(at.value - 1)}>
            Back
          </button>
        )}
        <button type="button" class="button primary" onClick={() => go(at.value + 1)}>
          {isLast ? "Done" : "Next"}
        </button>
      </div>
      {!isLast && (
        <button
          type="button"
          class="button flat icon-only"
          aria-label="End the tour"
          onClick={() => go(hints.length)}
        >
          <Icon name="close" />
        </button>
      )}
    </aside>
  );
}
