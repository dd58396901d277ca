import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { root } from "../../scripts/run.mjs";
import {
  binaryPackages,
  groupByLicence,
  noticesHtml,
  noticesText,
  sitePackages,
  wasmPackages,
  wheelPackages,
} from "../../scripts/third-party.mjs";

const mit = (copyright) =>
  `The MIT License (MIT)\n\n${copyright}\n\nPermission is hereby granted.\n`;
const info = (name, text) => ({ name, version: "1.0.0", licence: "MIT", texts: [text] });

test("shows a text that several packages share once, with all lines of copyright", () => {
  const groups = groupByLicence([
    info("b", "Copyright (c) 2020 B\n\nPermission is hereby\ngranted."),
    info("a", mit("Copyright © 2019 A\nCopyright 2021 <a@example.org>")),
    info("c", "Other terms. (c) is not a line of copyright here.\n(c) Nor here."),
  ]);
  assert.equal(groups.length, 2);
  assert.deepEqual(
    groups[0].packages.map(({ name, copyright }) => [name, ...copyright]),
    [
      ["a", "Copyright © 2019 A", "Copyright 2021 <a@example.org>"],
      ["b", "Copyright (c) 2020 B"],
    ],
  );
  assert.match(groups[1].text, /Nor here\.$/);
});

test("escapes notices for the page", () => {
  const html = noticesHtml([info("<b>", mit("Copyright <x>"))], "The app");
  assert.match(html, /&lt;b&gt;<\/b> 1\.0\.0/);
  assert.doesNotMatch(html, /<x>|<b><b>/);
});

test("the notices of the site contain all its packages and crates", () => {
  const text = noticesText(sitePackages(), "Plantigrade");
  const { dependencies } = JSON.parse(readFileSync(join(root, "package.json"), "utf8"));
  for (const name of [...Object.keys(dependencies), "workbox-core", "nalgebra", "wasm-bindgen"]) {
    assert.ok(text.includes(`\n${name} `), name);
  }
  assert.match(text, /\nRust standard library /);
  assert.match(text, /SIL OPEN FONT LICENSE/);
  assert.match(text, /Apache License\s+Version 2\.0/);
  assert.match(text, /copies of the Software, and to permit persons/);
  assert.doesNotMatch(text, /\[yyyy\]/);
  assert.doesNotMatch(text, /\n(playwright|proptest|syn) /);
});

test("every package has a licence text", () => {
  for (const list of [sitePackages(), wasmPackages(), wheelPackages(), binaryPackages()]) {
    assert.ok(list.length > 20);
    for (const { name, version, licence, texts } of list) {
      assert.ok(version && licence && texts.every((text) => text.length > 100), name);
    }
  }
});
