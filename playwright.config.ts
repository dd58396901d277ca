import { defineConfig } from "@playwright/test";

// A sandbox cannot be had by root, as in most containers.
const asRoot = process.getuid?.() === 0;
const executablePath = process.env.CHROMIUM_PATH;

export default defineConfig({
  testDir: "tests/browser",
  outputDir: "test-results",
  reporter: "list",
  fullyParallel: true,
  // A busy machine may miss a deadline once; what fails twice is wrong.
  retries: process.env.CI ? 1 : 0,
  forbidOnly: Boolean(process.env.CI),
  workers: 2,
  // The 3D picture is drawn by the processor where there is no graphics card.
  timeout: 60_000,
  expect: { timeout: 15_000 },
  use: {
    browserName: "chromium",
    viewport: { width: 1440, height: 900 },
    // Tests of it ask for it: the others would each fetch the whole site once more.
    serviceWorkers: "block",
    // Clips stay at the frame a test puts them; tests of motion ask for it.
    contextOptions: { reducedMotion: "reduce" },
    launchOptions: {
      args: asRoot ? ["--no-sandbox"] : [],
      ...(executablePath ? { executablePath } : {}),
    },
  },
});
