import { cancelOpening } from "../actions/open/open";
import { jobs, opening } from "../store/jobs";
import { clipTitle, openClip } from "../store/session";

/** Titles of the stages of opening a clip. */
const stages = { fetch: "Downloading", read: "Reading", detect: "Detecting plants in" } as const;

/** Returns the opening or the oldest job, in the form in which it is shown. */
function shownJob() {
  const current = opening.value;
  if (current) {
    const title = stages[current.stage];
    return { id: 0, fraction: undefined, ...current, title, stop: cancelOpening };
  }
  const [job] = jobs.value;
  return job && { name: openClip.value && clipTitle.value, fraction: undefined, ...job };
}

/** Shows the progress of the current job. The style sheet delays it by 200 ms. */
export function Progress() {
  const job = shownJob();
  // Jobs of the preview have no name and are not shown.
  if (!job?.name) return null;
  return (
    <div class="progress" role="status" key={job.id}>
      <p>
        {job.title} <strong>{job.name}</strong>
      </p>
      <progress aria-label={`${job.title} ${job.name}`} value={job.fraction} max={1} />
      <button type="button" class="button" onClick={job.stop}>
        Cancel
      </button>
    </div>
  );
}
