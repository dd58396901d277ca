import { seekPlant } from "../actions/playback";
import { openClip, plants } from "../store/session";
import { useSettled } from "./use-settled";

/** More rows than this help nobody who listens; the Labels panel lists them all. */
const most = 100;

/** The lanes in words, for screen readers: reached by browsing, not in the way of Tab. */
export function PlantTable() {
  const rate = openClip.value?.rate ?? 1;
  const all = useSettled(plants);
  const listed = all.slice(0, most);
  if (!listed.length) return null;
  return (
    <table>
      <caption>
        {all.length} plants{all.length > most ? `, the first ${most} listed` : ""}
      </caption>
      <thead>
        <tr>
          <th>Plant</th>
          <th>Foot</th>
          <th>Start</th>
          <th>Duration</th>
        </tr>
      </thead>
      <tbody>
        {listed.map((plant) => (
          <tr key={plant.number}>
            <td>
              <button type="button" tabIndex={-1} onClick={() => seekPlant(plant)}>
                Go to plant {plant.number}
              </button>
            </td>
            <td>
              {plant.side}
              {plant.edited && ", edited"}
            </td>
            <td>{(plant.start / rate).toFixed(2)} s</td>
            <td>{((plant.end - plant.start) / rate).toFixed(2)} s</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}
