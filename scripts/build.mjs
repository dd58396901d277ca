/** `npm run build`: builds the static site in web/dist, which works in any folder of a file server. */

import { join } from "node:path";
import { main, root, run, step } from "./run.mjs";
import { setup } from "./setup.mjs";
import { writeSiteNotices } from "./third-party.mjs";

/** Builds the site; requires the wasm module. */
export async function buildSite() {
  step("Building the site");
  writeSiteNotices();
  await run(process.execPath, [
    join(root, "node_modules/vite/bin/vite.js"),
    "build",
    "web",
    "--logLevel",
    "warn",
  ]);
}

if (process.argv[1] === import.meta.filename) {
  await main(async () => {
    await setup();
    await buildSite();
    console.log("\nThe site is in web/dist. It can be served from any folder.");
  });
}
