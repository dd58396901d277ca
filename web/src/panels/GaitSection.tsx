import { gait } from "../store/session";
import { PropertyList } from "../ui/PropertyList";

const titles: Record<string, string> = {
  stance_s: "Stance",
  swing_s: "Swing",
  step_time_s: "Step time",
  step_length_m: "Step length",
  step_width_m: "Step width",
};

type Measured = { mean: number; sd?: number; count: number } | undefined;

/** How the person walks, in the terms of gait analysis. */
export function GaitSection() {
  const held = gait.value;
  if (!held?.strides) return null;
  const { cadence, speed, sides, doubleSupportShare, flightShare, symmetry } = held;
  const indices = [
    ["Stance", symmetry.stance],
    ["Step length", symmetry.stepLength],
  ] as const;
  const facts = [
    ["Cadence", cadence && `${cadence.toFixed(0)} steps/min`],
    ["Speed", speed && `${speed.toFixed(2)} m/s`],
    ["Both feet down", share(doubleSupportShare)],
    ["No foot down", flightShare && flightShare.mean > 0.005 && share(flightShare)],
    ...indices.map(([name, index]) => [`${name}, right to left`, lead(index)] as const),
  ] as const;
  return (
    <div class="field">
      <h2 id="gait">Gait</h2>
      <table class="numbers" aria-labelledby="gait">
        <thead>
          <tr>
            <th scope="col">
              {held.strides} {held.strides === 1 ? "stride" : "strides"}
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
                <td title={spread(left)}>{number(name, left)}</td>
                <td title={spread(right)}>{number(name, right)}</td>
              </tr>
            ))}
        </tbody>
      </table>
      <PropertyList properties={facts} />
    </div>
  );
}

function number(name: string, measured: Measured): string {
  if (!measured) return "–";
  return name.endsWith("_m")
    ? `${(100 * measured.mean).toFixed(0)} cm`
    : `${measured.mean.toFixed(2)} s`;
}

function spread(measured: Measured): string | undefined {
  if (!measured) return undefined;
  const { sd, count } = measured;
  return sd === undefined ? "Of one" : `± ${sd.toFixed(3)} (standard deviation of ${count})`;
}

const share = (measured: Measured) =>
  measured && `${(100 * measured.mean).toFixed(0)} % of a stride`;

/** A symmetry index in words: it says which side has more. */
function lead(index: number | undefined): string | undefined {
  if (index === undefined) return undefined;
  const whole = Math.round(index);
  if (whole === 0) return "alike";
  return `${Math.abs(whole)} % ${whole > 0 ? "more" : "less"}`;
}
