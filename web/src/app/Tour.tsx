import { keyOf } from "../actions/commands";
import { endTour, showHint, tourStep } from "../store/tour";
import { Icon } from "../ui/icons";
import { isTouch } from "../ui/touch";

/** Hints: the part of the page that is outlined, the text, and the text for touch screens if it differs. */
const hints = [
  [
    "A highlighted foot is planted: it rests on the ground, lower and slower than in the rest of the clip. Every plant leaves a numbered footprint.",
  ],
  [
    "Each bar is a plant: blue for left, orange for right; below it are heel and toe. Click a bar to go to it. The Tracks menu explains the marks.",
    "Each bar is a plant: blue for left, orange for right; below it are heel and toe. Tap a bar to go to it, and zoom with two fingers. The Tracks menu explains the marks.",
  ],
  [
    `Drag the edge of a bar to correct it, or move the nearest edge with Q and W. A adds a plant, Delete removes one, ${keyOf("undo")} undoes. Edits are stored in this browser.`,
    "Tap a bar, then drag its ends or use the buttons to correct it. A double tap between two bars adds a plant. The Labels tab has more buttons. Edits are stored in this browser.",
  ],
  [
    "The defaults need no tuning. A higher sensitivity makes plants longer. In this panel, you can also save the labels and remove foot skate.",
  ],
  [
    "Drop a folder or an archive to process many clips, or a label file to compare it with these labels. Press ? for keyboard shortcuts.",
    "Open several files or an archive to process many clips, or a label file to compare it with these labels.",
  ],
] as const;

/** A tour of five hints for new users. It does not block the page. */
export function Tour() {
  const step = tourStep.value;
  const hint = step === null ? undefined : hints[step];
  if (!hint || step === null) return null;
  const [text, touchText = text] = hint;
  const isLast = step === hints.length - 1;
  return (
    <aside class="tour" aria-label="Tour">
      <p aria-live="polite">{isTouch() ? touchText : text}</p>
      <div class="tour-foot">
        <span class="muted">
          {step + 1} of {hints.length}
        </span>
        <span class="spacer" />
        {step > 0 && (
          <button type="button" class="button flat" onClick={() => showHint(step - 1)}>
            Back
          </button>
        )}
        <button
          type="button"
          class="button primary"
          onClick={() => (isLast ? endTour() : showHint(step + 1))}
        >
          {isLast ? "Done" : "Next"}
        </button>
      </div>
      {!isLast && (
        <button
          type="button"
          class="button flat icon-only"
          aria-label="End the tour"
          title={`End the tour (${keyOf("escape")})`}
          onClick={endTour}
        >
          <Icon name="close" />
        </button>
      )}
    </aside>
  );
}
