import { startMeasuring } from "../actions/analyse/measure";
import { warnBeforeLoss } from "../actions/stored/persist";
import { rememberVideos } from "../actions/view/video";
import { engine } from "../engine";
import { isFramed } from "../store/embedded";
import { listenForFirstInteraction } from "../store/first-interaction";
import { startTheme } from "../store/theme";

/** Starts everything that runs as long as the page is open. */
export function start() {
  engine.start();
  startTheme();
  listenForFirstInteraction();
  startMeasuring();
  rememberVideos();
  warnBeforeLoss();
  if (isFramed) scrollHostUntilFocused();
}

/**
 * Leaves the wheel to the document around the frame, which otherwise could not be scrolled past it, until the
 * page has the focus.
 */
function scrollHostUntilFocused() {
  const onWheel = (event: WheelEvent) => {
    if (!document.hasFocus()) event.stopImmediatePropagation();
  };
  addEventListener("wheel", onWheel, { capture: true });
}
