/** `npm run build`: a static site in web/dist that works from any folder of any file server. */

import { join } from "node:path";
import { main, root, run, step } from "./run.mjs";
import { setup } from "./setup.mjs";

/** Builds the site; the wasm module must be there. */
export async function buildSite() {
  step("Building the site");
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
    console.log("\nThe site is in web/dist: serve it as it is, from any folder.");
  });
}
