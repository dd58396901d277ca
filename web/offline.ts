/** The app as one that is installed and opens without a network. */

import { VitePWA } from "vite-plugin-pwa";

export const offline = () =>
  VitePWA({
    // The app registers it itself, when it has nothing left to load.
    injectRegister: null,
    manifest: {
      name: "Plantigrade",
      short_name: "Plantigrade",
      description: "Find every foot plant in a motion capture clip.",
      id: "./",
      start_url: "./",
      scope: "./",
      display: "standalone",
      theme_color: "#161b21",
      background_color: "#0f1317",
      categories: ["utilities", "graphics"],
      icons: [
        { src: "icon.svg", sizes: "any", type: "image/svg+xml" },
        { src: "icon-192.png", sizes: "192x192", type: "image/png" },
        { src: "icon-512.png", sizes: "512x512", type: "image/png" },
        { src: "icon-maskable.png", sizes: "512x512", type: "image/png", purpose: "maskable" },
      ],
    },
    workbox: {
      globPatterns: ["**/*"],
      globIgnores: ["sw.js"],
      maximumFileSizeToCacheInBytes: 2 ** 24,
      dontCacheBustURLsMatching: /assets\//,
      inlineWorkboxRuntime: true,
      sourcemap: false,
      // The page that installed it is served by it too.
      clientsClaim: true,
      // With a network the page is the newest, as it would be without all this.
      directoryIndex: null,
      navigateFallback: null,
      runtimeCaching: [
        {
          urlPattern: ({ request }) => request.mode === "navigate",
          handler: "NetworkOnly",
          options: { precacheFallback: { fallbackURL: "index.html" } },
        },
      ],
    },
  });
