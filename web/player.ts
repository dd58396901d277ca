/**
 * The player: a second build of the app as a single HTML file with empty blocks for a clip. The site
 * downloads it when a clip is shared as one file; the Python package shows it in notebooks.
 */

import { createHash } from "node:crypto";
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { build, type Plugin } from "vite";
import { reportStyleSource } from "./report-style.ts";
import { blockIds, noticesId } from "./src/model/sources/player-html.ts";
import { checkNotices, noticesText } from "./third-party.ts";

const moduleId = "virtual:player";

/** Vite plugin: builds the player and provides its URL as the module `virtual:player`. */
export function player(): Plugin {
  let isBuild = true;
  return {
    name: "player",
    configResolved(config) {
      isBuild = config.command === "build";
    },
    resolveId: (id) => (id === moduleId ? `\0${moduleId}` : undefined),
    async load(id) {
      if (id !== `\0${moduleId}`) return undefined;
      if (!isBuild) return 'export default "/player.html"';
      const assetId = this.emitFile({
        type: "asset",
        name: "player.html",
        source: await buildPage(),
      });
      return `export default import.meta.ROLLUP_FILE_URL_${assetId}`;
    },
    configureServer(server) {
      server.middlewares.use("/player.html", (_, response) => {
        buildPage().then(
          (html) => response.end(html),
          (error) => response.writeHead(500).end(String(error)),
        );
      });
    },
  };
}

/** Builds the app as one script and one style sheet, and returns the page that contains both. */
export async function buildPage(): Promise<string> {
  const result = await build({
    configFile: false,
    root: import.meta.dirname,
    logLevel: "warn",
    publicDir: false,
    plugins: [singleFilePlugin(), checkNotices()],
    oxc: { jsx: { runtime: "automatic", importSource: "preact" } },
    worker: { format: "iife", plugins: () => [singleFilePlugin(), checkNotices()] },
    build: {
      write: false,
      assetsInlineLimit: Number.POSITIVE_INFINITY,
      target: "es2023",
      chunkSizeWarningLimit: 2000,
      modulePreload: false,
      rolldownOptions: {
        input: join(import.meta.dirname, "src/main.tsx"),
        output: { codeSplitting: false },
        checks: { pluginTimings: false },
      },
    },
  });
  const output = [result].flat().flatMap((bundle) => ("output" in bundle ? bundle.output : []));
  const code = output.filter((file) => file.type === "chunk").map((file) => file.code);
  const styles = output.flatMap((file) =>
    file.type === "asset" && file.fileName.endsWith(".css") ? String(file.source) : [],
  );
  if (code.length !== 1 || styles.length !== 1 || output.length !== 2) {
    const files = output.map((file) => file.fileName).join(", ");
    throw new Error(`The player must consist of one script and one style sheet, not of ${files}.`);
  }
  return toHtml(code[0] ?? "", styles[0] ?? "");
}

/** Vite plugin of the player build: replaces a module `x.ts` by `x.player.ts` if that exists. */
function singleFilePlugin(): Plugin {
  return {
    name: "single-file",
    enforce: "pre",
    async resolveId(id, importer, options) {
      if (id === moduleId) return `\0${moduleId}`;
      const resolved = await this.resolve(id, importer, { ...options, skipSelf: true });
      const replacement = resolved?.id.replace(/\.ts$/, ".player.ts");
      return replacement && replacement !== resolved?.id && existsSync(replacement)
        ? replacement
        : undefined;
    },
    load: (id) => (id === `\0${moduleId}` ? 'export default ""' : undefined),
    // The bindings must not refer to the wasm file; the player passes the module to them.
    transform: (code, id) =>
      id.endsWith("plantigrade.js")
        ? code.replace(/new URL\('plantigrade_bg.wasm', import.meta.url\)/, "undefined")
        : undefined,
  };
}

/** Returns the page, with a content security policy that allows only its script and style. */
function toHtml(code: string, style: string): string {
  // The wasm module has its own compressed block.
  if (code.includes("data:application/wasm")) {
    throw new Error("The player script contains the wasm module a second time.");
  }
  // Neither text may contain the end tag of its element.
  const script = code.replace(/<(?=\/script|!--)/gi, "\\x3c");
  const css = style.replace(/<(?=\/style)/gi, "\\3c ");
  const cspHash = (text: string) =>
    `'sha256-${createHash("sha256").update(text).digest("base64")}'`;
  const policy = [
    "default-src 'none'",
    `script-src ${cspHash(script)} 'wasm-unsafe-eval'`,
    `style-src ${cspHash(css)} ${reportStyleSource}`,
    "worker-src blob:",
    "img-src data: blob:",
    "media-src blob:",
    "font-src data:",
    "base-uri 'none'",
    "form-action 'none'",
  ].join("; ");
  const icon = readFileSync(join(import.meta.dirname, "public/icon.svg")).toString("base64");
  const blocks = blockIds
    .filter((block) => block !== "title")
    .map((block) => `<script type="text/plain" id="${block}"></script>\n`);
  return `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="${policy}">
<meta name="viewport" content="width=device-width, initial-scale=1, viewport-fit=cover">
<meta name="color-scheme" content="dark light">
<link rel="icon" href="data:image/svg+xml;base64,${icon}">
<title>Plantigrade</title>
<style>${css}</style>
</head>
<body>
<div id="app"></div>
<noscript>This page requires JavaScript. It shows a clip on this computer and sends no data.</noscript>
${blocks.join("")}<script type="text/plain" id="${noticesId}">
${noticesText().replace(/<(?=[/!])/g, "(")}</script>
<script type="module">${script}</script>
</body>
</html>
`;
}
