/** Between the state of the page and what links and shared pages say of it. */

import { batch } from "@preact/signals";
import { readShowing, type Showing, timeOf } from "../lib/showing";
import { sightNow } from "../viewer/staged";
import type { DetectOptions, Overrides, SegmentOptions } from "../worker/types";
import { engine } from "./engine";
import { remark } from "./remarks";
import {
  cameraView,
  clip,
  follow,
  frame,
  options,
  overrides,
  segmentOptions,
  source,
} from "./state";

/** What is asked for before a person asks for anything. */
const usual = { detect: options.peek(), segment: segmentOptions.peek() };

/** How the clip is on show now; only what is not as usual. */
export function showingNow(): Showing {
  const { method, r, w, height, speed } = options.value;
  const { method: segment, dims, residual, template, published } = segmentOptions.value;
  const { rate, up, metresPerUnit: unit, roles: joints } = overrides.value;
  return defined({
    t: frame.value ? timeOf(frame.value, clip.value?.rate ?? 1) : undefined,
    method: unlike(method, usual.detect.method),
    r: unlike(r, usual.detect.r),
    w: unlike(w, usual.detect.w),
    height,
    speed,
    segment: unlike(segment, usual.segment.method),
    dims,
    residual: residual === "ratio" ? residual : undefined,
    template: unlike(template, "mean"),
    published: published ? "yes" : undefined,
    rate,
    up,
    unit,
    joints: joints && Object.keys(joints).length ? joints : undefined,
    lenient: source.value?.lenient ? "yes" : undefined,
    follow: follow.value ? undefined : "off",
    ...sightNow(cameraView.value),
  });
}

/** Asks for what is said, and for the usual where nothing is. */
export function ask(showing: Showing) {
  const { method, r, w, height, speed } = showing;
  const { segment, dims, residual, template, published } = showing;
  batch(() => {
    options.value = {
      ...usual.detect,
      ...defined<Partial<DetectOptions>>({ method, r, w, height, speed }),
    };
    segmentOptions.value = {
      ...usual.segment,
      ...defined<Partial<SegmentOptions>>({
        method: segment,
        dims,
        residual,
        template,
        published: published && true,
      }),
    };
    follow.value = showing.follow !== "off";
  });
}

/** How the file is to be read. */
export function overridesOf({ rate, up, unit, joints }: Showing): Overrides {
  return defined<Overrides>({ rate, up, metresPerUnit: unit, roles: joints });
}

/** Understands a text as far as it can, and says what was left out. */
export async function understand(text: string): Promise<Showing> {
  // A worker that does not start says so when the clip is opened.
  const names = (list: Promise<{ name: string }[]>) =>
    list.then((methods) => methods.map(({ name }) => name)).catch(() => []);
  const [detect, segment] = text
    ? await Promise.all([names(engine.methods()), names(engine.segmentMethods())])
    : [[], []];
  const { showing, broken } = readShowing(text, { detect, segment });
  if (broken.length) {
    const said = broken.map((part) => `“${part.slice(0, 60)}”`).join(", ");
    remark({ text: `The link says ${said}, which is not known here: that was left out.` });
  }
  return showing;
}

const unlike = <T>(value: T, other: T) => (value === other ? undefined : value);

/** Without what is undefined. */
function defined<T extends object>(record: { [K in keyof T]?: T[K] | undefined }): T {
  return Object.fromEntries(
    Object.entries(record).filter(([, value]) => value !== undefined),
  ) as unknown as T;
}
