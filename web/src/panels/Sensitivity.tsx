import { setOptions } from "../app/detect";
import { options } from "../app/state";
import { positionToR, rToPosition, sensitivity } from "../lib/logSlider";
import { Slider } from "./Slider";

/** r: how far the variance of the norms may grow before the knee. */
export function Sensitivity() {
  return (
    <Slider
      id="sensitivity"
      name="Sensitivity r"
      value={options.value.r}
      usual={sensitivity.default}
      text={(at) => at.toFixed(4)}
      spoken={(at) => `r ${at.toFixed(4)}`}
      range={{ min: 0, max: 1, step: 0.005, to: rToPosition, from: positionToR }}
      ends={["Strict", "Generous"]}
      set={(to) => setOptions({ r: to })}
    />
  );
}

/** w: how many frames to either side a sample takes in. */
export function Window() {
  return (
    <Slider
      id="window"
      name="Window w"
      value={options.value.w}
      usual={1}
      text={(at) => (at === 0 ? "1 frame" : `± ${at} ${at === 1 ? "frame" : "frames"}`)}
      range={{ min: 0, max: 4, step: 1 }}
      ends={["Sharp", "Smooth"]}
      set={(to) => setOptions({ w: to })}
    />
  );
}
