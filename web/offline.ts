/** Web app manifest and service worker. */

import { VitePWA } from "vite-plugin-pwa";

export const offline = () =>
  VitePWA({
    // Registered by the app after loading.
    injectRegister: null,
    manifest: {
      name: "Plantigrade",
      short_name: "Plantigrade",
      description: "Detects foot plants in motion capture.",
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
      // The worker also serves the page that installed it.
      clientsClaim: true,
      // The page itself is loaded from the network if possible, so that it is the newest version.
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
