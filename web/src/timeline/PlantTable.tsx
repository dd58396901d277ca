import { seekPlant } from "../actions/view/playback";
import { openClip, plants } from "../store/session";
import { AccessibleTable } from "./AccessibleTable";

/** The plants of both feet for screen readers. */
export function PlantTable() {
  return (
    <AccessibleTable
      items={plants}
      noun="plant"
      columns={["Plant", "Foot"]}
      cells={({ side, edited }) => [edited ? `${side}, edited` : side]}
      buttonLabel={({ number }) => `Go to plant ${number}`}
      onSelect={seekPlant}
      rate={openClip.value?.rate ?? 1}
    />
  );
}
