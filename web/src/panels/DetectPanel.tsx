import { detecting, setDetectOptions } from "../actions/detect";
import { plantedFraction, principalTracks } from "../model/plants";
import { toSentence } from "../model/report";
import type { Side } from "../model/types";
import { detectFailure, detection, plants } from "../store/session";
import { detectMethods, detectOptions } from "../store/settings";
import { SensitivitySlider, WindowSlider } from "../ui/DetectionSliders";
import { Slider } from "../ui/Slider";

/** Methods that compare with a height or a speed that can be set. */
const byHeight = ["height", "dual"];
const bySpeed = ["speed", "dual", "min-speed"];
const thresholds = { height: 0.05, speed: 0.5 };

export function DetectPanel() {
  const { method, height = thresholds.height, speed = thresholds.speed } = detectOptions.value;
  const chosen = detectMethods.value.find(({ name }) => name === method);
  return (
    <>
      <Method name={method} />
      {chosen?.family !== "mixture" && chosen?.family !== "threshold" && (
        <>
          <SensitivitySlider />
          <WindowSlider />
        </>
      )}
      {byHeight.includes(method) && (
        <Slider
          id="height"
          name="Height"
          value={height}
          usual={thresholds.height}
          text={(at) => `${(100 * at).toFixed(1)} cm`}
          range={{ min: 0.005, max: 0.3, step: 0.005 }}
          ends={["Low", "High"]}
          set={(to) => setDetectOptions({ height: to })}
        />
      )}
      {bySpeed.includes(method) && (
        <Slider
          id="speed"
          name="Speed"
          value={speed}
          usual={thresholds.speed}
          text={(at) => `${at.toFixed(2)} m/s`}
          range={{ min: 0.05, max: 3, step: 0.05 }}
          ends={["Slow", "Fast"]}
          set={(to) => setDetectOptions({ speed: to })}
        />
      )}
      <Result />
    </>
  );
}

function Method({ name }: { name: string }) {
  const groups = [
    ["Spectral", detectMethods.value.filter(({ family }) => family === "spectral")],
    ["Other", detectMethods.value.filter(({ family }) => family !== "spectral")],
  ] as const;
  return (
    <div class="field">
      <h2>
        <label for="method">Method</label>
      </h2>
      <select
        id="method"
        class="select"
        value={name}
        aria-describedby="method-line"
        onChange={(event) => setDetectOptions({ method: event.currentTarget.value })}
      >
        {groups.map(([title, listed]) => (
          <optgroup key={title} label={title}>
            {listed.map((method) => (
              <option key={method.name} value={method.name} selected={method.name === name}>
                {method.title}
              </option>
            ))}
          </optgroup>
        ))}
      </select>
      <p class="note" id="method-line">
        {detectMethods.value.find((method) => method.name === name)?.description}
      </p>
    </div>
  );
}

function Result() {
  const found = detection.value && principalTracks(detection.value.parts);
  return (
    <div class="field">
      <h2>Result</h2>
      {found ? (
        <dl class="result" aria-busy={detecting.value}>
          <Foot side="left" share={plantedFraction(found.left)} />
          <Foot side="right" share={plantedFraction(found.right)} />
        </dl>
      ) : (
        <p class="note">
          {detectFailure.value ? toSentence(detectFailure.value.message) : "Looking for plants…"}
        </p>
      )}
    </div>
  );
}

function Foot({ side, share }: { side: Side; share: number }) {
  const number = plants.value.filter((plant) => plant.side === side).length;
  return (
    <div class={side}>
      <dt>
        <span class="dot" aria-hidden="true" />
        {side === "left" ? "Left" : "Right"}
      </dt>
      <dd>
        {Math.round(100 * share)} % planted
        <span class="muted">
          {number} {number === 1 ? "plant" : "plants"}
        </span>
      </dd>
    </div>
  );
}
