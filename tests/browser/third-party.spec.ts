/** Notices of third-party software: on the site and in single-file pages. */

import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { expect, test } from "./app";
import { root } from "./clips";

/** Software that every copy of the app contains. */
const names = ["three", "preact", "@preact/signals", "uplot", "fflate", "nalgebra", "wasm-bindgen"];

test("links to the licences of third-party software", async ({ app, page, context }) => {
  await app.openStartPage();
  const opened = context.waitForEvent("page");
  await page.getByRole("link", { name: "Third-party software" }).click();
  const notices = await opened;
  await expect(notices.getByRole("heading", { name: "Third-party software" })).toBeVisible();
  const text = await notices.getByRole("main").innerText();
  for (const name of names) expect(text).toContain(`${name} `);
  expect(text).toContain("Permission is hereby granted, free of charge");
  expect(text).toContain("SIL OPEN FONT LICENSE");
  // The service worker contains parts of Workbox.
  const worker = readFileSync(join(root, "web/dist/sw.js"), "utf8");
  const parts = [...worker.matchAll(/workbox:([a-z-]+):/g)].map(([, part]) => `workbox-${part}`);
  expect(parts).toContain("workbox-core");
  for (const part of parts) expect(text).toContain(`${part} `);
});

test("offers the licences while a clip is open", async ({ app, page }) => {
  await app.openSample("curved-walk");
  await page.keyboard.press("?");
  await expect(app.dialog.getByRole("link", { name: "Third-party software" })).toHaveAttribute(
    "href",
    "./third-party.html",
  );
});

test("single-file pages contain the licences", async ({ app, page }, info) => {
  await app.openSample("curved-walk");
  const saved = await app.savePage();
  for (const name of names) expect(saved.text).toContain(`\n${name} `);
  app.expectProblem(/^request to elsewhere: file:/);
  const path = info.outputPath(saved.name);
  writeFileSync(path, saved.bytes);
  await page.goto(pathToFileURL(path).href);
  await page.getByRole("button", { name: "Share" }).click();
  await app.dialog.getByRole("button", { name: "Third-party software" }).click();
  await expect(app.dialog).toContainText("Permission is hereby granted, free of charge");
  for (const name of names) await expect(app.dialog).toContainText(`${name} `);
  await page.keyboard.press("Escape");
  await expect(app.dialog).toHaveCount(0);
});
