import type { ComponentChildren } from "preact";
import { nudgeSelected } from "../actions/edit/edit";
import { nudgeCut } from "../actions/edit/edit-cuts";

/** Buttons that move an edge of the selected plant by one frame. */
export function EdgeStepper({
  edge,
  children,
}: {
  edge: "start" | "end";
  children: ComponentChildren;
}) {
  return (
    <Stepper
      name={edge === "start" ? "First frame" : "Last frame"}
      onStep={(by) => void nudgeSelected(edge, by)}
    >
      {children}
    </Stepper>
  );
}

/** Buttons that move the selected cut by one frame. */
export function CutStepper({ children }: { children: ComponentChildren }) {
  return (
    <Stepper name="Cut" onStep={(by) => void nudgeCut(by)}>
      {children}
    </Stepper>
  );
}

/** Two buttons, on both sides of a frame number. They are displayed on touch screens, which have no keys. */
function Stepper({
  name,
  onStep,
  children,
}: {
  name: string;
  onStep: (by: 1 | -1) => void;
  children: ComponentChildren;
}) {
  return (
    <div class="stepper">
      <button
        type="button"
        class="button"
        aria-label={`${name} earlier`}
        onClick={() => onStep(-1)}
      >
        ←
      </button>
      {children}
      <button type="button" class="button" aria-label={`${name} later`} onClick={() => onStep(1)}>
        →
      </button>
    </div>
  );
}
