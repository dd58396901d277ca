import { expect, test } from "vitest";
import { squareTicks } from "./sqrt-ticks";

test("ticks are round, ascending and apart, from 0 to the top", () => {
  expect(squareTicks(4)).toEqual([0, 0.2, 1, 2, 4]);
  for (const top of [0.015, 0.2, 0.6, 1, 8, 25, 300]) {
    const ticks = squareTicks(top);
    expect([ticks[0], ticks.at(-1)]).toEqual([0, top]);
    expect(ticks.length).toBeGreaterThanOrEqual(4);
    const places = ticks.map((tick) => Math.sqrt(tick / top));
    places.slice(1).forEach((place, i) => {
      expect(place - (places[i] ?? 0)).toBeGreaterThanOrEqual(0.149);
    });
  }
});
