import { setDetectOptions } from "../actions/detect";
import { positionToR, rToPosition, sensitivity } from "../model/sensitivity";
import { detectOptions } from "../store/settings";
import { Slider } from "./Slider";

/** r: how far the variance of the norms may grow before the knee. */
export function SensitivitySlider() {
  return (
    <Slider
      id="sensitivity"
      name="Sensitivity r"
      value={detectOptions.value.r}
      usual={sensitivity.default}
      text={(at) => at.toFixed(4)}
      spoken={(at) => `r ${at.toFixed(4)}`}
      range={{ min: 0, max: 1, step: 0.005, to: rToPosition, from: positionToR }}
      ends={["Strict", "Generous"]}
      set={(to) => setDetectOptions({ r: to })}
    />
  );
}

/** w: how many frames to either side a sample takes in. */
export function WindowSlider() {
  return (
    <Slider
      id="window"
      name="Window w"
      value={detectOptions.value.w}
      usual={1}
      text={(at) => (at === 0 ? "1 frame" : `± ${at} ${at === 1 ? "frame" : "frames"}`)}
      range={{ min: 0, max: 4, step: 1 }}
      ends={["Sharp", "Smooth"]}
      set={(to) => setDetectOptions({ w: to })}
    />
  );
}
