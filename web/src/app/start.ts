import { startMeasuring } from "../actions/measure";
import { warnBeforeLoss } from "../actions/persist";
import { rememberVideos } from "../actions/video";
import { engine } from "../engine";
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
}
