/** Service worker and manifest: the app can be installed and works offline. */

import { VitePWA } from "vite-plugin-pwa";

export const offline = () =>
  VitePWA({
    // The app registers the service worker itself, after everything else has loaded.
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
      // Also serves the page that registered it.
      clientsClaim: true,
      // Online, the page is always loaded from the network, so that updates apply immediately.
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
