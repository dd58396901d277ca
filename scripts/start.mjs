/** `npm start`: sets up, builds and serves the app, and shows its address. */

import { join } from "node:path";
import { buildSite } from "./build.mjs";
import { main, root, Stop } from "./run.mjs";
import { setup } from "./setup.mjs";

await main(async () => {
  await setup();
  await buildSite();
  // Imported here because setup() may have just installed it.
  const { preview } = await import("vite");
  const requested = process.env.PORT;
  const port = Number(requested ?? 5173);
  const server = await preview({
    root: join(root, "web"),
    logLevel: "warn",
    preview: { port, strictPort: requested !== undefined },
  }).catch((error) => {
    throw new Stop(
      /already in use/.test(error.message)
        ? `Port ${port} is in use. Stop the other program, or choose another port: PORT=8080 npm start.`
        : error.message,
    );
  });
  console.log(`\n✔ Plantigrade is at ${server.resolvedUrls.local[0]}  (press Ctrl+C to stop)`);
});
