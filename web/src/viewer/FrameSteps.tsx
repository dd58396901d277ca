import { CommandButton } from "../ui/CommandButton";

/** Buttons for single frames, for which there are no keys on a touch screen. */
export function FrameSteps() {
  return (
    <fieldset class="frame-steps">
      <legend class="visually-hidden">Frame</legend>
      <CommandButton id="frame-back" />
      <CommandButton id="frame-ahead" />
    </fieldset>
  );
}
