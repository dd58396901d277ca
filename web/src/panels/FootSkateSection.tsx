import { cleanClip, saveCleaned, setCleanedView } from "../actions/footskate";
import { pause, seek } from "../actions/playback";
import { formatCentimetres, summarizeSlides } from "../model/slides";
import type { CleanedClip } from "../model/types";
import type { CleanedView } from "../store/clip-session";
import { cleaned, cleanedView, cleaning, clip, slides } from "../store/session";

const views: readonly (readonly [CleanedView, string])[] = [
  ["before", "Before"],
  ["after", "After"],
  ["both", "Both"],
];

/** How far planted feet slide, and the way to hold them still. */
export function FootSkateSection() {
  const found = summarizeSlides(slides.value.map(({ maxDistance }) => maxDistance));
  const made = cleaned.value;
  if (!found) return null;
  const after = made && summarizeSlides(made.plants.map((plant) => plant.after));
  const worst = slides.value.reduce((a, b) => (b.maxDistance > a.maxDistance ? b : a));
  return (
    <div class="field">
      <h2 id="skate">Foot skate</h2>
      <table class="numbers" aria-labelledby="skate">
        <thead>
          <tr>
            <th
              scope="col"
              title="How far what stands is from its mean place, level with the ground"
            >
              Slide of {slides.value.length} plants
            </th>
            <th scope="col">Mean</th>
            <th scope="col">Worst</th>
          </tr>
        </thead>
        <tbody>
          <tr>
            <th scope="row">{made ? "Before" : "Now"}</th>
            <td>{formatCentimetres(found.mean)}</td>
            <td>
              <button
                type="button"
                class="link"
                title={`Go to it: ${worst.side} foot`}
                onClick={() => {
                  pause();
                  seek(worst.start);
                }}
              >
                {formatCentimetres(found.worst)}
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
      {made ? (
        <Made made={made} />
      ) : (
        <button type="button" class="button" disabled={cleaning.value} onClick={cleanClip}>
          Hold planted feet still
        </button>
      )}
    </div>
  );
}

function Made({ made }: { made: CleanedClip }) {
  const left = made.plants.filter(({ skipReason }) => skipReason !== undefined);
  const rate = clip.value?.rate ?? 1;
  return (
    <>
      <fieldset class="segmented parts">
        <legend class="visually-hidden">What the view shows</legend>
        {views.map(([view, name]) => (
          <button
            key={view}
            type="button"
            aria-pressed={cleanedView.value === view}
            onClick={() => {
              setCleanedView(view);
            }}
          >
            {name}
          </button>
        ))}
      </fieldset>
      <button type="button" class="button" onClick={saveCleaned}>
        Save the cleaned clip <span class="muted">BVH</span>
      </button>
      {(left.length > 0 || made.notices.length > 0) && (
        <ul class="notes">
          {left.slice(0, 5).map(({ side, start, skipReason }) => (
            <li key={`${side} ${start}`} class="note">
              The {side} foot at {(start / rate).toFixed(2)} s is not held: {skipReason}.
            </li>
          ))}
          {left.length > 5 && <li class="note">And {left.length - 5} more are not held.</li>}
          {made.notices
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
