import { useComputed } from "@preact/signals";
import { compareWithTruth } from "../actions/analyse/compare";
import { select, selection } from "../actions/edit/edit";
import { exportLabels } from "../actions/save/export";
import { seekPlant } from "../actions/view/playback";
import { minPlantConfidence, type Plant, principalPart } from "../model/plants/plants";
import { frame } from "../store/playback";
import { detection, openClip, plants, reference, source } from "../store/session";
import { plantFormats } from "../store/settings";
import { FormatButton } from "../ui/FormatButton";
import { ListHead } from "../ui/ListHead";
import { OpenOrDrop } from "../ui/OpenOrDrop";
import { VirtualList } from "../ui/VirtualList";
import { PlantEditor } from "./PlantEditor";

/** Editing, listing, saving and comparing labels. */
export function LabelsPanel() {
  if (!detection.value) return <p class="note">This clip has no labels.</p>;
  return (
    <>
      <PlantEditor />
      <PlantList />
      <div class="field">
        <h2>Compare</h2>
        {source.value?.truthUrl && !reference.value && (
          <button type="button" class="button" onClick={compareWithTruth}>
            Compare with reference
          </button>
        )}
        <p class="note">
          <OpenOrDrop /> a label file (JSON, CSV or NPZ) to compare it with these labels.
        </p>
      </div>
    </>
  );
}

function PlantList() {
  const rate = openClip.value?.rate ?? 1;
  return (
    <div class="field">
      <ListHead title="Plants" count={plants.value.length}>
        {plantFormats.value.map((format) => (
          <FormatButton key={format.name} format={format} onClick={() => exportLabels(format)} />
        ))}
      </ListHead>
      <p class="list-columns plant-columns" aria-hidden="true">
        <span>Start</span>
        <span>End</span>
        <span>Length</span>
        <span>Confid.</span>
      </p>
      {plants.value.length ? (
        <VirtualList
          items={plants.value}
          visibleIndex={selection.value?.plant && selection.value.plant.number - 1}
          renderRow={(plant) => <Row key={plant.number} plant={plant} rate={rate} />}
        />
      ) : (
        <p class="note">No foot is planted in this clip.</p>
      )}
    </div>
  );
}

function Row({ plant, rate }: { plant: Plant; rate: number }) {
  const isCurrent = useComputed(() => frame.value >= plant.start && frame.value < plant.end);
  const seconds = (frames: number) => (frames / rate).toFixed(2);
  const isUncertain = !plant.edited && plant.confidence < minPlantConfidence;
  const isSelected = selection.value?.plant?.number === plant.number;
  const selectPlant = () => {
    const part = principalPart(detection.value?.parts ?? {});
    const { side, start, end } = plant;
    if (part) select({ side, part, start, end });
    seekPlant(plant);
  };
  return (
    <button
      type="button"
      class={`plant ${plant.side}`}
      aria-current={isCurrent.value ? "true" : undefined}
      aria-pressed={isSelected}
      title={isUncertain ? "Low confidence: review this plant" : undefined}
      onClick={selectPlant}
    >
      <span class="number">{plant.number}</span>
      <span class="side">
        <span class="dot" aria-hidden="true" />
        {plant.side === "left" ? "Left" : "Right"}
      </span>
      <span>{seconds(plant.start)}</span>
      <span>{seconds(plant.end)}</span>
      <span>{seconds(plant.end - plant.start)}</span>
      <span class="confidence" data-uncertain={isUncertain}>
        {plant.edited ? "edited" : `${Math.floor(100 * plant.confidence)} %`}
        {isUncertain && <span class="visually-hidden">, review</span>}
      </span>
    </button>
  );
}
