import { loopSegment } from "../actions/playback";
import { segmentKind, segmentTitle } from "../model/segments";
import { namedSegments, openClip } from "../store/session";
import { useSettled } from "./use-settled";

/** More rows than this help nobody who listens; the Segment panel lists them all. */
const most = 100;

/** The lane of segments in words, for screen readers: reached by browsing, not in the way of Tab. */
export function SegmentTable() {
  const rate = openClip.value?.rate ?? 1;
  const all = useSettled(namedSegments);
  const listed = all.slice(0, most);
  if (!listed.length) return null;
  return (
    <table>
      <caption>
        {all.length} segments
        {all.length > most ? `, the first ${most} listed` : ""}
      </caption>
      <thead>
        <tr>
          <th>Segment</th>
          <th>Name</th>
          <th>Kind</th>
          <th>Start</th>
          <th>Duration</th>
        </tr>
      </thead>
      <tbody>
        {listed.map((action) => (
          <tr key={action.number}>
            <td>
              <button type="button" tabIndex={-1} onClick={() => loopSegment(action)}>
                Go to segment {action.number}
              </button>
            </td>
            <td>{segmentTitle(action)}</td>
            <td>{segmentKind(action)}</td>
            <td>{(action.start / rate).toFixed(2)} s</td>
            <td>{((action.end - action.start) / rate).toFixed(2)} s</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}
