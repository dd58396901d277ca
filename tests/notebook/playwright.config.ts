import { defineConfig } from "@playwright/test";
import shared from "../../playwright.config.ts";

/** The viewer in JupyterLab. `PLANTIGRADE_JUPYTER` is a Python with JupyterLab and the package. */
export default defineConfig(shared, {
  testDir: ".",
  outputDir: "../../test-results/notebook",
  workers: 1,
  use: { viewport: { width: 1280, height: 1000 } },
});
