import { toSentence } from "../model/batch/report";
import { showTab } from "../store/view";

interface Props {
  message: string;
  /** What the user can do. */
  hint?: string | undefined;
  /** Adds a button that opens the joint assignment. */
  offersJoints?: boolean;
  /** Repeats what failed, if that may help. */
  retry?: (() => void) | undefined;
  /** Height of the lanes below the message, in pixels. */
  bottom?: number;
}

/** A message instead of the lanes of the feet, if there are none. */
export function LanesMessage({ message, hint, offersJoints, retry, bottom = 0 }: Props) {
  return (
    <div
      class="timeline-message"
      ref={(element) => element?.style.setProperty("--lanes-height", `${bottom}px`)}
    >
      <p>{toSentence(message)}</p>
      {hint && <p class="muted">{hint}</p>}
      {retry && (
        <button type="button" class="button" onClick={retry}>
          Try again
        </button>
      )}
      {offersJoints && (
        <button type="button" class="button" onClick={() => showTab("clip")}>
          Choose joints
        </button>
      )}
    </div>
  );
}
