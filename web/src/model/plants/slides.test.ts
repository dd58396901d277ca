import { expect, test } from "vitest";
import { formatCentimetres, summarizeSlides } from "./slides";

test("summarizes and formats slides", () => {
  expect(summarizeSlides([])).toBeUndefined();
  expect(summarizeSlides([0.01, 0.03])).toEqual({ mean: 0.02, worst: 0.03 });
  expect([0.0004, 0.0123, 0.25].map(formatCentimetres)).toEqual(["0.0 cm", "1.2 cm", "25 cm"]);
});
