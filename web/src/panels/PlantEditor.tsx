import { useSignal } from "@preact/signals";
import {
  addAtPlayhead,
  canRedo,
  canUndo,
  endAtPlayhead,
  mergeNext,
  redo,
  removeSelected,
  resizeSelected,
  revertAll,
  revertSelected,
  selection,
  splitAtPlayhead,
  startAtPlayhead,
  undo,
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
        <Step name="undo" keys="Ctrl Z" enabled={canUndo.value} act={undo} />
        <Step name="redo" keys="Ctrl Shift Z" enabled={canRedo.value} act={redo} />
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

function Step({
  name,
  keys,
  enabled,
  act,
}: {
  name: "undo" | "redo";
  keys: string;
  enabled: boolean;
  act: () => void;
}) {
  const title = name === "undo" ? "Undo" : "Redo";
  return (
    <button
      type="button"
      class="button plain icon-only"
      aria-label={title}
      title={`${title} (${keys})`}
      disabled={!enabled}
      onClick={act}
    >
      <Icon name={name} />
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
        {isEdited && <span class="quiet"> · edited</span>}
      </p>
      <div class="rows edges">
        <Edge
          name="Start"
          value={plantRef.start}
          to={(start) => ({ start })}
          here={startAtPlayhead}
          keys="I"
        />
        <Edge
          name="End"
          value={plantRef.end}
          to={(end) => ({ end })}
          here={endAtPlayhead}
          keys="O"
        />
      </div>
      <div class="edit-actions">
        <button type="button" class="button" title="K" onClick={splitAtPlayhead}>
          Split here
        </button>
        <button type="button" class="button" title="M" onClick={mergeNext}>
          Merge with next
        </button>
        <button type="button" class="button" title="Delete" onClick={removeSelected}>
          Delete
        </button>
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
  here,
  keys,
}: {
  name: string;
  value: number;
  to: (frame: number) => Partial<FrameRange>;
  here: () => void;
  keys: string;
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
        title={`At the playhead (${keys})`}
        onClick={here}
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
        title="A plant at the playhead (A)"
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
