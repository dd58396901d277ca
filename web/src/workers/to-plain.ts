/** Copies objects of the wasm module to plain objects that can be sent to the page. */

import { uncertainRanges } from "../model/plants/plants";
import type {
  Annotation,
  Clip,
  Detection,
  DetectOptions,
  Labels,
  Part,
  Segmentation,
  SegmentOptions,
  Side,
  Track,
  Tracks,
} from "../model/types";
import { summarizeCurve } from "../util/min-max-pyramid";
import type {
  WasmAnnotation,
  WasmClip,
  WasmDetection,
  WasmSegmentation,
} from "../wasm/plantigrade";

export function clipToPlain(clip: WasmClip, name: string): Clip {
  return { name, ...clip.info(), positions: clip.positions() };
}

export function detectionToPlain(detection: WasmDetection, options: DetectOptions): Detection {
  const names = detection.parts() as Part[];
  const noise = detection.noise();
  const parts = Object.fromEntries(names.map((part) => [part, tracksToPlain(detection, part)]));
  return {
    options,
    parts: parts as Detection["parts"],
    floor: detection.floor,
    ground: detection.ground(),
    ...(noise && { noise }),
    notices: detection.notices(),
  };
}

function tracksToPlain(detection: WasmDetection, part: Part): Tracks {
  // Summaries are computed here so that they do not delay a frame of the page.
  const track = (side: Side): Track => {
    const [height, speed] = [detection.height(part, side), detection.speed(part, side)];
    const summaries = { height: summarizeCurve(height), speed: summarizeCurve(speed) };
    return { ...labelsToPlain(detection, part, side), height, speed, summaries };
  };
  return { left: track("left"), right: track("right") };
}

export function labelsToPlain(detection: WasmDetection, part: Part, side: Side): Labels {
  const intervals = detection.intervals(part, side);
  const confidence = detection.confidence(part, side);
  return {
    planted: detection.planted(part, side),
    confidence,
    intervals,
    instants: detection.instants(part, side),
    edited: detection.edited(part, side),
    uncertain: uncertainRanges(intervals, confidence),
  };
}

export function segmentationToPlain(
  segmentation: WasmSegmentation,
  options: SegmentOptions,
): Segmentation {
  return {
    options,
    segments: segmentation.segments(),
    transitions: segmentation.transitions(),
    motifs: segmentation.motifs(),
    classes: segmentation.motifClasses(),
    curve: {
      title: segmentation.curveTitle(),
      frames: segmentation.curveFrames(),
      values: segmentation.curveValues(),
      threshold: segmentation.curveThreshold(),
      extrema: segmentation.extrema(),
    },
    notices: segmentation.notices(),
  };
}

export function annotationToPlain(annotation: WasmAnnotation, name: string): Annotation {
  const sides = (part: Part) => ({
    left: annotation.planted(part, "left"),
    right: annotation.planted(part, "right"),
  });
  const names = annotation.parts() as Part[];
  return { name, parts: Object.fromEntries(names.map((part) => [part, sides(part)])) };
}

/** Returns the buffers of all typed arrays in an object, to be transferred instead of copied. */
export function transferables(object: object): Transferable[] {
  return Object.values(object).flatMap((value) => {
    if (ArrayBuffer.isView(value)) return [value.buffer as ArrayBuffer];
    return value && typeof value === "object" ? transferables(value) : [];
  });
}
