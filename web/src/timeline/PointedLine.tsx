import { pointedFrame } from "../store/evidence";
import { type MarkerArea, useMarker } from "./use-marker";

/** The frame whose point a pointer or a key rests on, with its number. */
export function PointedLine(room: MarkerArea) {
  const mark = useMarker(room, () => pointedFrame.value?.frame);
  return <div class="pointed-frame" ref={mark} aria-hidden="true" />;
}
