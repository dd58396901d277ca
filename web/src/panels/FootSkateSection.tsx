import {
  cleanClip,
  discardCleaned,
  saveCleaned,
  setCleanedView,
} from "../actions/analyse/footskate";
import { selection } from "../actions/edit/edit";
import { jumpTo } from "../actions/view/playback";
import { formatCentimetres, summarizeSlides } from "../model/plants/slides";
import type { CleanedClip } from "../model/types";
import type { CleanedView } from "../store/clip-session";
import {
  cleaned,
  cleanedOnly,
  cleanedView,
  cleaning,
  clip,
  plants,
  repairsSpikes,
  slides,
} from "../store/session";
import { plural } from "../util/format";

const views: readonly (readonly [CleanedView, string])[] = [
  ["before", "Original"],
  ["after", "Cleaned"],
  ["both", "Both"],
];

/** Slides of planted feet, and the removal of foot skate. */
export function FootSkateSection() {
  const before = summarizeSlides(slides.value.map(({ maxDistance }) => maxDistance));
  const result = cleaned.value;
  if (!before) return null;
  const after = result && summarizeSlides(result.plants.map((plant) => plant.after));
  const worst = slides.value.reduce((a, b) => (b.maxDistance > a.maxDistance ? b : a));
  return (
    <div class="field">
      <h2 id="skate">Foot skate</h2>
      <table class="data-table" aria-labelledby="skate">
        <thead>
          <tr>
            <th
              scope="col"
              title="Largest horizontal distance of the planted part from its mean position"
            >
              Foot slide, {plural(plants.value.length, "plant")}
            </th>
            <th scope="col">Mean</th>
            <th scope="col">Max</th>
          </tr>
        </thead>
        <tbody>
          <tr>
            <th scope="row">Original</th>
            <td>{formatCentimetres(before.mean)}</td>
            <td>
              <button
                type="button"
                class="link"
                title={`Go to frame ${worst.frame}, where the ${worst.side} foot slides most`}
                onClick={() => jumpTo(worst.frame)}
              >
                {formatCentimetres(before.worst)}
              </button>
            </td>
          </tr>
          {after && (
            <tr>
              <th scope="row">Cleaned</th>
              <td>{formatCentimetres(after.mean)}</td>
              <td>{formatCentimetres(after.worst)}</td>
            </tr>
          )}
        </tbody>
      </table>
      {result ? <CleanResult cleaned={result} /> : <CleanButtons />}
    </div>
  );
}

/** Starts the clean-up of all plants, or of the selected one. */
function CleanButtons() {
  const selected = selection.value?.plantRef;
  return (
    <p class="clean-buttons">
      <button
        type="button"
        class="button"
        disabled={cleaning.value}
        onClick={() => void cleanClip()}
      >
        Fix foot skate
      </button>
      <button
        type="button"
        class="button"
        disabled={cleaning.value || !selected}
        title="Correct only the selected plant"
        onClick={() => {
          if (!selected) return;
          const { side, start, end } = selected;
          void cleanClip({ only: [{ side, start, end }] });
        }}
      >
        Only selected plant
      </button>
    </p>
  );
}

/** Choice of the displayed version, saving, and plants that could not be constrained. */
function CleanResult({ cleaned: { plants, notices } }: { cleaned: CleanedClip }) {
  const isLimited = cleanedOnly.value.length > 0;
  const skipped = isLimited ? [] : plants.filter(({ skipReason }) => skipReason !== undefined);
  const rate = clip.value?.rate ?? 1;
  return (
    <>
      <fieldset class="segmented full-width">
        <legend class="visually-hidden">Displayed version</legend>
        {views.map(([view, name]) => (
          <button
            key={view}
            type="button"
            aria-pressed={cleanedView.value === view}
            onClick={() => setCleanedView(view)}
          >
            {name}
          </button>
        ))}
      </fieldset>
      {cleanedView.value === "both" && (
        <p class="note">
          The original is shown in red. Lines at the feet show the correction, enlarged four times.
        </p>
      )}
      {isLimited && <p class="note">Only the selected plant is corrected.</p>}
      <button type="button" class="button" onClick={saveCleaned}>
        Save cleaned clip <span class="muted">BVH</span>
      </button>
      <button type="button" class="button" onClick={discardCleaned}>
        Discard
      </button>
      <SpikeChoice hasSpikes={notices.some(({ code }) => code === "spike")} />
      {(skipped.length > 0 || notices.length > 0) && (
        <ul class="note-list">
          {skipped.slice(0, 5).map(({ side, start, skipReason }) => (
            <li key={`${side} ${start}`} class="note">
              The {side} foot at {(start / rate).toFixed(2)} s is not constrained: {skipReason}.
            </li>
          ))}
          {skipped.length > 5 && (
            <li class="note">{skipped.length - 5} more plants are not constrained.</li>
          )}
          {notices
            .filter(({ code }) => code !== "unconstrained")
            .map(({ text }) => (
              <li key={text} class="note">
                {text}
              </li>
            ))}
        </ul>
      )}
    </>
  );
}

/** Choice whether spikes of the hips are repaired, if the clip has any. */
function SpikeChoice({ hasSpikes }: { hasSpikes: boolean }) {
  const repairs = repairsSpikes.value;
  if (!hasSpikes && repairs) return null;
  return (
    <label class="checkbox-row">
      <input
        type="checkbox"
        checked={repairs}
        disabled={cleaning.value}
        onChange={() => void cleanClip({ keepSpikes: repairs, only: cleanedOnly.value })}
      />
      Repair spikes of the hips
    </label>
  );
}
