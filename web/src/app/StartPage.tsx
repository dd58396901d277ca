import { openSample } from "../actions/open/open";
import { pickFiles } from "../actions/open/pick-files";
import { type Sample, samples } from "../actions/open/samples";
import { maxFileBytes } from "../model/limits";
import { ThirdPartyLink } from "./ThirdParty";

/** The page without a clip. A sample plays in the background; files can be dropped anywhere. */
export function StartPage() {
  return (
    <section class="start-page" aria-label="Open a clip">
      <div class="introduction">
        <p class="headline">
          <span class="with-pointer">Drop</span>
          <span class="with-touch">Open</span> a BVH file to see every foot plant.
        </p>
        <p class="start-actions">
          <button type="button" class="button primary large" onClick={pickFiles}>
            Open a file
          </button>
          <span class="muted">
            Files stay on your computer. Up to {maxFileBytes / 2 ** 30} GiB.
          </span>
        </p>
      </div>
      <div class="start-end">
        {samples.length > 0 && (
          <div class="gallery">
            <h2>Or start with a sample</h2>
            <ul>
              {samples.map((sample) => (
                <li key={sample.name}>
                  <SampleCard sample={sample} />
                </li>
              ))}
            </ul>
          </div>
        )}
        <ThirdPartyLink />
      </div>
    </section>
  );
}

function SampleCard({ sample }: { sample: Sample }) {
  return (
    <button type="button" class="card" title={sample.note} onClick={() => openSample(sample.name)}>
      {sample.drawing && (
        // Drawings are part of the app; they contain no text of users' files.
        <span
          class="card-drawing"
          aria-hidden="true"
          dangerouslySetInnerHTML={{ __html: sample.drawing }}
        />
      )}
      <span class="card-title">{sample.title}</span>
    </button>
  );
}
