import { detecting, setDetectOptions } from "../actions/analyse/detect";
import { toSentence } from "../model/batch/report";
import { plantedFraction, principalTracks } from "../model/plants/plants";
import type { Side } from "../model/types";
import { detectFailure, detection, plants } from "../store/session";
import { detectMethods, detectOptions } from "../store/settings";
import { SensitivitySlider, WindowSlider } from "../ui/DetectionSliders";
import { Slider } from "../ui/Slider";

/** Methods with an adjustable threshold on height or on speed. */
const heightMethods = ["height", "dual"];
const speedMethods = ["speed", "dual", "min-speed"];
const defaults = { height: 0.05, speed: 0.5 };

/** Detection method, its parameters, and the result. */
export function DetectPanel() {
  const { method, height = defaults.height, speed = defaults.speed } = detectOptions.value;
  const info = detectMethods.value.find(({ name }) => name === method);
  return (
    <>
      <Method name={method} />
      {info?.family !== "mixture" && info?.family !== "threshold" && (
        <>
          <SensitivitySlider />
          <WindowSlider />
        </>
      )}
      {heightMethods.includes(method) && (
        <Slider
          id="height"
          name="Height"
          value={height}
          defaultValue={defaults.height}
          format={(metres) => `${(100 * metres).toFixed(1)} cm`}
          range={{ min: 0.005, max: 0.3, step: 0.005 }}
          endLabels={["Low", "High"]}
          onChange={(value) => setDetectOptions({ height: value })}
        />
      )}
      {speedMethods.includes(method) && (
        <Slider
          id="speed"
          name="Speed"
          value={speed}
          defaultValue={defaults.speed}
          format={(value) => `${value.toFixed(2)} m/s`}
          range={{ min: 0.05, max: 3, step: 0.05 }}
          endLabels={["Slow", "Fast"]}
          onChange={(value) => setDetectOptions({ speed: value })}
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
        {groups.map(([title, methods]) => (
          <optgroup key={title} label={title}>
            {methods.map((method) => (
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
  const tracks = detection.value && principalTracks(detection.value.parts);
  return (
    <div class="field">
      <h2>Result</h2>
      {tracks ? (
        <dl class="detect-result" aria-busy={detecting.value}>
          <Foot side="left" fraction={plantedFraction(tracks.left)} />
          <Foot side="right" fraction={plantedFraction(tracks.right)} />
        </dl>
      ) : (
        <p class="note">
          {detectFailure.value ? toSentence(detectFailure.value.message) : "Detecting plants…"}
        </p>
      )}
    </div>
  );
}

function Foot({ side, fraction }: { side: Side; fraction: number }) {
  const count = plants.value.filter((plant) => plant.side === side).length;
  return (
    <div class={side}>
      <dt>
        <span class="dot" aria-hidden="true" />
        {side === "left" ? "Left" : "Right"}
      </dt>
      <dd>
        {Math.round(100 * fraction)} % planted
        <span class="muted">
          {count} {count === 1 ? "plant" : "plants"}
        </span>
      </dd>
    </div>
  );
}
