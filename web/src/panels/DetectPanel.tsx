import { setOptions } from "../app/detect";
import { detectFailure, detection, options, plants } from "../app/state";
import { positionToR, rToPosition, sensitivity } from "../lib/logSlider";
import { plantedShare, plantTracks } from "../lib/plants";
import type { Method, Side } from "../worker/types";

const methods: Record<Method, readonly [name: string, line: string]> = {
  robust: [
    "Robust spectral",
    "Labels heel and toe apart, mends glitches first, and reads motion alike at any frame rate.",
  ],
  paper: ["Paper (2014)", "The method as published: toes only, nothing mended."],
};

export function DetectPanel() {
  const { method, r, w } = options.value;
  return (
    <>
      <div class="field">
        <h2>
          <label for="method">Method</label>
        </h2>
        <select
          id="method"
          class="select"
          value={method}
          aria-describedby="method-line"
          onChange={(event) => setOptions({ method: event.currentTarget.value as Method })}
        >
          {Object.entries(methods).map(([id, [name]]) => (
            <option key={id} value={id}>
              {name}
            </option>
          ))}
        </select>
        <p class="note" id="method-line">
          {methods[method][1]}
        </p>
      </div>

      <div class="field">
        <div class="field-head">
          <h2>
            <label for="sensitivity">Sensitivity r</label>
          </h2>
          {r !== sensitivity.default && (
            <button
              type="button"
              class="link"
              onClick={() => setOptions({ r: sensitivity.default })}
            >
              Reset<span class="hidden"> sensitivity</span>
            </button>
          )}
          <output for="sensitivity">{r.toFixed(4)}</output>
        </div>
        <input
          id="sensitivity"
          type="range"
          min="0"
          max="1"
          step="0.005"
          value={rToPosition(r)}
          ref={fill(rToPosition(r))}
          aria-valuetext={`r ${r.toFixed(4)}`}
          onInput={(event) => setOptions({ r: positionToR(event.currentTarget.valueAsNumber) })}
        />
        <p class="ends" aria-hidden="true">
          <span>Strict</span>
          <span>Generous</span>
        </p>
      </div>

      <div class="field">
        <div class="field-head">
          <h2>
            <label for="window">Window w</label>
          </h2>
          {w !== 1 && (
            <button type="button" class="link" onClick={() => setOptions({ w: 1 })}>
              Reset<span class="hidden"> window</span>
            </button>
          )}
          <output for="window">
            {w === 0 ? "1 frame" : `± ${w} ${w === 1 ? "frame" : "frames"}`}
          </output>
        </div>
        <input
          id="window"
          type="range"
          min="0"
          max="4"
          step="1"
          value={w}
          ref={fill(w / 4)}
          onInput={(event) => setOptions({ w: event.currentTarget.valueAsNumber })}
        />
        <p class="ends" aria-hidden="true">
          <span>Sharp</span>
          <span>Smooth</span>
        </p>
      </div>

      <Result />
    </>
  );
}

/** The part of a slider left of its thumb, which only Firefox can style by itself. */
const fill = (share: number) => (input: HTMLInputElement | null) => {
  input?.style.setProperty("--share", String(share));
};

function Result() {
  const found = detection.value;
  return (
    <div class="field">
      <h2>Result</h2>
      {found ? (
        <dl class="result">
          <Foot side="left" share={plantedShare(plantTracks(found).left)} />
          <Foot side="right" share={plantedShare(plantTracks(found).right)} />
        </dl>
      ) : (
        <p class="note">
          {detectFailure.value ? detectFailure.value.message : "Looking for plants…"}
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
        <span class="quiet">
          {number} {number === 1 ? "plant" : "plants"}
        </span>
      </dd>
    </div>
  );
}
