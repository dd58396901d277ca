/** Converts between the state of the page and the view state in links and shared pages. */

import { batch } from "@preact/signals";
import { engine } from "../../engine";
import type { DetectSettings } from "../../model/sources/host";
import { parseViewState, shortestTime, type ViewState } from "../../model/stored/view-state";
import type { DetectOptions, Overrides, SegmentOptions } from "../../model/types";
import { frame } from "../../store/playback";
import { clip, overrides, source } from "../../store/session";
import { detectOptions, segmentOptions } from "../../store/settings";
import { showToast } from "../../store/toasts";
import { cameraView, followCamera, stageHandle } from "../../store/view";

/** Settings before the user changes any. */
const defaults = { detect: detectOptions.peek(), segment: segmentOptions.peek() };

/** Returns the view state of the page without default values. */
export function currentViewState(): ViewState {
  const { method: segment, dims, residual, template, published } = segmentOptions.value;
  return withoutUndefined({
    t: frame.value ? shortestTime(frame.value, clip.value?.rate ?? 1) : undefined,
    ...currentDetectSettings(),
    segment: unlessEqual(segment, defaults.segment.method),
    dims,
    residual: residual === "ratio" ? residual : undefined,
    template: unlessEqual(template, "mean"),
    published: published ? "yes" : undefined,
    lenient: source.value?.lenient ? "yes" : undefined,
    follow: followCamera.value ? undefined : "off",
    ...currentCamera(),
  });
}

/** Returns the settings that determine the labels of the method, without default values. */
export function currentDetectSettings(): DetectSettings {
  const { method, r, w, height, speed } = detectOptions.value;
  const { rate, up, metresPerUnit: unit, roles: joints } = overrides.value;
  return withoutUndefined({
    method: unlessEqual(method, defaults.detect.method),
    r: unlessEqual(r, defaults.detect.r),
    w: unlessEqual(w, defaults.detect.w),
    height,
    speed,
    rate,
    up,
    unit,
    joints: joints && Object.keys(joints).length ? joints : undefined,
  });
}

/** Returns the view of the camera, and its pose if that is not the default one. */
function currentCamera(): Pick<ViewState, "view" | "eye" | "at"> {
  const view = cameraView.value;
  const named = view === "perspective" ? {} : { view };
  return { ...named, ...stageHandle.peek()?.cameraPose(view) };
}

/** Applies the settings of a view state; absent ones get their default values. */
export function applyViewState(view: ViewState) {
  const { segment, dims, residual, template, published } = view;
  batch(() => {
    detectOptions.value = detectOptionsOf(view);
    segmentOptions.value = {
      ...defaults.segment,
      ...withoutUndefined<Partial<SegmentOptions>>({
        method: segment,
        dims,
        residual,
        template,
        published: published && true,
      }),
    };
    followCamera.value = view.follow !== "off";
  });
}

/** Returns the options of a detection; absent ones have their default values. */
export function detectOptionsOf({ method, r, w, height, speed }: DetectSettings): DetectOptions {
  return {
    ...defaults.detect,
    ...withoutUndefined<Partial<DetectOptions>>({ method, r, w, height, speed }),
  };
}

/** Returns the overrides of a view state. */
export function overridesOf({ rate, up, unit, joints }: ViewState): Overrides {
  return withoutUndefined<Overrides>({ rate, up, metresPerUnit: unit, roles: joints });
}

/** Parses the view state of a link, and reports the parts that are invalid. */
export async function parseLinkView(text: string): Promise<ViewState> {
  // A worker that does not start is reported when the clip is opened.
  const names = (list: Promise<{ name: string }[]>) =>
    list.then((methods) => methods.map(({ name }) => name)).catch(() => []);
  const [detect, segment] = text
    ? await Promise.all([names(engine.methods()), names(engine.segmentMethods())])
    : [[], []];
  const { view, rejected } = parseViewState(text, { detect, segment });
  if (rejected.length) {
    const list = rejected.map((part) => `“${part.slice(0, 60)}”`).join(", ");
    showToast({ text: `The link contains ${list}, which is invalid and was ignored.` });
  }
  return view;
}

const unlessEqual = <T>(value: T, other: T) => (value === other ? undefined : value);

function withoutUndefined<T extends object>(object: { [K in keyof T]?: T[K] | undefined }): T {
  return Object.fromEntries(
    Object.entries(object).filter(([, value]) => value !== undefined),
  ) as unknown as T;
}
