import { loopSegment } from "../actions/view/playback";
import { segmentKind, segmentTitle } from "../model/segments/segments";
import { namedSegments, openClip } from "../store/session";
import { AccessibleTable } from "./AccessibleTable";

/** The segments for screen readers. */
export function SegmentTable() {
  return (
    <AccessibleTable
      items={namedSegments}
      noun="segment"
      columns={["Segment", "Name", "Kind"]}
      cells={(segment) => [segmentTitle(segment), segmentKind(segment)]}
      buttonLabel={({ number }) => `Go to segment ${number}`}
      onSelect={loopSegment}
      rate={openClip.value?.rate ?? 1}
    />
  );
}
