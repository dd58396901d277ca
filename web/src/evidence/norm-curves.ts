import type uPlot from "uplot";
import {
  type FootFrame,
  nearestSample,
  nextSample,
  rankOfNorm,
  valueAtRank,
} from "../model/plants/evidence";
import { formatR, sensitivity } from "../model/plants/sensitivity";
import type { Clustering } from "../model/types";
import { niceCeiling } from "../util/axis-steps";
import { type PlotData, type PlotSpec, paintLine, paintText } from "./plot-data";

/** Formats numbers with up to three significant digits. */
const toThreeDigits = (values: number[]) =>
  values.map((value) => String(Number(value.toPrecision(3))));
/** Formats fractions as percentages. 100 % is left out, since it would be cut off. */
const toPercent = (values: number[]) =>
  values.map((value) => (value < 1 ? `${Math.round(100 * value)} %` : ""));

export const normsSpec: PlotSpec = {
  name: "Sorted norms",
  height: 118,
  x: { size: 20, values: toPercent },
  y: { size: 38, values: toThreeDigits },
};

export const varianceSpec: PlotSpec = {
  name: "Running variance",
  height: 104,
  x: { size: 0, hidden: true, values: toPercent },
  y: { size: 38, values: toThreeDigits },
};

/**
 * True if σ is the norm at the knee, or the nearest limit of the method. Some methods determine σ in
 * another way.
 */
export function isSigmaAtKnee(clustering: Clustering): boolean {
  const { norms, sigma, sigmaIsLimited, knee } = clustering;
  if (sigmaIsLimited) return true;
  return Math.abs(valueAtRank(clustering, norms, knee) - sigma) <= 1e-5 * sigma;
}

/** Returns the plot of the sample norms in ascending order, with σ and the knee. */
export function sortedNormsPlot(clustering: Clustering): PlotData {
  const { norms, sigma } = clustering;
  return {
    ...curvePlot(clustering, norms, niceCeiling(norms.at(-1) ?? 1)),
    paint(plot, theme) {
      if (isSigmaAtKnee(clustering))
        paintLine(plot, "x", fractionOfRank(clustering, clustering.knee), theme.accent, true);
      paintLine(plot, "y", sigma, theme.accent);
      const { left } = plot.bbox;
      const y = plot.valToPos(sigma, "y", true) - 9 * devicePixelRatio;
      paintText(plot, theme, `σ ${sigma.toFixed(3)}`, left + 6 * devicePixelRatio, y, "left");
    },
  };
}

/**
 * Returns the plot of the variance of the sorted norms up to each rank. The knee is the last rank
 * whose variance is within r; the line at r can be dragged.
 */
export function runningVariancePlot(clustering: Clustering, setR: (r: number) => void): PlotData {
  const { r, tolerance, variances } = clustering;
  const hasKnee = isSigmaAtKnee(clustering);
  // Norms grow with the window, so that r is scaled to their size.
  const scale = tolerance / r;
  const dragLine = {
    value: tolerance,
    label: `r ${formatR(r)}`,
    onDrag: (value: number) => setR(value / scale),
  };
  return {
    ...curvePlot(clustering, variances, 1.15 * sensitivity.max * scale),
    ...(hasKnee && { dragLine }),
    paint(plot, theme) {
      if (!hasKnee) return;
      paintLine(plot, "x", fractionOfRank(clustering, clustering.knee), theme.accent, true);
      paintLine(plot, "y", tolerance, theme.accent);
    },
  };
}

/** Returns a rank as a fraction of the greatest rank. */
const fractionOfRank = ({ count }: Clustering, rank: number) => rank / Math.max(count - 1, 1);

/** Returns the plot of values by rank. */
function curvePlot(
  clustering: Clustering,
  values: Float32Array,
  max: number,
): Omit<PlotData, "paint"> {
  const { ranks, count, feet } = clustering;
  const last = Math.max(count - 1, 1);
  const stepSize = Math.max(1, Math.round(count / 256));
  const sampleAtRank = (rank: number) =>
    nearestSample(clustering, valueAtRank(clustering, clustering.norms, rank));
  return {
    data: [ranks.map((rank) => rank / last), values] as unknown as uPlot.AlignedData,
    max: { x: 1, y: max },
    position({ side, frame }) {
      const norm = feet[side].norms[frame] ?? Number.NaN;
      if (Number.isNaN(norm)) return undefined;
      const rank = rankOfNorm(clustering, norm);
      return { x: rank / last, y: Math.min(valueAtRank(clustering, values, rank), max) };
    },
    nearest: (plot, left) => sampleAtRank(Math.round(plot.posToVal(left, "x") * last)),
    move(from: FootFrame, by) {
      if (by === "other-foot")
        return { side: from.side === "left" ? "right" : "left", frame: from.frame };
      if (by === "first" || by === "last") return sampleAtRank(by === "first" ? 0 : last) ?? from;
      return nextSample(clustering, from, by === "next" ? stepSize : -stepSize);
    },
  };
}
