import { pointedFrame } from "../store/evidence";
import { type MarkerArea, useMarker } from "./use-marker";

/** Line at the frame under the pointer, or the one selected by keys in a plot, with its number. */
export function PointedFrameLine(area: MarkerArea) {
  const element = useMarker(area, () => pointedFrame.value?.frame);
  return <div class="pointed-frame" ref={element} aria-hidden="true" />;
}
