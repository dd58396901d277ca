import { setOverrides } from "../actions/detect";
import type { Clip, Overrides, Up } from "../model/types";
import { clip, openClip, overrides, source } from "../store/session";
import { PropertyList } from "../ui/PropertyList";
import { formatBytes, formatCount, formatDuration, formatRate } from "../util/format";
import { FootSkateSection } from "./FootSkateSection";
import { GaitSection } from "./GaitSection";

const ups: readonly Up[] = ["y", "z", "x", "-y", "-z", "-x"];
const footRole = /^(hips|(left|right)_(thigh|shank|ankle|toe|tip))$/;

export function ClipPanel() {
  const held = openClip.value;
  if (!held) return null;
  return (
    <>
      <div class="field">
        <h2>Clip</h2>
        <PropertyList properties={factsOf(held)} />
      </div>
      <FootSkateSection />
      <GaitSection />
      <div class="field">
        <h2>Read it as</h2>
        <Reading clip={held} />
      </div>
      <div class="field">
        <h2>Joints of the feet</h2>
        <Roles clip={held} />
      </div>
    </>
  );
}

function factsOf(held: Clip) {
  return [
    ["File", held.name],
    ["Size", formatBytes(source.value?.data.size ?? 0)],
    ["Frames", formatCount(held.frames)],
    ["Duration", formatDuration(held.frames / held.rate)],
    ["Rate", formatRate(held.rate)],
    ["Joints", formatCount(held.joints.filter((joint) => joint.kind !== "end-site").length)],
    ["Up axis", axis(held.up)],
    ["Unit", held.unit ?? `${Number(held.metresPerUnit.toPrecision(3))} m`],
    ["Leg", held.leg !== undefined && `${(100 * held.leg).toFixed(0)} cm`],
  ] as const;
}

/** `z`, or `−z` with a real minus. */
const axis = (up: Up) => up.replace("-", "−").toUpperCase();

/** The same overrides with one thing changed, or back as found. */
function change<K extends keyof Overrides>(key: K, value: Overrides[K] | undefined) {
  const next = { ...overrides.value };
  if (value === undefined) delete next[key];
  else next[key] = value;
  setOverrides(next);
}

function Reading({ clip: held }: { clip: Clip }) {
  const { rate, up } = overrides.value;
  return (
    <div class="rows">
      <label>
        <span>Rate</span>
        <input
          class="input"
          type="number"
          min="1"
          max="1000"
          step="any"
          inputMode="decimal"
          placeholder={`${Number(held.rate.toFixed(2))} as found`}
          value={rate === undefined ? "" : String(rate)}
          onChange={(event) => {
            const asked = event.currentTarget.valueAsNumber;
            change("rate", asked >= 1 && asked <= 1000 ? asked : undefined);
          }}
        />
      </label>
      <label>
        <span>Up axis</span>
        <select
          class="select"
          value={up ?? ""}
          onChange={(event) =>
            change("up", (event.currentTarget.value || undefined) as Up | undefined)
          }
        >
          <option value="">{up ? "As found" : `${axis(held.up)} as found`}</option>
          {ups.map((name) => (
            <option key={name} value={name}>
              {axis(name)}
            </option>
          ))}
        </select>
      </label>
    </div>
  );
}

function Roles({ clip: held }: { clip: Clip }) {
  const chosen = overrides.value.roles ?? {};
  const choose = (role: string, value: string) => {
    const roles = { ...chosen };
    if (value === "") delete roles[role];
    else roles[role] = Number(value);
    change("roles", Object.keys(roles).length ? roles : undefined);
  };
  return (
    <div class="rows">
      {held.roleNames
        .filter((role) => footRole.test(role))
        .map((role) => {
          const override = chosen[role];
          const found = held.roles[role];
          return (
            <label key={role}>
              <span>{words(role)}</span>
              <select
                class="select"
                value={override === undefined ? "" : String(override)}
                onChange={(event) => choose(role, event.currentTarget.value)}
              >
                <option value="">
                  {override !== undefined
                    ? "As found"
                    : found === undefined
                      ? "None found"
                      : jointName(found)}
                </option>
                <option value="-1">None</option>
                {held.joints.map((_, i) => (
                  <option key={i} value={String(i)}>
                    {jointName(i)}
                  </option>
                ))}
              </select>
            </label>
          );
        })}
    </div>
  );
}

function words(role: string) {
  const text = role.replace("_", " ");
  return text.charAt(0).toUpperCase() + text.slice(1);
}

/** End sites have no name of their own. */
function jointName(index: number): string {
  const joints = clip.value?.joints ?? [];
  const joint = joints[index];
  if (!joint) return "None";
  if (joint.name) return joint.name;
  return `End of ${joints[joint.parent ?? 0]?.name ?? "root"}`;
}
