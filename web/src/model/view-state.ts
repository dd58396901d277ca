/** How a clip is on show, as links and shared pages say it: `t=1.25&method=paper&r=0.002`. */

export type CameraView = "perspective" | "front" | "side" | "top";

export type Point = readonly [x: number, y: number, z: number];

/** Where the camera is and what it looks at, in metres. */
export interface CameraPose {
  eye: Point;
  at: Point;
}

/** What is absent is as usual. */
export interface ViewState extends Partial<CameraPose> {
  /** The moment in seconds. */
  t?: number;
  view?: "front" | "side" | "top";
  /** Whether the camera travels along. */
  follow?: "off";
  method?: string;
  r?: number;
  w?: number;
  height?: number;
  speed?: number;
  /** The method of segmentation. */
  segment?: string;
  dims?: number;
  residual?: "ratio";
  template?: "mean" | "tpose" | `${number}`;
  published?: "yes";
  rate?: number;
  up?: "x" | "-x" | "y" | "-y" | "z" | "-z";
  /** Metres per unit of the file. */
  unit?: number;
  /** Joints in place of those found, by their role; −1 is none. */
  joints?: Record<string, number>;
  /** Values that are no number were held from the frame before. */
  lenient?: "yes";
}

type Key = keyof ViewState;

/** What a text says, if it says anything. */
type Reader<T> = (text: string) => T | undefined;

/** The names that methods have at present. */
export interface MethodNames {
  detect: readonly string[];
  segment: readonly string[];
}

const readers = ({ detect, segment }: MethodNames): { [K in Key]-?: Reader<ViewState[K]> } => ({
  t: number(0, 1e6),
  method: oneOf(...detect),
  r: number(1e-9, 1),
  w: whole(0, 100),
  height: number(0, 10),
  speed: number(0, 100),
  segment: oneOf(...segment),
  dims: whole(1, 1000),
  residual: oneOf("ratio"),
  template: (text) =>
    oneOf("mean", "tpose")(text) ??
    ((`${whole(0, 1e9)(text) ?? ""}` || undefined) as ViewState["template"]),
  published: oneOf("yes"),
  rate: number(1, 1000),
  up: oneOf("x", "-x", "y", "-y", "z", "-z"),
  unit: number(1e-9, 1e9),
  joints: joints,
  lenient: oneOf("yes"),
  view: oneOf("front", "side", "top"),
  follow: oneOf("off"),
  eye: point,
  at: point,
});

/** Reads it; what is not understood comes back beside it, to be told. */
export function parseViewState(
  text: string,
  methods: MethodNames,
): { view: ViewState; rejected: string[] } {
  const known = new Map<string, Reader<unknown>>(Object.entries(readers(methods)));
  const view: Record<string, unknown> = {};
  const rejected: string[] = [];
  for (const [key, value] of new URLSearchParams(text)) {
    const read = known.get(key)?.(value);
    if (read === undefined) rejected.push(`${key}=${value}`);
    else view[key] = read;
  }
  // A camera that looks from nowhere or at nothing is none.
  if (!view.eye !== !view.at) {
    rejected.push(view.eye ? "eye without at" : "at without eye");
    delete view.eye;
    delete view.at;
  }
  return { view, rejected };
}

/** Writes it so that it can be read by a person too. */
export function formatViewState(view: ViewState): string {
  const keys = Object.keys(readers({ detect: [], segment: [] })) as Key[];
  return keys
    .filter((key) => view[key] !== undefined)
    .map((key) => `${key}=${plain(textOf(view[key]))}`)
    .join("&");
}

function textOf(value: ViewState[Key]): string {
  if (Array.isArray(value)) return value.map((n) => Number(n.toFixed(3))).join(",");
  if (typeof value !== "object") return String(value);
  return Object.entries(value)
    .map((pair) => pair.join(":"))
    .join(",");
}

/** Escaped, but for what needs none behind a `#`. */
const plain = (text: string) => encodeURIComponent(text).replace(/%2C/g, ",").replace(/%3A/g, ":");

/** A moment with no more digits than it takes to tell its frame from others. */
export function shortestTime(frame: number, rate: number): number {
  return Number((frame / rate).toFixed(Math.max(0, Math.floor(Math.log10(rate)) + 1)));
}

function number(least: number, most: number): Reader<number> {
  return (text) => {
    const value = /^-?[\d.]+(e-?\d+)?$/i.test(text) ? Number(text) : Number.NaN;
    return value >= least && value <= most ? value : undefined;
  };
}

function whole(least: number, most: number): Reader<number> {
  return (text) => (/^-?\d+$/.test(text) ? number(least, most)(text) : undefined);
}

function oneOf<T extends string>(...words: readonly T[]): Reader<T> {
  return (text) => words.find((word) => word === text);
}

function point(text: string): Point | undefined {
  const [x, y, z, ...more] = text.split(",").map(number(-1e6, 1e6));
  if (x === undefined || y === undefined || z === undefined || more.length) return undefined;
  return [x, y, z];
}

function joints(text: string): Record<string, number> | undefined {
  const pairs = text.split(",").map((pair) => pair.match(/^([a-z_]+):(-?\d+)$/));
  if (pairs.some((pair) => !pair)) return undefined;
  return Object.fromEntries(pairs.map((pair) => [pair?.[1], Number(pair?.[2])]));
}
