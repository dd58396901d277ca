/** The view state in links and shared pages, as text: `t=1.25&method=paper&r=0.002`. */

export type CameraView = "perspective" | "front" | "side" | "top";

export type Point = readonly [x: number, y: number, z: number];

/** Position and target of the camera, in metres. */
export interface CameraPose {
  eye: Point;
  at: Point;
}

/** View and settings; absent fields have their default values. */
export interface ViewState extends Partial<CameraPose> {
  /** Time, in seconds. */
  t?: number;
  view?: "front" | "side" | "top";
  /** Absent if the camera follows the character. */
  follow?: "off";
  method?: string;
  r?: number;
  w?: number;
  height?: number;
  speed?: number;
  /** Segmentation method. */
  segment?: string;
  dims?: number;
  residual?: "ratio";
  template?: "mean" | "tpose" | `${number}`;
  published?: "yes";
  rate?: number;
  up?: "x" | "-x" | "y" | "-y" | "z" | "-z";
  /** Metres per unit of the file. */
  unit?: number;
  /** Joint index by role, overriding detected roles; −1 is none. */
  joints?: Record<string, number>;
  /** Set if values that are not numbers are replaced by those of the previous frame. */
  lenient?: "yes";
}

type Key = keyof ViewState;

/** Parses a value; undefined if it is invalid. */
type Parser<T> = (text: string) => T | undefined;

/** Valid names of methods. */
export interface MethodNames {
  detect: readonly string[];
  segment: readonly string[];
}

const parsersFor = ({ detect, segment }: MethodNames): { [K in Key]-?: Parser<ViewState[K]> } => ({
  t: number(0, 1e6),
  method: oneOf(...detect),
  r: number(1e-9, 1),
  w: integer(0, 100),
  height: number(0, 10),
  speed: number(0, 100),
  segment: oneOf(...segment),
  dims: integer(1, 1000),
  residual: oneOf("ratio"),
  template: (text) =>
    oneOf("mean", "tpose")(text) ??
    ((`${integer(0, 1e9)(text) ?? ""}` || undefined) as ViewState["template"]),
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

/** Parses a view state. `rejected` lists the parts that are unknown or invalid. */
export function parseViewState(
  text: string,
  methods: MethodNames,
): { view: ViewState; rejected: string[] } {
  const parsers = new Map<string, Parser<unknown>>(Object.entries(parsersFor(methods)));
  const view: Record<string, unknown> = {};
  const rejected: string[] = [];
  for (const [key, value] of new URLSearchParams(text)) {
    const parsed = parsers.get(key)?.(value);
    if (parsed === undefined) rejected.push(`${key}=${value}`);
    else view[key] = parsed;
  }
  // A camera pose requires both points.
  if (!view.eye !== !view.at) {
    rejected.push(view.eye ? "eye without at" : "at without eye");
    delete view.eye;
    delete view.at;
  }
  return { view, rejected };
}

/** Formats a view state readably. */
export function formatViewState(view: ViewState): string {
  const keys = Object.keys(parsersFor({ detect: [], segment: [] })) as Key[];
  return keys
    .filter((key) => view[key] !== undefined)
    .map((key) => `${key}=${escapeValue(textOf(view[key]))}`)
    .join("&");
}

function textOf(value: ViewState[Key]): string {
  if (Array.isArray(value)) return value.map((n) => Number(n.toFixed(3))).join(",");
  if (typeof value !== "object") return String(value);
  return Object.entries(value)
    .map((pair) => pair.join(":"))
    .join(",");
}

/** Percent-encodes a value, except for characters that are safe after `#`. */
const escapeValue = (text: string) =>
  encodeURIComponent(text).replace(/%2C/g, ",").replace(/%3A/g, ":");

/** Returns the time of a frame in seconds, with as few decimals as identify the frame. */
export function shortestTime(frame: number, rate: number): number {
  return Number((frame / rate).toFixed(Math.max(0, Math.floor(Math.log10(rate)) + 1)));
}

function number(min: number, max: number): Parser<number> {
  return (text) => {
    const value = /^-?[\d.]+(e-?\d+)?$/i.test(text) ? Number(text) : Number.NaN;
    return value >= min && value <= max ? value : undefined;
  };
}

function integer(min: number, max: number): Parser<number> {
  return (text) => (/^-?\d+$/.test(text) ? number(min, max)(text) : undefined);
}

function oneOf<T extends string>(...words: readonly T[]): Parser<T> {
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
