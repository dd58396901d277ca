import type uPlot from "uplot";
import {
  type FootFrame,
  nearestSample,
  nextSample,
  rankOfNorm,
  valueAtRank,
} from "../model/evidence";
import { sensitivity } from "../model/sensitivity";
import type { Clustering } from "../model/types";
import { niceCeiling } from "../util/axis-steps";
import { type PlotData, type PlotSpec, paintLine, paintText } from "./plot-data";

const plain = (values: number[]) => values.map((value) => String(Number(value.toPrecision(3))));
/** The last one would stick out. */
const percent = (values: number[]) =>
  values.map((value) => (value < 1 ? `${Math.round(100 * value)} %` : ""));

export const normsFrame: PlotSpec = {
  name: "Sorted norms",
  height: 118,
  x: { size: 20, values: percent },
  y: { size: 38, values: plain },
};

export const varianceFrame: PlotSpec = {
  name: "Running variance",
  height: 104,
  x: { size: 0, hidden: true, values: percent },
  y: { size: 38, values: plain },
};

/** Whether σ is the norm at the knee: some methods have one of their own. */
export function isAtKnee({ sigma, knee, ...evidence }: Clustering): boolean {
  const at = valueAtRank({ sigma, knee, ...evidence }, evidence.norms, knee);
  return Math.abs(at - sigma) <= 1e-5 * sigma;
}

/** The norms of all samples in ascending order: σ is the one at the knee. */
export function sortedNorms(evidence: Clustering): PlotData {
  const { norms, sigma } = evidence;
  return {
    ...curve(evidence, norms, niceCeiling(norms.at(-1) ?? 1)),
    paint(plot, ink) {
      if (isAtKnee(evidence))
        paintLine(plot, "x", shareOf(evidence, evidence.knee), ink.accent, true);
      paintLine(plot, "y", sigma, ink.accent);
      const { left } = plot.bbox;
      const y = plot.valToPos(sigma, "y", true) - 9 * devicePixelRatio;
      paintText(plot, ink, `σ ${sigma.toFixed(3)}`, left + 6 * devicePixelRatio, y, "left");
    },
  };
}

/** The variance of the norms up to each one: the knee is the last within r, which can be dragged. */
export function runningVariance(evidence: Clustering, setR: (to: number) => void): PlotData {
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
      paintLine(plot, "x", shareOf(evidence, evidence.knee), ink.accent, true);
      paintLine(plot, "y", tolerance, ink.accent);
    },
  };
}

const shareOf = ({ count }: Clustering, rank: number) => rank / Math.max(count - 1, 1);

function curve(evidence: Clustering, values: Float32Array, top: number): Omit<PlotData, "paint"> {
  const { ranks, count, feet } = evidence;
  const last = Math.max(count - 1, 1);
  const jump = Math.max(1, Math.round(count / 256));
  const atRank = (rank: number) =>
    nearestSample(evidence, valueAtRank(evidence, evidence.norms, rank));
  return {
    data: [ranks.map((rank) => rank / last), values] as unknown as uPlot.AlignedData,
    top: { x: 1, y: top },
    place({ side, frame }) {
      const norm = feet[side].norms[frame] ?? Number.NaN;
      if (Number.isNaN(norm)) return undefined;
      const rank = rankOfNorm(evidence, norm);
      return { x: rank / last, y: Math.min(valueAtRank(evidence, values, rank), top) };
    },
    nearest: (plot, left) => atRank(Math.round(plot.posToVal(left, "x") * last)),
    step(from: FootFrame, by) {
      if (by === "other")
        return { side: from.side === "left" ? "right" : "left", frame: from.frame };
      if (by === "first" || by === "last") return atRank(by === "first" ? 0 : last) ?? from;
      return nextSample(evidence, from, by === "on" ? jump : -jump);
    },
  };
}
