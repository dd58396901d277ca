/** Tests of the packed npm package, installed in a separate project. */

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";

const root = join(import.meta.dirname, "../..");
const project = mkdtempSync(join(tmpdir(), "plantigrade-package-"));
const npm = (args, cwd) =>
  execFileSync(process.platform === "win32" ? "npm.cmd" : "npm", args, { cwd, encoding: "utf8" });

before(() => {
  const packed = npm(
    ["pack", "--silent", "--pack-destination", project],
    join(root, "target/npm"),
  ).trim();
  writeFileSync(join(project, "package.json"), '{"type": "module", "private": true}');
  npm(["install", "--silent", "--offline", "--no-audit", join(project, packed)], project);
});
after(() => rmSync(project, { recursive: true }));

/** Runs a script in the project and returns its output. */
function outputOf(script) {
  writeFileSync(join(project, "use.mjs"), script);
  return execFileSync(process.execPath, ["use.mjs", join(root, "samples/curved-walk.bvh")], {
    cwd: project,
    encoding: "utf8",
  });
}

/** Returns the number of methods that are registered in a module of the core. */
function registeredMethods(module) {
  const source = readFileSync(join(root, "crate/core/src", module, "methods/mod.rs"), "utf8");
  return source.match(/^ {8}\w+ => /gm).length;
}

test("reads, labels, edits, measures, cleans and segments a clip", () => {
  const result = JSON.parse(
    outputOf(`
      import { readFileSync } from "node:fs";
      import { Clip, init, methods, segmentMethods } from "plantigrade";
      await init();
      const file = readFileSync(process.argv[2]);
      const clip = Clip.read(file);
      const plants = clip.detect();
      const table = new TextDecoder().decode(plants.save("csv", "walk.bvh"));
      const cleaned = Clip.read(plants.clean(file));
      const worst = Math.max(...plants.skate().map(({ maxDistance }) => maxDistance));
      const [start, end] = plants.intervals("contact", "left");
      plants.edit([{ side: "left", part: "contact", start, end, planted: false }]);
      console.log(JSON.stringify({
        methods: methods().length,
        segmentMethods: segmentMethods().length,
        intervals: plants.intervals("toe", "right").join(),
        sameIntervals: clip.detect({ method: "robust", r: 0.001, w: 1 }).intervals("toe", "right").join(),
        frames: clip.info().frames,
        parts: plants.parts,
        hasNoise: plants.noise.position < 0.001 && plants.noise.speed > 0.01,
        left: plants.intervals("contact", "left").length / 2,
        cadence: plants.gait().cadence,
        steps: plants.gait().steps.length,
        curves: plants.gait().curves.map(({ left }) => left.mean.length).join(),
        report: plants.gaitReport("walk.bvh", [{ name: "all", frames: [0, 245] }]).includes(">walk.bvh</h1>"),
        rows: table.trim().split("\\n").length,
        cleaned: cleaned.info().frames,
        worst,
        segments: clip.segment().segments.length,
      }));
      plants.free(); clip.free(); cleaned.free();
    `),
  );
  assert.equal(result.methods, registeredMethods("plants"));
  assert.equal(result.segmentMethods, registeredMethods("segments"));
  assert.equal(result.intervals, result.sameIntervals);
  assert.ok(result.steps > 2 && result.report);
  assert.equal(result.curves, "101,101,101");
  assert.equal(result.frames, 245);
  assert.deepEqual(result.parts, ["contact", "toe", "heel"]);
  assert.ok(result.hasNoise);
  assert.equal(result.left, 2);
  assert.ok(Math.abs(result.cadence - 112) < 4);
  assert.equal(result.rows, 246);
  assert.equal(result.cleaned, 245);
  assert.ok(result.worst > 0.001);
  assert.ok(result.segments >= 1);
});

test("applies edits to similar plants", () => {
  const text = outputOf(`
    import { readFileSync } from "node:fs";
    import { Clip, init } from "plantigrade";
    await init();
    const clip = Clip.read(readFileSync(process.argv[2].replace("curved-walk", "straight-jog")));
    const plants = clip.detect();
    const ends = () => plants.intervals("contact", "left").filter((_, i) => i % 2);
    const before = ends();
    const edit = { side: "left", part: "contact", planted: false };
    const edits = [{ ...edit, start: before[9] - 3, end: before[9] + 1 }];
    const { changes, plants: count } = plants.similar(edits);
    plants.edit([...edits, ...changes]);
    console.log(count, ends().filter((end, i) => end < before[i]).length);
  `);
  const [count, moved] = text.trim().split(" ").map(Number);
  assert.ok(count > 10 && moved > 6, text);
});

test("throws an error with the position in an invalid file", () => {
  const text = outputOf(`
    import { Clip, init, PlantigradeError } from "plantigrade";
    await init();
    try {
      Clip.read(new TextEncoder().encode("HIERARCHY\\nROOT a\\n{\\n  OFFSET 0 0 zero\\n"));
    } catch (error) {
      console.log(error instanceof PlantigradeError, error.failure.line, error.failure.hint.length > 9);
    }
  `);
  assert.equal(text.trim(), "true 4 true");
});

test("exports public types only", () => {
  const types = readFileSync(join(project, "node_modules/plantigrade/index.d.ts"), "utf8");
  assert.match(types, /static read\(bytes: Uint8Array/);
  assert.doesNotMatch(types, /constructor\(clip: WasmClip/);
});

test("contains the licences of the software in its module", () => {
  const notices = readFileSync(join(project, "node_modules/plantigrade/THIRD-PARTY.txt"), "utf8");
  for (const name of ["nalgebra", "wasm-bindgen", "Rust standard library"]) {
    assert.ok(notices.includes(`\n${name} `), name);
  }
  assert.match(notices, /Permission is hereby granted/);
});
