/** `npm start`: sets up, builds and serves the app, and prints its address. */

import { join } from "node:path";
import { buildSite } from "./build.mjs";
import { main, root, Stop } from "./run.mjs";
import { setup } from "./setup.mjs";

await main(async () => {
  await setup();
  await buildSite();
  // Only now are the packages sure to be there.
  const { preview } = await import("vite");
  const wanted = process.env.PORT;
  const port = Number(wanted ?? 5173);
  const server = await preview({
    root: join(root, "web"),
    logLevel: "warn",
    preview: { port, strictPort: wanted !== undefined },
  }).catch((error) => {
    throw new Stop(
      /already in use/.test(error.message)
        ? `Port ${port} is in use: end what uses it, or name another one, as in PORT=8080 npm start.`
        : error.message,
    );
  });
  console.log(`\n✔ Plantigrade is at ${server.resolvedUrls.local[0]}  (Ctrl+C ends it)`);
});
