import type { Plugin } from "vite";
import { defineConfig } from "vitest/config";
import { offline } from "./offline.ts";
import { player } from "./player.ts";
import { reportStyleSource } from "./report-style.ts";
import { checkNotices, noticesPage } from "./third-party.ts";

/** Content security policy of the built page. `https:` allows clips of `#url=` links. */
const policy = [
  "default-src 'none'",
  "script-src 'self' 'wasm-unsafe-eval'",
  `style-src 'self' ${reportStyleSource}`,
  "worker-src 'self' blob:",
  "connect-src 'self' https:",
  "img-src 'self' data: blob:",
  "media-src blob:",
  "font-src 'self'",
  "manifest-src 'self'",
  "base-uri 'none'",
  "form-action 'none'",
].join("; ");

const contentSecurityPolicy: Plugin = {
  name: "content-security-policy",
  apply: "build",
  transformIndexHtml: () => [
    {
      tag: "meta",
      attrs: { "http-equiv": "Content-Security-Policy", content: policy },
      injectTo: "head-prepend",
    },
  ],
};

export default defineConfig({
  root: import.meta.dirname,
  base: "./",
  cacheDir: "../node_modules/.vite",
  plugins: [contentSecurityPolicy, player(), noticesPage(), checkNotices(), offline()],
  oxc: { jsx: { runtime: "automatic", importSource: "preact" } },
  worker: { format: "es", plugins: () => [checkNotices()] },
  build: {
    outDir: "dist",
    emptyOutDir: true,
    assetsInlineLimit: 0,
    target: "es2023",
    chunkSizeWarningLimit: 700,
    // The build of the single-file page runs inside of a plugin, which is slow.
    rolldownOptions: {
      checks: { pluginTimings: false },
      // Makes V8 compile all functions in the background while loading, not when a clip is opened.
      output: { postBanner: "//# allFunctionsCalledOnLoad" },
    },
  },
  server: { fs: { allow: [".."] } },
  test: { environment: "happy-dom", include: ["src/**/*.test.{ts,tsx}"] },
});
