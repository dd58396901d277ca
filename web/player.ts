/**
 * Builds the single-file page: the app with all its resources inlined, and empty blocks for a clip.
 * The site contains it as a file that is downloaded when a clip is shared.
 */

import { createHash } from "node:crypto";
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { build, type Plugin } from "vite";
import { blockIds } from "./src/model/player-html.ts";

const moduleName = "virtual:player";

/** Provides the URL of the page as a virtual module. */
export function player(): Plugin {
  let isBuild = true;
  return {
    name: "player",
    configResolved(config) {
      isBuild = config.command === "build";
    },
    resolveId: (id) => (id === moduleName ? `\0${moduleName}` : undefined),
    async load(id) {
      if (id !== `\0${moduleName}`) return undefined;
      if (!isBuild) return 'export default "/player.html"';
      const reference = this.emitFile({
        type: "asset",
        name: "player.html",
        source: await buildPage(),
      });
      return `export default import.meta.ROLLUP_FILE_URL_${reference}`;
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

async function buildPage(): Promise<string> {
  const built = await build({
    configFile: false,
    root: import.meta.dirname,
    logLevel: "warn",
    publicDir: false,
    plugins: [playerModules()],
    oxc: { jsx: { runtime: "automatic", importSource: "preact" } },
    worker: { format: "iife", plugins: () => [playerModules()] },
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
  const output = [built].flat().flatMap((part) => ("output" in part ? part.output : []));
  const code = output.filter((file) => file.type === "chunk").map((file) => file.code);
  const styles = output.flatMap((file) =>
    file.type === "asset" && file.fileName.endsWith(".css") ? String(file.source) : [],
  );
  if (code.length !== 1 || styles.length !== 1 || output.length !== 2) {
    throw new Error(`The page must be one script and one style: ${output.map((f) => f.fileName)}`);
  }
  return html(code[0] ?? "", styles[0] ?? "");
}

/** Replaces modules: where `x.player.ts` exists, it is used instead of `x.ts`. */
function playerModules(): Plugin {
  return {
    name: "player-modules",
    enforce: "pre",
    async resolveId(id, importer, options) {
      if (id === moduleName) return `\0${moduleName}`;
      const resolved = await this.resolve(id, importer, { ...options, skipSelf: true });
      const replacement = resolved?.id.replace(/\.ts$/, ".player.ts");
      const exists = replacement && replacement !== resolved?.id && existsSync(replacement);
      return exists ? replacement : undefined;
    },
    load: (id) => (id === `\0${moduleName}` ? 'export default ""' : undefined),
    // Removes the default URL of the wasm module, which the player passes to the bindings.
    transform: (code, id) =>
      id.endsWith("plantigrade.js")
        ? code.replace(/new URL\('plantigrade_bg.wasm', import.meta.url\)/, "undefined")
        : undefined,
  };
}

function html(code: string, style: string): string {
  // The wasm module is in a compressed block; a copy in the script would double the size.
  if (code.includes("data:application/wasm")) throw new Error("The script contains the core.");
  // Script and style must not end their elements.
  const script = code.replace(/<(?=\/script|!--)/gi, "\\x3c");
  const css = style.replace(/<(?=\/style)/gi, "\\3c ");
  const hash = (text: string) => `'sha256-${createHash("sha256").update(text).digest("base64")}'`;
  const policy = [
    "default-src 'none'",
    `script-src ${hash(script)} 'wasm-unsafe-eval'`,
    `style-src ${hash(css)}`,
    "worker-src blob:",
    "img-src data: blob:",
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
<noscript>This page requires JavaScript. It sends no data.</noscript>
${blocks.join("")}<script type="module">${script}</script>
</body>
</html>
`;
}
