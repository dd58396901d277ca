import { useId } from "preact/hooks";
import { type CommandId, commandOf, tooltip } from "../actions/commands";
import {
  addAtPlayhead,
  resizeSelected,
  revertAll,
  revertSelected,
  selection,
  targetTrack,
} from "../actions/edit/edit";
import type { FrameRange } from "../model/plants/edits";
import type { Instant } from "../model/plants/plants";
import type { Part, Side } from "../model/types";
import { addTarget, detection, openClip, plantEdits } from "../store/session";
import { CommandButton } from "../ui/CommandButton";
import { EdgeStepper } from "../ui/Stepper";
import { capitalize } from "../util/format";
import { StorageNotices } from "./StorageNotices";

/** Buttons and fields for all edits, as an alternative to dragging. */
export function PlantEditor() {
  return (
    <div class="field plant-editor">
      <div class="field-head">
        <h2>Edit</h2>
        <CommandButton id="undo" />
        <CommandButton id="redo" />
      </div>
      <StorageNotices />
      {selection.value ? (
        <SelectedPlant />
      ) : (
        <p class="note">Select a bar in the timeline or a plant in the list.</p>
      )}
      <AddPlant />
    </div>
  );
}

function SelectedPlant() {
  const selected = selection.value;
  if (!selected) return null;
  const { plantRef, plant, instants, isEdited } = selected;
  const name = { contact: "Foot", heel: "Heel", toe: "Toe" }[plantRef.part];
  return (
    <>
      <p class={`plant-title ${plantRef.side}`}>
        <span class="dot" aria-hidden="true" />
        {plantRef.side === "left" ? "Left" : "Right"} {plantRef.part}
        {plant && `, plant ${plant.number}`}
        {isEdited && <span class="muted"> · edited</span>}
      </p>
      <p class="note plant-instants">
        <InstantText name={`${name} strike`} instant={instants.strike} />
        <InstantText name={`${name} off`} instant={instants.off} />
      </p>
      <div class="form-rows plant-edges">
        <EdgeField name="First" edge="start" plant={plantRef} command="set-start" />
        <EdgeField name="Last" edge="end" plant={plantRef} command="set-end" />
      </div>
      <div class="plant-actions">
        {(["split", "join", "delete"] as const).map((id) => (
          <button
            key={id}
            type="button"
            class="button"
            title={tooltip(id)}
            onClick={commandOf(id).run}
          >
            {commandOf(id).label}
          </button>
        ))}
        <button type="button" class="button" disabled={!isEdited} onClick={revertSelected}>
          Revert
        </button>
      </div>
    </>
  );
}

/** An instant with its standard deviation. */
function InstantText({ name, instant }: { name: string; instant: Instant | undefined }) {
  if (!instant) return null;
  const { time, uncertainty } = instant;
  return (
    <span title="Time and its standard deviation">
      {name} {time.toFixed(3)} s ± {Math.max(1, Math.round(1000 * uncertainty))} ms
    </span>
  );
}

/** Returns the first or the last frame of a plant, both part of it. */
const edgeFrame = (plant: FrameRange, edge: "start" | "end") =>
  edge === "start" ? plant.start : plant.end - 1;

function EdgeField({
  name,
  edge,
  plant,
  command,
}: {
  name: string;
  edge: "start" | "end";
  plant: FrameRange;
  command: CommandId;
}) {
  const id = useId();
  return (
    <div class="frame-field">
      <label for={id}>{name} frame</label>
      <EdgeStepper edge={edge}>
        <input
          id={id}
          class="input"
          type="number"
          min={0}
          max={(openClip.value?.frames ?? 1) - 1}
          step={1}
          value={edgeFrame(plant, edge)}
          onChange={async (event) => {
            const field = event.currentTarget;
            const frame = field.valueAsNumber;
            if (Number.isInteger(frame))
              await resizeSelected(edge === "start" ? { start: frame } : { end: frame + 1 });
            // Invalid input is replaced by the current value.
            field.value = String(edgeFrame(selection.value?.plantRef ?? plant, edge));
          }}
        />
      </EdgeStepper>
      <button
        type="button"
        class="button"
        aria-label={commandOf(command).label}
        title={tooltip(command)}
        onClick={commandOf(command).run}
      >
        Set to playhead
      </button>
    </div>
  );
}

/** The track to which a plant is added, and the button that adds it. */
function AddPlant() {
  const target = targetTrack.value;
  if (!target) return null;
  const parts = (["contact", "heel", "toe"] as const).filter(
    (name) => detection.value?.parts[name],
  );
  const { side, part } = target;
  return (
    <div class="add-plant">
      <select
        class="select"
        aria-label="Foot"
        value={side}
        onChange={(event) => {
          addTarget.value = { part, side: event.currentTarget.value as Side };
        }}
      >
        <option value="left">Left</option>
        <option value="right">Right</option>
      </select>
      <select
        class="select"
        aria-label="Part"
        value={part}
        onChange={(event) => {
          addTarget.value = { side, part: event.currentTarget.value as Part };
        }}
      >
        {parts.map((name) => (
          <option key={name} value={name} selected={name === part}>
            {capitalize(name)}
          </option>
        ))}
      </select>
      <button
        type="button"
        class="button"
        title={tooltip("add")}
        onClick={() => addAtPlayhead(side, part)}
      >
        Add plant
      </button>
      {plantEdits.value.length > 0 && (
        <button type="button" class="link" onClick={revertAll}>
          Revert all
        </button>
      )}
    </div>
  );
}
