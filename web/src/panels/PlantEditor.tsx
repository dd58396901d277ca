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
import type { Part, Side } from "../model/types";
import { detection, edits, persistError } from "../store/session";
import { Icon } from "../ui/icons";

/** All that can be done to labels by hand, without a drag. */
export function PlantEditor() {
  return (
    <div class="field edit">
      <div class="field-head">
        <h2>Edit</h2>
        <HistoryButton id="undo" />
        <HistoryButton id="redo" />
      </div>
      {selection.value ? (
        <Selected />
      ) : (
        <p class="note">Choose a bar of the timeline, or a plant below, to change it.</p>
      )}
      <Add />
      {persistError.value && (
        <p class="note" role="status">
          {persistError.value}
        </p>
      )}
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

function Selected() {
  const held = selection.value;
  if (!held) return null;
  const { plantRef, number, isEdited } = held;
  return (
    <>
      <p class={`edit-title ${plantRef.side}`}>
        <span class="dot" aria-hidden="true" />
        {plantRef.side === "left" ? "Left" : "Right"} {plantRef.part}
        {number !== undefined && `, plant ${number}`}
        {isEdited && <span class="muted"> · edited</span>}
      </p>
      <div class="rows edges">
        <Edge name="Start" value={plantRef.start} to={(start) => ({ start })} command="set-start" />
        <Edge name="End" value={plantRef.end} to={(end) => ({ end })} command="set-end" />
      </div>
      <div class="edit-actions">
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
          As detected
        </button>
      </div>
    </>
  );
}

/** One edge in frames: the end is the first frame after. */
function Edge({
  name,
  value,
  to,
  command,
}: {
  name: string;
  value: number;
  to: (frame: number) => Partial<FrameRange>;
  command: CommandId;
}) {
  return (
    <div class="edge">
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
            const asked = field.valueAsNumber;
            // What cannot be is not left standing there.
            if (!Number.isInteger(asked) || !resizeSelected(to(asked))) field.value = String(value);
          }}
        />
      </label>
      <button
        type="button"
        class="button"
        aria-label={`${name} here`}
        title={tooltip(command)}
        onClick={commandOf(command).run}
      >
        Here
      </button>
    </div>
  );
}

function Add() {
  const side = useSignal<Side>("left");
  const part = useSignal<Part>("contact");
  const parts = (["contact", "heel", "toe"] as const).filter(
    (known) => detection.value?.parts[known],
  );
  const chosen = parts.includes(part.value) ? part.value : parts[0];
  if (!chosen) return null;
  return (
    <div class="add">
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
        Add here
      </button>
      {edits.value.length > 0 && (
        <button type="button" class="link" onClick={revertAll}>
          All as detected
        </button>
      )}
    </div>
  );
}
