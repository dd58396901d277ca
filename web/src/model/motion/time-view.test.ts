import { describe, expect, it } from "vitest";
import { clampView, moveEdge, pan, scrollToFrame, toFrame, toX, zoomAt } from "./time-view";

const view = { start: 100, end: 300 };

it("zooms around a frame", () => {
  const x = toX(view, 150, 800);
  const closer = zoomAt(view, 150, 0.5, 1000);
  expect(closer.end - closer.start).toBe(100);
  expect(toX(closer, 150, 800)).toBeCloseTo(x);
});

it("stays inside the clip", () => {
  expect(zoomAt(view, 150, 100, 1000)).toEqual({ start: 0, end: 1000 });
  expect(pan(view, -500, 1000)).toEqual({ start: 0, end: 200 });
  expect(pan(view, 5000, 1000)).toEqual({ start: 800, end: 1000 });
});

it("shows at least eight frames, or all of a shorter clip", () => {
  const near = zoomAt(view, 150, 1e-9, 1000);
  expect(near.end - near.start).toBeCloseTo(8);
  expect(clampView({ start: 0, end: 1 }, 3)).toEqual({ start: 0, end: 3 });
});

it("converts between frames and pixels", () => {
  expect(toFrame(view, toX(view, 222, 640), 640)).toBeCloseTo(222);
});

describe("moveEdge", () => {
  it("does not move the other edge", () => {
    expect(moveEdge(view, "start", 50, 1000)).toEqual({ start: 50, end: 300 });
    expect(moveEdge(view, "end", 2000, 1000)).toEqual({ start: 100, end: 1000 });
  });
  it("does not cross the other edge", () => {
    expect(moveEdge(view, "start", 400, 1000)).toEqual({ start: 292, end: 300 });
  });
});

describe("scrollToFrame", () => {
  it("returns the same view if the frame is visible", () => {
    expect(scrollToFrame(view, 300, 1000)).toBe(view);
  });
  it("scrolls by a page if the frame is not visible", () => {
    const next = scrollToFrame(view, 301, 1000);
    expect(next.start).toBeCloseTo(291);
    expect(next.end).toBeCloseTo(491);
  });
});
