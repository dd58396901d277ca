import { selection } from "../actions/edit/edit";
import { selectedCut } from "../store/session";
import { CommandButton } from "../ui/CommandButton";
import { CutStepper, EdgeStepper } from "../ui/Stepper";
import { formatCount } from "../util/format";

/** The edits for which there are no keys on a touch screen: undo, single frames and deletion. */
export function EditBar() {
  const plant = selection.value?.plantRef;
  const cut = selectedCut.value;
  const isSelected = plant !== undefined || cut !== null;
  return (
    <fieldset class="edit-bar" data-selected={isSelected}>
      <legend class="visually-hidden">Edit</legend>
      <CommandButton id="undo" />
      <CommandButton id="redo" />
      {plant && (
        <>
          <EdgeStepper edge="start">
            <Value name="First">{plant.start}</Value>
          </EdgeStepper>
          <EdgeStepper edge="end">
            <Value name="Last">{plant.end - 1}</Value>
          </EdgeStepper>
        </>
      )}
      {cut !== null && (
        <CutStepper>
          <Value name="Cut">{cut}</Value>
        </CutStepper>
      )}
      {isSelected && <CommandButton id="delete" />}
    </fieldset>
  );
}

/** The frame of an edge, with its name. */
function Value({ name, children }: { name: string; children: number }) {
  return (
    <p class="edit-value">
      <span class="muted">{name}</span>
      {formatCount(children)}
    </p>
  );
}
