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

/** Loads the first module at the same time as the scripts that request it. */
const preloadModule: Plugin = {
  name: "preload-module",
  apply: "build",
  transformIndexHtml: {
    order: "post",
    handler: (_, { bundle = {} }) =>
      Object.keys(bundle)
        .filter((file) => /plantigrade_bg.*\.wasm$/.test(file))
        .map((file) => ({
          tag: "link",
          attrs: { rel: "preload", as: "fetch", crossorigin: "", href: `./${file}` },
          injectTo: "head",
        })),
  },
};

export default defineConfig({
  root: import.meta.dirname,
  base: "./",
  cacheDir: "../node_modules/.vite",
  plugins: [
    contentSecurityPolicy,
    preloadModule,
    player(),
    noticesPage(),
    checkNotices(),
    offline(),
  ],
  oxc: { jsx: { runtime: "automatic", importSource: "preact" } },
  worker: { format: "es", plugins: () => [checkNotices()] },
  build: {
    outDir: "dist",
    emptyOutDir: true,
    assetsInlineLimit: 0,
    target: "es2023",
    chunkSizeWarningLimit: 700,
    // The target implies browsers that preload modules themselves.
    modulePreload: { polyfill: false },
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
