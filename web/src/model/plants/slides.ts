/** Returns mean and maximum of the slides of plants, in metres; undefined without plants. */
export function summarizeSlides(
  slides: readonly number[],
): { mean: number; worst: number } | undefined {
  if (!slides.length) return undefined;
  const sum = slides.reduce((total, slide) => total + slide, 0);
  return { mean: sum / slides.length, worst: Math.max(...slides) };
}

/** Formats a length in centimetres: `1.2 cm`, `25 cm`. */
export function formatCentimetres(metres: number): string {
  const cm = 100 * metres;
  return `${cm.toFixed(cm < 10 ? 1 : 0)} cm`;
}
