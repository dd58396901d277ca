/** The track of a slider, and how values lie on it where not evenly. */
interface Range {
  min: number;
  max: number;
  step: number;
  to?: (value: number) => number;
  from?: (position: number) => number;
}

interface Props {
  id: string;
  name: string;
  value: number;
  /** What it is set back to. */
  usual: number;
  text: (value: number) => string;
  /** What a screen reader says; the text where absent. */
  spoken?: (value: number) => string;
  range: Range;
  ends: readonly [low: string, high: string];
  set: (value: number) => void;
}

/** A named value on a slider, with a way back to what is usual. */
export function Slider({ id, name, value, usual, text, spoken = text, range, ends, set }: Props) {
  const { min, max, step, to = same, from = same } = range;
  const position = to(value);
  return (
    <div class="field">
      <div class="field-head">
        <h2>
          <label for={id}>{name}</label>
        </h2>
        {value !== usual && (
          <button type="button" class="link" onClick={() => set(usual)}>
            Reset<span class="visually-hidden"> {name.split(" ")[0]?.toLowerCase()}</span>
          </button>
        )}
        <output for={id}>{text(value)}</output>
      </div>
      <input
        id={id}
        type="range"
        min={min}
        max={max}
        step={step}
        value={position}
        // The part left of the thumb, which only Firefox can style by itself.
        ref={(input) => {
          input?.style.setProperty("--fraction", String((position - min) / (max - min)));
        }}
        aria-valuetext={spoken(value)}
        onInput={(event) => set(from(event.currentTarget.valueAsNumber))}
      />
      <p class="slider-ends" aria-hidden="true">
        <span>{ends[0]}</span>
        <span>{ends[1]}</span>
      </p>
    </div>
  );
}

const same = (value: number) => value;
