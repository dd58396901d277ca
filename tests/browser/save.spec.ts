import { createHash } from "node:crypto";
import { expect, test } from "./app";
import { sample } from "./clips";
import { readLabels, readTable, type Span } from "./labels";

test("Ctrl+S saves the labels as JSON", async ({ app, page }) => {
  const file = sample("bowling");
  await app.openFile(file);
  const saved = await app.download(() => page.keyboard.press("Control+s"));
  expect(saved.name).toBe("bowling.plants.json");
  const labels = readLabels(saved);
  expect(labels.format).toBe("plantigrade-labels");
  expect(labels.version).toBe(1);
  expect(labels.source.name).toBe("bowling.bvh");
  expect(labels.source.sha256).toBe(createHash("sha256").update(file.buffer).digest("hex"));
  expect(labels.frames).toBe(316);
  expect(labels.rate).toBeCloseTo(30, 3);
  expect(labels.method).toMatchObject({ name: "robust", r: 0.001, w: 1 });
  for (const foot of [labels.left, labels.right]) {
    for (const spans of [foot.contact, foot.heel, foot.toe]) expectSpans(spans, labels);
  }
});

/** Plants are in order, disjoint, within the clip, and consistent in frames and seconds. */
function expectSpans(
  spans: Span[] | undefined,
  { frames, rate }: { frames: number; rate: number },
) {
  expect(spans?.length).toBeGreaterThan(0);
  let end = -1;
  for (const span of spans ?? []) {
    expect(span.start).toBeGreaterThan(end);
    expect(span.end).toBeGreaterThan(span.start);
    expect(span.end).toBeLessThanOrEqual(frames);
    expect(span.start_s).toBeCloseTo(span.start / rate, 4);
    expect(span.end_s).toBeCloseTo(span.end / rate, 4);
    expect(span.source).toBe("auto");
    end = span.end;
  }
}

test("the frame table agrees with the JSON document", async ({ app }) => {
  await app.openSample("bowling");
  const saved = await app.save("Every frame");
  expect(saved.name).toBe("bowling.frames.csv");
  const { header, rows } = readTable(saved);
  expect(header).toBe(
    "frame,time,left_contact,left_heel,left_toe,right_contact,right_heel,right_toe",
  );
  expect(rows.map((row) => Number(row.frame))).toEqual([...Array(316).keys()]);
  expect(Number(rows[300]?.time)).toBeCloseTo(10, 3);
  const labels = readLabels(await app.save("Labels"));
  for (const side of ["left", "right"] as const) {
    for (const part of ["contact", "heel", "toe"] as const) {
      const inSpan = (frame: number) =>
        labels[side][part]?.some(({ start, end }) => frame >= start && frame < end);
      expect(rows.map((row) => row[`${side}_${part}`])).toEqual(
        rows.map((_, frame) => (inSpan(frame) ? "1" : "0")),
      );
    }
  }
});

test("the interval table lists every plant of every part", async ({ app }) => {
  await app.openSample("bowling");
  const saved = await app.save("Every plant");
  expect(saved.name).toBe("bowling.intervals.csv");
  const { header, rows } = readTable(saved);
  expect(header).toBe("foot,part,start_frame,end_frame,start_s,end_s");
  const labels = readLabels(await app.save("Labels"));
  for (const side of ["left", "right"] as const) {
    for (const part of ["contact", "heel", "toe"] as const) {
      const listed = rows
        .filter((row) => row.foot === side && row.part === part)
        .map((row) => [Number(row.start_frame), Number(row.end_frame)]);
      expect(listed).toEqual(labels[side][part]?.map(({ start, end }) => [start, end]));
    }
  }
});

test("the event table lists every foot strike and foot off", async ({ app }) => {
  await app.openSample("curved-walk");
  const saved = await app.save("Gait events");
  expect(saved.name).toBe("curved-walk.events.csv");
  const { header, rows } = readTable(saved);
  expect(header).toBe("time,frame,context,event,uncertainty_ms");
  const { left, right, frames } = readLabels(await app.save("Labels"));
  const feet = [
    ["Left", left],
    ["Right", right],
  ] as const;
  const events = feet.flatMap(([context, foot]) =>
    (foot.contact ?? []).flatMap(({ start, end }) => [
      ...(start > 0 ? [`${start} ${context} Foot Strike`] : []),
      ...(end < frames ? [`${end} ${context} Foot Off`] : []),
    ]),
  );
  expect(rows.map(({ frame, context, event }) => `${frame} ${context} ${event}`).sort()).toEqual(
    events.sort(),
  );
  const times = rows.map(({ time }) => Number(time));
  expect(times).toEqual([...times].sort((a, b) => a - b));
});

test("reads back the NumPy arrays as labels", async ({ app }) => {
  await app.openSample("curved-walk");
  const { name, bytes } = await app.save("Arrays");
  expect(name).toBe("curved-walk.contacts.npz");
  await app.drop({ name, mimeType: "", buffer: Buffer.from(bytes) });
  await app.tab("Score");
  await expect(app.panel.getByRole("row", { name: /^0.0 s/ })).toContainText("100.0");
});

test("the Blender script contains all plants", async ({ app }) => {
  await app.openSample("curved-walk");
  const labels = readLabels(await app.save("Labels"));
  const { name, text } = await app.save("Blender");
  expect(name).toBe("curved-walk.blender.py");
  expect(text).toContain("import bpy");
  for (const { start, end } of labels.left.contact ?? []) {
    expect(text).toMatch(new RegExp(`\\b${start}\\b[^\n]*`));
    expect(text).toMatch(new RegExp(`\\b${end}\\b[^\n]*`));
  }
});
