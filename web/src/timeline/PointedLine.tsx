import { pointed } from "../app/why";
import { type Room, useMark } from "./mark";

/** The frame whose point a pointer or a key rests on, with its number. */
export function PointedLine(room: Room) {
  const mark = useMark(room, () => pointed.value?.frame);
  return <div class="pointed-line" ref={mark} aria-hidden="true" />;
}
