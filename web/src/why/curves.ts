import type uPlot from "uplot";
import { nextSample, rankOf, type Sample, sampleOf, valueAt } from "../lib/evidence";
import { sensitivity } from "../lib/logSlider";
import { niceTop } from "../lib/ruler";
import type { Evidence } from "../worker/types";
import { across, type Frame, type Picture, word } from "./picture";

const plain = (values: number[]) => values.map((value) => String(Number(value.toPrecision(3))));
/** The last one would stick out. */
const percent = (values: number[]) =>
  values.map((value) => (value < 1 ? `${Math.round(100 * value)} %` : ""));

export const normsFrame: Frame = {
  name: "Sorted norms",
  height: 118,
  x: { size: 20, values: percent },
  y: { size: 38, values: plain },
};

export const varianceFrame: Frame = {
  name: "Running variance",
  height: 104,
  x: { size: 0, hidden: true, values: percent },
  y: { size: 38, values: plain },
};

/** Whether σ is the norm at the knee: some methods have one of their own. */
export function isAtKnee({ sigma, knee, ...evidence }: Evidence): boolean {
  const at = valueAt({ sigma, knee, ...evidence }, evidence.norms, knee);
  return Math.abs(at - sigma) <= 1e-5 * sigma;
}

/** The norms of all samples in ascending order: σ is the one at the knee. */
export function sortedNorms(evidence: Evidence): Picture {
  const { norms, sigma } = evidence;
  return {
    ...curve(evidence, norms, niceTop(norms.at(-1) ?? 1)),
    paint(plot, ink) {
      if (isAtKnee(evidence)) across(plot, "x", shareOf(evidence, evidence.knee), ink.why, true);
      across(plot, "y", sigma, ink.why);
      const { left } = plot.bbox;
      const y = plot.valToPos(sigma, "y", true) - 9 * devicePixelRatio;
      word(plot, ink, `σ ${sigma.toFixed(3)}`, left + 6 * devicePixelRatio, y, "left");
    },
  };
}

/** The variance of the norms up to each one: the knee is the last within r, which can be dragged. */
export function runningVariance(evidence: Evidence, setR: (to: number) => void): Picture {
  const { r, tolerance, variances } = evidence;
  const atKnee = isAtKnee(evidence);
  // A wider window has longer norms: what is drawn is r in their measure.
  const measure = tolerance / r;
  const level = {
    at: tolerance,
    text: `r ${r.toFixed(4)}`,
    set: (to: number) => setR(to / measure),
  };
  return {
    ...curve(evidence, variances, 1.15 * sensitivity.max * measure),
    ...(atKnee && { level }),
    paint(plot, ink) {
      if (!atKnee) return;
      across(plot, "x", shareOf(evidence, evidence.knee), ink.why, true);
      across(plot, "y", tolerance, ink.why);
    },
  };
}

const shareOf = ({ count }: Evidence, rank: number) => rank / Math.max(count - 1, 1);

function curve(evidence: Evidence, values: Float32Array, top: number): Omit<Picture, "paint"> {
  const { ranks, count, feet } = evidence;
  const last = Math.max(count - 1, 1);
  const jump = Math.max(1, Math.round(count / 256));
  const atRank = (rank: number) => sampleOf(evidence, valueAt(evidence, evidence.norms, rank));
  return {
    data: [ranks.map((rank) => rank / last), values] as unknown as uPlot.AlignedData,
    top: { x: 1, y: top },
    place({ side, frame }) {
      const norm = feet[side].norms[frame] ?? Number.NaN;
      if (Number.isNaN(norm)) return undefined;
      const rank = rankOf(evidence, norm);
      return { x: rank / last, y: Math.min(valueAt(evidence, values, rank), top) };
    },
    nearest: (plot, left) => atRank(Math.round(plot.posToVal(left, "x") * last)),
    step(from: Sample, by) {
      if (by === "other")
        return { side: from.side === "left" ? "right" : "left", frame: from.frame };
      if (by === "first" || by === "last") return atRank(by === "first" ? 0 : last) ?? from;
      return nextSample(evidence, from, by === "on" ? jump : -jump);
    },
  };
}
