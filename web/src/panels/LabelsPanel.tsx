import { useComputed, useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { seekPlant } from "../app/playback";
import { type SaveFormat, save } from "../app/save";
import { frame, openClip, plants } from "../app/state";
import type { Plant } from "../lib/plants";

const rowHeight = 36;

const formats: readonly (readonly [SaveFormat, string, string])[] = [
  ["json", "Labels", "JSON"],
  ["csv", "Every frame", "CSV"],
  ["intervals", "Intervals", "CSV"],
  ["events", "Gait events", "CSV"],
];

export function LabelsPanel() {
  if (!plants.value.length) {
    return <p class="note">No plants, so nothing to list or to save.</p>;
  }
  return (
    <div class="labels">
      <div class="field">
        <h2>Save</h2>
        <div class="save">
          {formats.map(([format, name, kind]) => (
            <button key={format} type="button" class="button" onClick={() => save(format)}>
              {name} <span class="quiet">{kind}</span>
            </button>
          ))}
        </div>
      </div>
      <div class="plants-head">
        <h2>Plants</h2>
        <p class="columns" aria-hidden="true">
          <span>Start</span>
          <span>End</span>
          <span>Length</span>
        </p>
      </div>
      <PlantList />
    </div>
  );
}

/** Only the rows in sight exist: an hour of walking has thousands. */
function PlantList() {
  const box = useRef<HTMLDivElement>(null);
  const view = useSignal({ top: 0, height: 600 });
  useEffect(() => {
    const scroller = box.current?.closest(".panel-body");
    if (!scroller || !box.current) return;
    const list = box.current;
    const look = () => {
      const top = scroller.getBoundingClientRect().top - list.getBoundingClientRect().top;
      view.value = { top, height: scroller.clientHeight };
    };
    look();
    scroller.addEventListener("scroll", look, { passive: true });
    const observer = new ResizeObserver(look);
    observer.observe(scroller);
    return () => {
      scroller.removeEventListener("scroll", look);
      observer.disconnect();
    };
  }, [view]);
  const list = plants.value;
  const rate = openClip.value?.rate ?? 1;
  const from = Math.max(0, Math.floor(view.value.top / rowHeight) - 6);
  const to = Math.min(list.length, Math.ceil((view.value.top + view.value.height) / rowHeight) + 6);
  return (
    <div ref={box}>
      <ol
        class="plants"
        ref={(el) => el?.style.setProperty("height", `${list.length * rowHeight}px`)}
      >
        {list.slice(from, to).map((plant, i) => (
          <Row key={plant.number} plant={plant} rate={rate} at={from + i} of={list.length} />
        ))}
      </ol>
    </div>
  );
}

function Row({ plant, rate, at, of }: { plant: Plant; rate: number; at: number; of: number }) {
  const now = useComputed(() => frame.value >= plant.start && frame.value < plant.end);
  const seconds = (frames: number) => (frames / rate).toFixed(2);
  return (
    <li
      aria-posinset={at + 1}
      aria-setsize={of}
      ref={(el) => el?.style.setProperty("top", `${at * rowHeight}px`)}
    >
      <button
        type="button"
        class={`plant ${plant.side}`}
        aria-current={now.value ? "true" : undefined}
        onClick={() => seekPlant(plant)}
      >
        <span class="number">{plant.number}</span>
        <span class="side">
          <span class="dot" aria-hidden="true" />
          {plant.side === "left" ? "Left" : "Right"}
        </span>
        <span>{seconds(plant.start)}</span>
        <span>{seconds(plant.end)}</span>
        <span>{seconds(plant.end - plant.start)} s</span>
      </button>
    </li>
  );
}
