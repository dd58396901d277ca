import { useComputed } from "@preact/signals";
import { compareWithTruth } from "../actions/compare";
import { select, selection } from "../actions/edit";
import { exportLabels } from "../actions/export";
import { seekPlant } from "../actions/playback";
import { minPlantConfidence, type Plant, principalPart } from "../model/plants";
import type { SaveFormat } from "../model/types";
import { frame } from "../store/playback";
import { detection, openClip, plants, reference, source } from "../store/session";
import { ListHead } from "../ui/ListHead";
import { VirtualList } from "../ui/VirtualList";
import { PlantEditor } from "./PlantEditor";

const formats: readonly (readonly [SaveFormat, string, string])[] = [
  ["json", "Labels", "JSON"],
  ["csv", "Every frame", "CSV"],
  ["intervals", "Intervals", "CSV"],
  ["events", "Gait events", "CSV"],
  ["npz", "Arrays", "NPZ"],
  ["blender", "Blender", "Python"],
];

export function LabelsPanel() {
  if (!detection.value) return <p class="note">No labels, so nothing to list or to save.</p>;
  return (
    <div class="labels">
      <PlantEditor />
      <Listed />
      <div class="field">
        <h2>Compare</h2>
        {source.value?.truthUrl && !reference.value && (
          <button type="button" class="button" onClick={compareWithTruth}>
            Compare with the truth
          </button>
        )}
        <p class="note">Drop labels as JSON or CSV to see them beside these.</p>
      </div>
    </div>
  );
}

function Listed() {
  const rate = openClip.value?.rate ?? 1;
  return (
    <div class="field">
      <ListHead title="Plants" count={plants.value.length}>
        {formats.map(([format, name, kind]) => (
          <button key={format} type="button" class="button" onClick={() => exportLabels(format)}>
            {name} <span class="muted">{kind}</span>
          </button>
        ))}
      </ListHead>
      <p class="columns plant-columns" aria-hidden="true">
        <span>Start</span>
        <span>End</span>
        <span>Length</span>
        <span>Sure</span>
      </p>
      {plants.value.length ? (
        <VirtualList
          items={plants.value}
          row={(plant) => <Row key={plant.number} plant={plant} rate={rate} />}
        />
      ) : (
        <p class="note">No foot is planted in this clip.</p>
      )}
    </div>
  );
}

function Row({ plant, rate }: { plant: Plant; rate: number }) {
  const now = useComputed(() => frame.value >= plant.start && frame.value < plant.end);
  const seconds = (frames: number) => (frames / rate).toFixed(2);
  const doubtful = !plant.edited && plant.confidence < minPlantConfidence;
  const isSelected = selection.value?.number === plant.number;
  const choose = () => {
    const part = principalPart(detection.value?.parts ?? {});
    const { side, start, end } = plant;
    if (part) select({ side, part, start, end });
    seekPlant(plant);
  };
  return (
    <button
      type="button"
      class={`plant ${plant.side}`}
      aria-current={now.value ? "true" : undefined}
      aria-pressed={isSelected}
      title={doubtful ? "Uncertain: worth a look" : undefined}
      onClick={choose}
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
        {plant.edited ? "edited" : `${Math.floor(100 * plant.confidence)} %`}
        {doubtful && <span class="visually-hidden">, uncertain</span>}
      </span>
    </button>
  );
}
