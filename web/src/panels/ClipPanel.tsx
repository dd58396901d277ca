import { useEffect } from "preact/hooks";
import { setOverrides } from "../actions/analyse/detect";
import { groundText } from "../model/motion/ground";
import type { Clip, Overrides, Up } from "../model/types";
import { clipTitle, detection, openClip, overrides, source } from "../store/session";
import { markedJoint } from "../store/view";
import { PropertyList } from "../ui/PropertyList";
import { capitalize, formatBytes, formatCount, formatDuration, formatRate } from "../util/format";
import { FootSkateSection } from "./FootSkateSection";
import { GaitSection } from "./GaitSection";

const ups: readonly Up[] = ["y", "z", "x", "-y", "-z", "-x"];
const footRole = /^(hips|(left|right)_(thigh|shank|ankle|toe|tip))$/;

/** Properties of the clip, foot skate, gait, and import settings. */
export function ClipPanel() {
  const clip = openClip.value;
  if (!clip) return null;
  return (
    <>
      <div class="field">
        <h2>Clip</h2>
        <PropertyList properties={factsOf(clip)} />
      </div>
      <FootSkateSection />
      <GaitSection />
      <div class="field">
        <h2>Import settings</h2>
        <ImportSettings clip={clip} />
      </div>
      <div class="field">
        <h2>Foot joints</h2>
        <FootJoints clip={clip} />
      </div>
    </>
  );
}

/** The unit, with its size if the name does not state it. */
function unitText({ unit, metresPerUnit }: Clip): string {
  if (!unit) return `${Number(metresPerUnit.toPrecision(3))} m`;
  const isMetric = /^[cmd]?m$/.test(unit);
  return isMetric
    ? unit
    : `${unit.replace(/ unit$/, "")} (1 unit = ${Number((100 * metresPerUnit).toPrecision(3))} cm)`;
}

function factsOf(clip: Clip) {
  return [
    ["File", clipTitle.value],
    ["Size", formatBytes(source.value?.data.size ?? 0)],
    ["Frames", formatCount(clip.frames)],
    ["Duration", formatDuration(clip.frames / clip.rate)],
    ["Rate", formatRate(clip.rate)],
    ["Joints", formatCount(clip.joints.filter((joint) => joint.kind !== "end-site").length)],
    ["Up axis", axisText(clip.up)],
    ["Unit", unitText(clip)],
    ["Ground", detection.value ? groundText(detection.value.ground) : undefined],
    ["Noise of planted toes", millimetres(detection.value?.noise?.position)],
    ["Speed of planted feet", millimetres(detection.value?.noise?.speed, "/s")],
    ["Leg length", clip.leg !== undefined && `${(100 * clip.leg).toFixed(0)} cm`],
  ] as const;
}

/** Returns a length in metres as text in millimetres: `0.42 mm`, `35 mm`. */
function millimetres(metres: number | undefined, per = "") {
  if (metres === undefined) return undefined;
  return `${(1000 * metres).toFixed(metres < 0.01 ? 1 : 0)} mm${per}`;
}

/** Returns the display text of an axis: `Z`, `−Z`. */
const axisText = (up: Up) => up.replace("-", "−").toUpperCase();

/** Changes one override; undefined removes it. */
function changeOverride<K extends keyof Overrides>(key: K, value: Overrides[K] | undefined) {
  const next = { ...overrides.value };
  if (value === undefined) delete next[key];
  else next[key] = value;
  setOverrides(next);
}

function ImportSettings({ clip }: { clip: Clip }) {
  const { rate, up, metresPerUnit } = overrides.value;
  return (
    <div class="form-rows">
      <label>
        <span>Rate</span>
        <input
          class="input"
          type="number"
          min="1"
          max="1000"
          step="any"
          inputMode="decimal"
          placeholder={`${Number(clip.rate.toFixed(2))} (detected)`}
          value={rate === undefined ? "" : String(rate)}
          onChange={(event) => {
            const value = event.currentTarget.valueAsNumber;
            changeOverride("rate", value >= 1 && value <= 1000 ? value : undefined);
          }}
        />
      </label>
      <label>
        <span>Metres per unit</span>
        <input
          class="input"
          type="number"
          min="0"
          step="any"
          inputMode="decimal"
          placeholder={`${Number(clip.metresPerUnit.toPrecision(3))} (${clip.unit ? `${clip.unit}, ` : ""}detected)`}
          value={metresPerUnit === undefined ? "" : String(metresPerUnit)}
          onChange={(event) => {
            const value = event.currentTarget.valueAsNumber;
            changeOverride("metresPerUnit", value > 0 && value < 1e6 ? value : undefined);
          }}
        />
      </label>
      <label>
        <span>Up axis</span>
        <select
          class="select"
          value={up ?? ""}
          onChange={(event) =>
            changeOverride("up", (event.currentTarget.value || undefined) as Up | undefined)
          }
        >
          <option value="">{up ? "Detected" : `${axisText(clip.up)} (detected)`}</option>
          {ups.map((name) => (
            <option key={name} value={name}>
              {axisText(name)}
            </option>
          ))}
        </select>
      </label>
    </div>
  );
}

function FootJoints({ clip }: { clip: Clip }) {
  useEffect(
    () => () => {
      markedJoint.value = null;
    },
    [],
  );
  return (
    <div class="form-rows">
      {clip.roleNames
        .filter((role) => footRole.test(role))
        .map((role) => (
          <FootJoint key={role} clip={clip} role={role} />
        ))}
    </div>
  );
}

/** The joint of one role and the evidence for it. The view marks the joint while the row is in use. */
function FootJoint({ clip, role }: { clip: Clip; role: string }) {
  const overridden = overrides.value.roles ?? {};
  const override = overridden[role];
  const joint = clip.roles[role];
  const evidence = clip.roleEvidence[role];
  const setRole = (value: string) => {
    const roles = { ...overridden };
    if (value === "") delete roles[role];
    else roles[role] = Number(value);
    changeOverride("roles", Object.keys(roles).length ? roles : undefined);
  };
  const mark = () => {
    markedJoint.value = joint ?? null;
  };
  const unmark = () => {
    markedJoint.value = null;
  };
  const evidenceId = `evidence-${role}`;
  return (
    <div class="role-row" onPointerEnter={mark} onPointerLeave={unmark}>
      <label>
        <span>{roleTitle(role)}</span>
        <select
          class="select"
          value={override === undefined ? "" : String(override)}
          aria-describedby={evidence && evidenceId}
          onFocus={mark}
          onBlur={unmark}
          onChange={(event) => setRole(event.currentTarget.value)}
        >
          <option value="">
            {override !== undefined
              ? "Detected"
              : joint === undefined
                ? "None detected"
                : jointName(clip, joint)}
          </option>
          <option value="-1">None</option>
          {clip.joints.map((_, i) => (
            <option key={i} value={String(i)}>
              {jointName(clip, i)}
            </option>
          ))}
        </select>
      </label>
      {evidence && (
        <p id={evidenceId} class="role-evidence">
          {evidence.doubtful && <strong>Uncertain: </strong>}
          {(100 * evidence.confidence).toFixed(0)} % by {evidence.reasons.join(", ")}
        </p>
      )}
    </div>
  );
}

/** Returns the display text of a role: `Left ankle`, `Right toe end`. */
function roleTitle(role: string) {
  return capitalize(role.replace("_", " ").replace("shank", "shin").replace("tip", "toe end"));
}

/** Returns the name of a joint; end sites, which have none, are named after their parent. */
function jointName({ joints }: Clip, index: number): string {
  const joint = joints[index];
  if (!joint) return "None";
  if (joint.name) return joint.name;
  return `End of ${joints[joint.parent ?? 0]?.name ?? "root"}`;
}
