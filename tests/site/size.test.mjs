/** Size of what a first visit downloads, compressed by Brotli as a server would send it. */

import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { brotliCompressSync, constants } from "node:zlib";
import { root } from "../../scripts/run.mjs";

const site = join(root, "web/dist");
const assets = readdirSync(join(site, "assets"));

/** Upper limits, in kB; slightly above the sizes of today. */
const limits = { first: 234, both: 549, script: 83, view: 132 };

const sizeOf = (path) => {
  const data = readFileSync(join(site, path));
  const params = {
    [constants.BROTLI_PARAM_QUALITY]: 11,
    [constants.BROTLI_PARAM_LGWIN]: 24,
    [constants.BROTLI_PARAM_SIZE_HINT]: data.length,
  };
  return brotliCompressSync(data, { params }).length / 1000;
};

/** Returns the path of the only asset whose name, without its hash, is given. */
function asset(name, ending) {
  const found = assets.filter((file) => file.startsWith(`${name}-`) && file.endsWith(ending));
  assert.equal(found.length, 1, `assets called ${name}`);
  return `assets/${found[0]}`;
}

function check(name, size) {
  console.log(`${name}: ${size.toFixed(1)} kB of ${limits[name]} kB`);
  assert.ok(
    size <= limits[name],
    `${name} has ${size.toFixed(1)} kB, more than ${limits[name]} kB`,
  );
}

test("the wasm modules are small", () => {
  const first = sizeOf(asset("plantigrade_bg", ".wasm"));
  check("first", first);
  check("both", first + sizeOf(asset("plantigrade_second", ".wasm")));
});

test("the scripts before the first labels are small", () => {
  const html = readFileSync(join(site, "index.html"), "utf8");
  const scripts = [...html.matchAll(/(?:src|href)="\.\/(assets\/[^"]+\.js)"/g)].map(
    ([, path]) => path,
  );
  assert.ok(scripts.length > 0, "the page has scripts");
  const worker = asset("clip.worker", ".js");
  const script = [...new Set(scripts), worker].reduce((sum, path) => sum + sizeOf(path), 0);
  check("script", script);
  // The view loads at the same time; the labels do not wait for it.
  check("view", sizeOf(asset("stage", ".js")));
});
