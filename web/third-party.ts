/**
 * Notices of third-party software: the build adds them to the site as a page, and fails if a bundle
 * contains a package without notice. `scripts/third-party.mjs` writes them before the build.
 */

import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import type { Plugin } from "vite";

const folder = join(import.meta.dirname, "third-party");

function read(name: string): string {
  const path = join(folder, name);
  if (!existsSync(path)) throw new Error(`${path} is missing. Run npm run build.`);
  return readFileSync(path, "utf8");
}

/** Returns the notices as plain text. */
export const noticesText = () => read("notices.txt");

/** Vite plugin: checks that all packages of a bundle have a notice. */
export function checkNotices(): Plugin {
  return {
    name: "check-notices",
    apply: "build",
    generateBundle(_, bundle) {
      const notices = noticesText();
      const chunks = Object.values(bundle).filter((file) => file.type === "chunk");
      for (const id of chunks.flatMap(({ moduleIds }) => moduleIds)) {
        const name = /.*\/node_modules\/((?:@[^/]+\/)?[^/]+)\//.exec(id)?.[1];
        if (name && !notices.includes(`\n${name} `))
          throw new Error(`${name} has no notice. Add it to scripts/third-party.mjs.`);
      }
    },
  };
}

/** Vite plugin: adds the page of notices to the site. */
export function noticesPage(): Plugin {
  return {
    name: "notices-page",
    generateBundle() {
      this.emitFile({ type: "asset", fileName: "third-party.html", source: read("notices.html") });
    },
    configureServer(server) {
      server.middlewares.use("/third-party.html", (_, response) => {
        response.setHeader("content-type", "text/html; charset=utf-8");
        response.end(read("notices.html"));
      });
    },
  };
}
