import { setDetectOptions } from "../actions/analyse/detect";
import {
  formatR,
  positionStep,
  positionToR,
  rToPosition,
  sensitivity,
} from "../model/plants/sensitivity";
import { detectOptions } from "../store/settings";
import { Slider } from "./Slider";

/** Sets r, the greatest running variance of the norms up to the knee. */
export function SensitivitySlider() {
  return (
    <Slider
      id="sensitivity"
      name="Sensitivity r"
      value={detectOptions.value.r}
      defaultValue={sensitivity.default}
      format={formatR}
      formatForScreenReader={(value) => `r ${formatR(value)}`}
      range={{
        min: 0,
        max: 1,
        step: positionStep,
        toPosition: rToPosition,
        fromPosition: positionToR,
      }}
      endLabels={["Fewer contacts", "More contacts"]}
      onChange={(r) => setDetectOptions({ r })}
    />
  );
}

/** Sets w, the half-width of the sample window, in frames. */
export function WindowSlider() {
  return (
    <Slider
      id="window"
      name="Window w"
      value={detectOptions.value.w}
      defaultValue={1}
      format={(value) =>
        value === 0 ? "1 frame" : `± ${value} ${value === 1 ? "frame" : "frames"}`
      }
      range={{ min: 0, max: 4, step: 1 }}
      endLabels={["Sharp", "Smooth"]}
      onChange={(w) => setDetectOptions({ w })}
    />
  );
}
