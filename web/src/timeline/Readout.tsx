import { useComputed } from "@preact/signals";
import { plantAt } from "../model/plants/plants";
import { segmentAt } from "../model/segments/segments";
import { openVocabulary } from "../store/batch";
import { pointedFrame } from "../store/evidence";
import { timeView } from "../store/playback";
import { clip, dragPreview, namedSegments, plants, selected, selectedEdge } from "../store/session";
import { hovered } from "../store/view";
import { formatCount, formatDuration } from "../util/format";
import { type Curves, isBars, isCurves, type Lane } from "./layout";
import { type MarkerArea, useMarker } from "./use-marker";

/** A value with its time, and the place where it is displayed. */
interface Reading {
  frame: number;
  /** Frame at which the text is displayed. */
  at: number;
  details: string;
}

/** Returns the frame of the edge that is dragged, and by how much it has moved. */
function dragReading(rate: number): Reading | undefined {
  const [range, before, edge] = [dragPreview.value, selected.value, selectedEdge.value];
  if (!range || !before || !edge) return undefined;
  const frame = edge === "start" ? range.start : range.end - 1;
  const moved = range[edge] - before[edge];
  const sign = moved > 0 ? "+" : moved < 0 ? "−" : "±";
  const name = edge === "start" ? "first" : "last";
  const length = formatDuration((range.end - range.start) / rate);
  return {
    frame,
    at: range[edge],
    details: `${name} frame, ${sign}${Math.abs(moved)}, ${length} long`,
  };
}

const curveDetails = ({ kind, left, right }: Curves, frame: number) =>
  [["L", left] as const, ["R", right] as const]
    .map(([name, track]) => {
      const value = track[kind][frame] ?? 0;
      return kind === "speed"
        ? `${name} ${value.toFixed(2)} m/s`
        : `${name} ${(100 * value).toFixed(1)} cm`;
    })
    .join("  ");

/** States that the other clips of the table have the same letters for the same actions. */
const sharedNote = () => (openVocabulary.value ? ", as in all clips of the table" : "");

function laneDetails(lane: Lane, frame: number): string {
  if (isCurves(lane)) return curveDetails(lane, frame);
  if (lane.kind === "segments") {
    const { action } = segmentAt(namedSegments.value, frame) ?? {};
    return action ? `action ${action}${sharedNote()}` : "";
  }
  if (!isBars(lane)) return "";
  const { side, track, isPrincipal } = lane;
  const plant = isPrincipal ? plantAt(plants.value, frame, side) : undefined;
  if (plant?.edited) return `plant ${plant.number}, edited`;
  const confidence = `confidence ${Math.floor(100 * (track.confidence[frame] ?? 0))} %`;
  return [plant && `plant ${plant.number}`, confidence].filter(Boolean).join(", ");
}

/** The frame under the pointer or of the dragged edge, with the values there. */
export function Readout(area: MarkerArea) {
  const { layout } = area;
  const reading = useComputed<Reading | undefined>(() => {
    const rate = clip.value?.rate ?? 1;
    const dragged = dragReading(rate);
    if (dragged) return dragged;
    const { frame, y = -1 } = hovered.value ?? { frame: pointedFrame.value?.frame };
    if (frame === undefined) return undefined;
    const lane = layout.value.lanes.find((other) => y >= other.y && y <= other.y + other.height);
    return { frame, at: frame, details: lane ? laneDetails(lane, frame) : "" };
  });
  const element = useMarker(area, () => reading.value?.at);
  const isOnRight = useComputed(() => {
    const { start, end } = timeView.value;
    return (reading.value?.at ?? start) > (start + end) / 2;
  });
  const current = reading.value;
  const rate = clip.value?.rate ?? 1;
  return (
    <div class="pointed-frame" ref={element} aria-hidden="true" data-right={isOnRight.value}>
      {current && (
        <p>
          <strong>{formatCount(current.frame)}</strong> {(current.frame / rate).toFixed(3)} s
          {current.details && <span class="muted"> {current.details}</span>}
        </p>
      )}
    </div>
  );
}
