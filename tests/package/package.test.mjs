/** The npm package as a person uses it: packed, installed in a project of its own, and called. */

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";

const root = join(import.meta.dirname, "../..");
const project = mkdtempSync(join(tmpdir(), "uses-plantigrade-"));
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

/** What a script of that project prints. */
function output(script) {
  writeFileSync(join(project, "use.mjs"), script);
  return execFileSync(process.execPath, ["use.mjs", join(root, "samples/curved-walk.bvh")], {
    cwd: project,
    encoding: "utf8",
  });
}

test("a clip is read, labelled, measured, cleaned and cut", () => {
  const found = JSON.parse(
    output(`
      import { readFileSync } from "node:fs";
      import { Clip, init, methods } from "plantigrade";
      await init();
      const clip = Clip.read(readFileSync(process.argv[2]));
      const plants = clip.detect();
      const table = new TextDecoder().decode(plants.save("csv", "walk.bvh"));
      const cleaned = Clip.read(new TextEncoder().encode(plants.clean()));
      const worst = Math.max(...plants.skate().map(({ maxDistance }) => maxDistance));
      const [start, end] = plants.intervals("contact", "left");
      plants.edit([{ side: "left", part: "contact", start, end, planted: false }]);
      console.log(JSON.stringify({
        methods: methods().length,
        frames: clip.info().frames,
        parts: plants.parts,
        left: plants.intervals("contact", "left").length / 2,
        cadence: plants.gait().cadence,
        rows: table.trim().split("\\n").length,
        cleaned: cleaned.info().frames,
        worst,
        segments: clip.segment().segments.length,
      }));
      plants.free(); clip.free(); cleaned.free();
    `),
  );
  assert.equal(found.methods, 16);
  assert.equal(found.frames, 245);
  assert.deepEqual(found.parts, ["contact", "toe", "heel"]);
  assert.equal(found.left, 2);
  assert.ok(Math.abs(found.cadence - 112) < 4);
  assert.equal(found.rows, 246);
  assert.equal(found.cleaned, 245);
  assert.ok(found.worst > 0.001);
  assert.ok(found.segments >= 1);
});

test("a bad file is an error that says where", () => {
  const said = output(`
    import { Clip, init, PlantigradeError } from "plantigrade";
    await init();
    try {
      Clip.read(new TextEncoder().encode("HIERARCHY\\nROOT a\\n{\\n  OFFSET 0 0 zero\\n"));
    } catch (error) {
      console.log(error instanceof PlantigradeError, error.failure.line, error.failure.hint.length > 9);
    }
  `);
  assert.equal(said.trim(), "true 4 true");
});

test("the types are those of the package", () => {
  const types = readFileSync(join(project, "node_modules/plantigrade/index.d.ts"), "utf8");
  assert.match(types, /static read\(bytes: Uint8Array/);
  assert.doesNotMatch(types, /constructor\(clip: WasmClip/);
});
