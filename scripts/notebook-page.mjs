/**
 * The page of notebooks: the player with the wasm modules, compressed, which gets its clip from the notebook that
 * contains its frame.
 */

import { createHash } from "node:crypto";
import { existsSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { gzipSync } from "node:zlib";
import { root, step } from "./run.mjs";
import { targetFolder } from "./setup.mjs";
import { writeSiteNotices } from "./third-party.mjs";

/** Contents of the blocks of the page; see `web/src/model/sources/player-html.ts` and `web/src/store/embedded.ts`. */
function blocks() {
  const module = (name) =>
    gzipSync(readFileSync(join(root, "web/src/wasm", name)), { level: 9 }).toString("base64");
  return {
    enclosed: JSON.stringify({ version: 1, host: true }),
    core: module("plantigrade_bg.wasm"),
    second: module("plantigrade_second.wasm"),
  };
}

/** Writes the page; requires the wasm modules. A page of the same sources is not built again. */
export async function writeNotebookPage(path) {
  const stamp = join(targetFolder(), "python/notebook-page.txt");
  writeSiteNotices();
  const sources = hashOfSources();
  if (existsSync(path) && existsSync(stamp) && readFileSync(stamp, "utf8") === sources) return;
  step("Building the page of notebooks");
  // Not installed before the setup.
  const { runnerImport } = await import("vite");
  const { module } = await runnerImport(join(root, "web/player.ts"));
  let page = await module.buildPage();
  for (const [id, content] of Object.entries(blocks())) {
    const opening = ` id="${id}">`;
    if (page.split(opening).length !== 2) throw new Error(`The page has no single block "${id}".`);
    page = page.replace(opening, () => opening + content);
  }
  writeFileSync(path, gzipSync(page, { level: 9 }));
  writeFileSync(stamp, sources);
}

/** Returns a hash of everything that the page is made from. */
function hashOfSources() {
  const hash = createHash("sha256");
  const files = readdirSync(join(root, "web"), { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => join(entry.parentPath, entry.name))
    .filter((path) => !path.startsWith(join(root, "web/dist")));
  for (const path of [...files.sort(), join(root, "package-lock.json"), import.meta.filename]) {
    hash.update(`${path}\n`).update(readFileSync(path));
  }
  return hash.digest("hex");
}
