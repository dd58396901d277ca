/** Range of slider positions, with conversions if values are not linear in the position. */
interface Range {
  min: number;
  max: number;
  step: number;
  toPosition?: (value: number) => number;
  fromPosition?: (position: number) => number;
}

interface Props {
  id: string;
  name: string;
  value: number;
  /** The value that the reset button restores. */
  defaultValue: number;
  /** Returns the displayed text. */
  format: (value: number) => string;
  /** Returns the text for screen readers, by default the displayed text. */
  formatForScreenReader?: (value: number) => string;
  range: Range;
  endLabels: readonly [low: string, high: string];
  onChange: (value: number) => void;
}

/** A slider with a label, the formatted value, and a reset button if the value is not the default. */
export function Slider({
  id,
  name,
  value,
  defaultValue,
  format,
  formatForScreenReader = format,
  range,
  endLabels,
  onChange,
}: Props) {
  const { min, max, step, toPosition = identity, fromPosition = identity } = range;
  const position = toPosition(value);
  return (
    <div class="field">
      <div class="field-head">
        <h2>
          <label for={id}>{name}</label>
        </h2>
        {value !== defaultValue && (
          <button type="button" class="link" onClick={() => onChange(defaultValue)}>
            Reset<span class="visually-hidden"> {name.split(" ")[0]?.toLowerCase()}</span>
          </button>
        )}
        <output for={id}>{format(value)}</output>
      </div>
      <input
        id={id}
        type="range"
        min={min}
        max={max}
        step={step}
        value={position}
        // Fraction of the track left of the thumb; only Firefox can style it directly.
        ref={(input) => {
          input?.style.setProperty("--fraction", String((position - min) / (max - min)));
        }}
        aria-valuetext={formatForScreenReader(value)}
        onInput={(event) => onChange(fromPosition(event.currentTarget.valueAsNumber))}
      />
      <p class="slider-ends" aria-hidden="true">
        <span>{endLabels[0]}</span>
        <span>{endLabels[1]}</span>
      </p>
    </div>
  );
}

const identity = (value: number) => value;
