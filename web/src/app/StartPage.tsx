import { openSample } from "../actions/open";
import { pickFiles } from "../actions/pick-files";
import { type Sample, samples } from "../actions/samples";
import { maxFileBytes } from "../model/limits";

/** The first impression: the page itself is the drop target, a sample walks behind it. */
export function StartPage() {
  return (
    <section class="empty" aria-label="Open a clip">
      <div class="welcome">
        <p class="sentence">Drop a BVH file to see every foot plant.</p>
        <p class="choices">
          <button type="button" class="button primary large" onClick={pickFiles}>
            Open a file
          </button>
          <span class="muted">
            Nothing leaves your computer. Up to {maxFileBytes / 2 ** 30} GiB.
          </span>
        </p>
      </div>
      {samples.length > 0 && (
        <div class="gallery">
          <h2>Or start with a sample</h2>
          <ul>
            {samples.map((sample) => (
              <li key={sample.name}>
                <Card sample={sample} />
              </li>
            ))}
          </ul>
        </div>
      )}
    </section>
  );
}

function Card({ sample }: { sample: Sample }) {
  return (
    <button type="button" class="card" title={sample.note} onClick={() => openSample(sample.name)}>
      {sample.drawing && (
        // Our own drawings, shipped with the app: no text of any file comes this way.
        <span
          class="drawing"
          aria-hidden="true"
          dangerouslySetInnerHTML={{ __html: sample.drawing }}
        />
      )}
      <span class="card-title">{sample.title}</span>
    </button>
  );
}
