import { defineConfig } from "@playwright/test";

// Chromium cannot use its sandbox as root, as in most containers.
const isRoot = process.getuid?.() === 0;
const executablePath = process.env.CHROMIUM_PATH;

export default defineConfig({
  testDir: "tests/browser",
  outputDir: "test-results",
  reporter: "list",
  fullyParallel: true,
  // A busy machine may miss a deadline.
  retries: process.env.CI ? 1 : 0,
  forbidOnly: Boolean(process.env.CI),
  workers: 2,
  // Without a graphics card, WebGL is rendered in software; a busy machine is several times slower.
  timeout: 180_000,
  expect: { timeout: 15_000 },
  use: {
    browserName: "chromium",
    viewport: { width: 1440, height: 900 },
    // Enabled in the tests that need it, because it downloads all files of the site.
    serviceWorkers: "block",
    // Prevents clips from playing when they are opened.
    contextOptions: { reducedMotion: "reduce" },
    launchOptions: {
      // WebGL in software takes a third longer with multisampling.
      args: ["--webgl-antialiasing-mode=none", ...(isRoot ? ["--no-sandbox"] : [])],
      ...(executablePath ? { executablePath } : {}),
    },
  },
});
