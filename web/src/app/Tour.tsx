import { signal } from "@preact/signals";
import { openClip } from "../store/session";
import { Icon } from "../ui/icons";

/** Hints: the part of the page that is outlined, and the text. */
const hints = [
  [
    "viewer",
    "A highlighted foot is planted: it rests on the ground, lower and slower than in the rest of the clip. Every plant leaves a numbered footprint.",
  ],
  [
    "timeline",
    "Each bar is a plant: blue for left, orange for right; below it are heel and toe. Click a bar to go to it. Tracks explains the marks.",
  ],
  [
    "timeline",
    "Drag the edge of a bar to correct it, or move the nearest edge by Q and W. A adds a plant, Delete removes one, Ctrl Z undoes. Edits are stored in this browser.",
  ],
  [
    "panel",
    "The defaults need no tuning. A higher sensitivity makes plants longer. Save labels and clips without foot skate from this panel.",
  ],
  [
    "head",
    "Drop a folder or an archive to process many clips, or a label file to compare it with these labels. Press ? for keyboard shortcuts.",
  ],
] as const;

const storageKey = "plantigrade:tour";

/** Index of the current hint; the number of hints after the tour. */
const step = signal(isDone() ? hints.length : 0);

function isDone() {
  try {
    return localStorage.getItem(storageKey) === "done";
  } catch {
    return true;
  }
}

function goTo(index: number) {
  step.value = index;
  if (index < hints.length) return;
  try {
    localStorage.setItem(storageKey, "done");
  } catch {
    // Without storage, the tour is shown again on the next visit.
  }
}

/** Starts the tour at the first hint. */
export const startTour = () => goTo(0);

/** Returns the part of the page that the current hint describes. */
export const hintTarget = () => (openClip.value && hints[step.value]?.[0]) || undefined;

/** A tour of five hints for new users. It does not block the page. */
export function Tour() {
  const [, text] = hints[step.value] ?? [];
  if (!openClip.value || !text) return null;
  const isLast = step.value === hints.length - 1;
  return (
    <aside class="tour" aria-label="Tour">
      <p aria-live="polite">{text}</p>
      <div class="tour-foot">
        <span class="muted">
          {step.value + 1} of {hints.length}
        </span>
        <span class="spacer" />
        {step.value > 0 && (
          <button type="button" class="button flat" onClick={() => goTo(step.value - 1)}>
            Back
          </button>
        )}
        <button type="button" class="button primary" onClick={() => goTo(step.value + 1)}>
          {isLast ? "Done" : "Next"}
        </button>
      </div>
      {!isLast && (
        <button
          type="button"
          class="button flat icon-only"
          aria-label="End the tour"
          onClick={() => goTo(hints.length)}
        >
          <Icon name="close" />
        </button>
      )}
    </aside>
  );
}
