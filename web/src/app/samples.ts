// The picture stands for the sample that moves behind the empty page, until it does.
import "../styles/poster.css";

/** The clips shipped with the app: generated motion, so free of anyone's rights. */
export interface Sample {
  name: string;
  title: string;
  note?: string;
  url: string;
  /** Where its labels are, as they were generated with the motion. */
  truth?: string;
  /** A line drawing as SVG text, in currentColor. */
  drawing?: string;
}

interface Entry {
  name: string;
  title: string;
  note?: string;
}

const urls = import.meta.glob<string>("../../../samples/*.bvh", {
  query: "?url",
  import: "default",
  eager: true,
});
const drawings = import.meta.glob<string>("../../../samples/*.svg", {
  query: "?raw",
  import: "default",
  eager: true,
});
const truths = import.meta.glob<string>(
  ["../../../samples/*.json", "!../../../samples/index.json"],
  {
    query: "?url",
    import: "default",
    eager: true,
  },
);
const index = import.meta.glob<Entry[]>("../../../samples/index.json", {
  import: "default",
  eager: true,
});

const nameOf = (path: string) => path.replace(/^.*\/(.*)\.\w+$/, "$1");

function titleOf(name: string) {
  const words = name.replace(/[-_]+/g, " ");
  return words.charAt(0).toUpperCase() + words.slice(1);
}

function collect(): Sample[] {
  const byName = new Map(Object.entries(urls).map(([path, url]) => [nameOf(path), url]));
  const truth = new Map(Object.entries(truths).map(([path, url]) => [nameOf(path), url]));
  const art = new Map(Object.entries(drawings).map(([path, svg]) => [nameOf(path), svg]));
  const listed = Object.values(index).flat();
  const entries = listed.length
    ? listed
    : [...byName.keys()].map((name) => ({ name, title: titleOf(name) }));
  return entries.flatMap((entry: Entry) => {
    const url = byName.get(entry.name);
    if (!url) return [];
    const drawing = art.get(entry.name);
    const sample: Sample = { name: entry.name, title: entry.title, url };
    if (entry.note) sample.note = entry.note;
    if (drawing) sample.drawing = drawing;
    const labels = truth.get(entry.name);
    if (labels) sample.truth = labels;
    return [sample];
  });
}

export const samples: readonly Sample[] = collect();

/** The sample that moves behind the empty page: a long one, so that it seldom starts again. */
export const heroSample = samples.find((s) => s.name === "limp-to-run") ?? samples[0];
