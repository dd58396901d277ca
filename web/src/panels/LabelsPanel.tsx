import { useComputed } from "@preact/signals";
import { compareWithTruth } from "../app/compare";
import { seekPlant } from "../app/playback";
import { type SaveFormat, save } from "../app/save";
import { frame, openClip, other, plants, source } from "../app/state";
import { certainPlant, type Plant } from "../lib/plants";
import { VirtualList } from "./VirtualList";

const formats: readonly (readonly [SaveFormat, string, string])[] = [
  ["json", "Labels", "JSON"],
  ["csv", "Every frame", "CSV"],
  ["intervals", "Intervals", "CSV"],
  ["events", "Gait events", "CSV"],
];

export function LabelsPanel() {
  const rate = openClip.value?.rate ?? 1;
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
      <div class="field">
        <h2>Compare</h2>
        {source.value?.truth && !other.value && (
          <button type="button" class="button" onClick={compareWithTruth}>
            Compare with the truth
          </button>
        )}
        <p class="note">Drop labels as JSON or CSV to see them beside these.</p>
      </div>
      <div class="plants-head">
        <h2>Plants</h2>
        <p class="columns" aria-hidden="true">
          <span>Start</span>
          <span>End</span>
          <span>Length</span>
          <span>Sure</span>
        </p>
      </div>
      <VirtualList
        items={plants.value}
        row={(plant) => <Row key={plant.number} plant={plant} rate={rate} />}
      />
    </div>
  );
}

function Row({ plant, rate }: { plant: Plant; rate: number }) {
  const now = useComputed(() => frame.value >= plant.start && frame.value < plant.end);
  const seconds = (frames: number) => (frames / rate).toFixed(2);
  const doubtful = plant.confidence < certainPlant;
  return (
    <button
      type="button"
      class={`plant ${plant.side}`}
      aria-current={now.value ? "true" : undefined}
      title={doubtful ? "Uncertain: worth a look" : undefined}
      onClick={() => seekPlant(plant)}
    >
      <span class="number">{plant.number}</span>
      <span class="side">
        <span class="dot" aria-hidden="true" />
        {plant.side === "left" ? "Left" : "Right"}
      </span>
      <span>{seconds(plant.start)}</span>
      <span>{seconds(plant.end)}</span>
      <span>{seconds(plant.end - plant.start)}</span>
      <span class="sure" data-doubtful={doubtful}>
        {Math.floor(100 * plant.confidence)} %{doubtful && <span class="hidden">, uncertain</span>}
      </span>
    </button>
  );
}
