import { useSignal } from "@preact/signals";
import { type CommandId, commandOf, isEnabled, keyOf, tooltip } from "../actions/commands";
import {
  addAtPlayhead,
  resizeSelected,
  revertAll,
  revertSelected,
  selection,
} from "../actions/edit";
import type { FrameRange } from "../model/edits";
import type { Instant } from "../model/plants";
import type { Part, Side } from "../model/types";
import { detection, edits } from "../store/session";
import { Icon } from "../ui/icons";
import { StorageNotices } from "./StorageNotices";

/** Buttons and fields for all edits, as an alternative to dragging. */
export function PlantEditor() {
  return (
    <div class="field plant-editor">
      <div class="field-head">
        <h2>Edit</h2>
        <HistoryButton id="undo" />
        <HistoryButton id="redo" />
      </div>
      <StorageNotices />
      {selection.value ? (
        <SelectedPlant />
      ) : (
        <p class="note">Select a bar on the timeline or a plant in the list to edit it.</p>
      )}
      <AddPlant />
    </div>
  );
}

function HistoryButton({ id }: { id: "undo" | "redo" }) {
  const command = commandOf(id);
  return (
    <button
      type="button"
      class="button flat icon-only"
      aria-label={command.label}
      title={tooltip(id)}
      disabled={!isEnabled(command)}
      onClick={command.run}
    >
      <Icon name={id} />
    </button>
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
      {(instants.strike || instants.off) && (
        <p class="note plant-instants">
          <InstantText name={`${name} strike`} instant={instants.strike} />
          <InstantText name={`${name} off`} instant={instants.off} />
        </p>
      )}
      <div class="form-rows plant-edges">
        <EdgeField
          name="Start"
          value={plantRef.start}
          toRange={(start) => ({ start })}
          command="set-start"
        />
        <EdgeField name="End" value={plantRef.end} toRange={(end) => ({ end })} command="set-end" />
      </div>
      <div class="plant-actions">
        {(["split", "merge", "delete"] as const).map((id) => (
          <button
            key={id}
            type="button"
            class="button"
            title={keyOf(id)}
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

/** An edge in frames; the end is the first frame after the plant. */
function EdgeField({
  name,
  value,
  toRange,
  command,
}: {
  name: string;
  value: number;
  toRange: (frame: number) => Partial<FrameRange>;
  command: CommandId;
}) {
  return (
    <div class="plant-edge">
      <label>
        <span>{name} frame</span>
        <input
          class="input"
          type="number"
          min={0}
          step={1}
          value={value}
          onChange={(event) => {
            const field = event.currentTarget;
            const frame = field.valueAsNumber;
            // Invalid input is replaced by the current value.
            const isValid = Number.isInteger(frame) && resizeSelected(toRange(frame));
            if (!isValid) field.value = String(value);
          }}
        />
      </label>
      <button
        type="button"
        class="button"
        aria-label={commandOf(command).label}
        title={tooltip(command)}
        onClick={commandOf(command).run}
      >
        Set
      </button>
    </div>
  );
}

function AddPlant() {
  const side = useSignal<Side>("left");
  const part = useSignal<Part>("contact");
  const parts = (["contact", "heel", "toe"] as const).filter(
    (name) => detection.value?.parts[name],
  );
  const chosen = parts.includes(part.value) ? part.value : parts[0];
  if (!chosen) return null;
  return (
    <div class="add-plant">
      <select
        class="select"
        aria-label="Foot"
        value={side.value}
        onChange={(event) => {
          side.value = event.currentTarget.value as Side;
        }}
      >
        <option value="left">Left</option>
        <option value="right">Right</option>
      </select>
      <select
        class="select"
        aria-label="Part"
        value={chosen}
        onChange={(event) => {
          part.value = event.currentTarget.value as Part;
        }}
      >
        {parts.map((name) => (
          <option key={name} value={name}>
            {name[0]?.toUpperCase() + name.slice(1)}
          </option>
        ))}
      </select>
      <button
        type="button"
        class="button"
        title={tooltip("add")}
        onClick={() => addAtPlayhead(side.value, chosen)}
      >
        Add plant
      </button>
      {edits.value.length > 0 && (
        <button type="button" class="link" onClick={revertAll}>
          Revert all
        </button>
      )}
    </div>
  );
}
