import { gait } from "../store/session";
import { PropertyList } from "../ui/PropertyList";

const titles: Record<string, string> = {
  stance_s: "Stance",
  swing_s: "Swing",
  step_time_s: "Step time",
  step_length_m: "Step length",
  step_width_m: "Step width",
};

/** Statistics of a measure over the clip. */
type Statistics = { mean: number; sd?: number; count: number } | undefined;

/** Gait measures of the clip. */
export function GaitSection() {
  const measures = gait.value;
  if (!measures?.strides) return null;
  const { strides, cadence, speed, sides, symmetry } = measures;
  const { doubleSupportShare: doubleSupport, flightShare: flight } = measures;
  const symmetryIndices = [
    ["stance", symmetry.stance],
    ["step length", symmetry.stepLength],
  ] as const;
  const facts = [
    ["Cadence", cadence && `${cadence.toFixed(0)} steps/min`],
    ["Speed", speed && `${speed.toFixed(2)} m/s`],
    ["Double support", strideFraction(doubleSupport)],
    ["Flight", flight && flight.mean > 0.005 && strideFraction(flight)],
    ...symmetryIndices.map(
      ([name, index]) => [`Symmetry index, ${name}`, symmetryText(index)] as const,
    ),
  ] as const;
  return (
    <div class="field">
      <h2 id="gait">Gait</h2>
      <table class="data-table" aria-labelledby="gait">
        <thead>
          <tr>
            <th scope="col">
              {strides} {strides === 1 ? "stride" : "strides"}
            </th>
            <th scope="col">Left</th>
            <th scope="col">Right</th>
          </tr>
        </thead>
        <tbody>
          {sides
            .filter(({ name }) => titles[name])
            .map(({ name, left, right }) => (
              <tr key={name}>
                <th scope="row">{titles[name]}</th>
                <td title={deviationText(left)}>{meanText(name, left)}</td>
                <td title={deviationText(right)}>{meanText(name, right)}</td>
              </tr>
            ))}
        </tbody>
      </table>
      <PropertyList properties={facts} />
    </div>
  );
}

function meanText(name: string, statistics: Statistics): string {
  if (!statistics) return "–";
  return name.endsWith("_m")
    ? `${(100 * statistics.mean).toFixed(0)} cm`
    : `${statistics.mean.toFixed(2)} s`;
}

function deviationText(statistics: Statistics): string | undefined {
  if (!statistics) return undefined;
  const { sd, count } = statistics;
  return sd === undefined ? "Single value" : `± ${sd.toFixed(3)} (standard deviation of ${count})`;
}

const strideFraction = (statistics: Statistics) =>
  statistics && `${(100 * statistics.mean).toFixed(0)} % of a stride`;

/** Formats a symmetry index: `0 %`, or `right +16 %` for a longer right side. */
function symmetryText(index: number | undefined): string | undefined {
  if (index === undefined) return undefined;
  const percent = Math.round(index);
  if (percent === 0) return "0 %";
  return `right ${percent > 0 ? "+" : "−"}${Math.abs(percent)} %`;
}
