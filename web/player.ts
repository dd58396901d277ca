/**
 * The page in one file: the app built once more with everything it needs inside, and room for a
 * clip. The site has it as a file that is asked for when somebody shares.
 */

import { createHash } from "node:crypto";
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { build, type Plugin } from "vite";
import { blockIds } from "./src/model/player-html.ts";

const name = "virtual:player";

/** Gives the app the address of the page. */
export function player(): Plugin {
  let isBuild = true;
  return {
    name: "player",
    configResolved(config) {
      isBuild = config.command === "build";
    },
    resolveId: (id) => (id === name ? `\0${name}` : undefined),
    async load(id) {
      if (id !== `\0${name}`) return undefined;
      if (!isBuild) return 'export default "/player.html"';
      const made = this.emitFile({ type: "asset", name: "player.html", source: await page() });
      return `export default import.meta.ROLLUP_FILE_URL_${made}`;
    },
    configureServer(server) {
      server.middlewares.use("/player.html", (_, response) => {
        page().then(
          (html) => response.end(html),
          (error) => response.writeHead(500).end(String(error)),
        );
      });
    },
  };
}

async function page(): Promise<string> {
  const built = await build({
    configFile: false,
    root: import.meta.dirname,
    logLevel: "warn",
    publicDir: false,
    plugins: [inside()],
    oxc: { jsx: { runtime: "automatic", importSource: "preact" } },
    worker: { format: "iife", plugins: () => [inside()] },
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

/** For `x.ts` there may be an `x.player.ts` that stands in for it here. */
function inside(): Plugin {
  return {
    name: "inside",
    enforce: "pre",
    async resolveId(id, importer, options) {
      if (id === name) return `\0${name}`;
      const found = await this.resolve(id, importer, { ...options, skipSelf: true });
      const other = found?.id.replace(/\.ts$/, ".player.ts");
      return other && other !== found?.id && existsSync(other) ? other : undefined;
    },
    load: (id) => (id === `\0${name}` ? 'export default ""' : undefined),
    // The bindings would fetch the core themselves if nobody gave it to them: here someone does.
    transform: (code, id) =>
      id.endsWith("plantigrade.js")
        ? code.replace(/new URL\('plantigrade_bg.wasm', import.meta.url\)/, "undefined")
        : undefined,
  };
}

function html(code: string, style: string): string {
  // It has a block of its own, packed: a second one would double the page.
  if (code.includes("data:application/wasm")) throw new Error("The core is in the script too.");
  // Neither may end its element.
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
  const rooms = blockIds
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
<noscript>This page needs JavaScript: it shows a clip on your computer, and sends nothing.</noscript>
${rooms.join("")}<script type="module">${script}</script>
</body>
</html>
`;
}
