import { expect, test } from "vitest";
import { sqrtTicks } from "./sqrt-ticks";

test("returns round, ascending, separated ticks from 0 to the maximum", () => {
  expect(sqrtTicks(4)).toEqual([0, 0.2, 1, 2, 4]);
  for (const max of [0.015, 0.2, 0.6, 1, 8, 25, 300]) {
    const ticks = sqrtTicks(max);
    expect([ticks[0], ticks.at(-1)]).toEqual([0, max]);
    expect(ticks.length).toBeGreaterThanOrEqual(4);
    const positions = ticks.map((tick) => Math.sqrt(tick / max));
    positions.slice(1).forEach((position, i) => {
      expect(position - (positions[i] ?? 0)).toBeGreaterThanOrEqual(0.149);
    });
  }
});
