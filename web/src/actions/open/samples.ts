// A still picture of the preview, shown until the preview plays.
import "../../styles/poster.css";

/** A clip shipped with the app. All are generated motion. */
export interface Sample {
  name: string;
  title: string;
  note?: string;
  url: string;
  /** URL of the labels that were generated with the motion. */
  truthUrl?: string;
  /** Line drawing as SVG text, in currentColor. */
  drawing?: string;
}

interface Entry {
  name: string;
  title: string;
  note?: string;
}

const urls = import.meta.glob<string>("../../../../samples/*.bvh", {
  query: "?url",
  import: "default",
  eager: true,
});
const drawings = import.meta.glob<string>("../../../../samples/*.svg", {
  query: "?raw",
  import: "default",
  eager: true,
});
const truths = import.meta.glob<string>(
  ["../../../../samples/*.json", "!../../../../samples/index.json"],
  {
    query: "?url",
    import: "default",
    eager: true,
  },
);
const index = import.meta.glob<Entry[]>("../../../../samples/index.json", {
  import: "default",
  eager: true,
});

const baseNameOf = (path: string) => path.replace(/^.*\/(.*)\.\w+$/, "$1");

function defaultTitle(name: string) {
  const words = name.replace(/[-_]+/g, " ");
  return words.charAt(0).toUpperCase() + words.slice(1);
}

function byBaseName(files: Record<string, string>): Map<string, string> {
  return new Map(Object.entries(files).map(([path, value]) => [baseNameOf(path), value]));
}

function listSamples(): Sample[] {
  const [urlOf, truthOf, drawingOf] = [urls, truths, drawings].map(byBaseName) as [
    Map<string, string>,
    Map<string, string>,
    Map<string, string>,
  ];
  const listed = Object.values(index).flat();
  const entries: Entry[] = listed.length
    ? listed
    : [...urlOf.keys()].map((name) => ({ name, title: defaultTitle(name) }));
  return entries.flatMap((entry) => {
    const url = urlOf.get(entry.name);
    if (!url) return [];
    const sample: Sample = { name: entry.name, title: entry.title, url };
    const [truthUrl, drawing] = [truthOf.get(entry.name), drawingOf.get(entry.name)];
    if (entry.note) sample.note = entry.note;
    if (drawing) sample.drawing = drawing;
    if (truthUrl) sample.truthUrl = truthUrl;
    return [sample];
  });
}

export const samples: readonly Sample[] = listSamples();

/** The sample on the start page: a long clip, so that it rarely repeats. */
export const previewSample = samples.find(({ name }) => name === "limp-to-run") ?? samples[0];
