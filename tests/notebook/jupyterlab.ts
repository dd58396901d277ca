/** A JupyterLab of its own, and its notebooks. */

import { type ChildProcess, spawn } from "node:child_process";
import { copyFileSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { createServer } from "node:net";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { expect, type FrameLocator, type Locator, type Page } from "@playwright/test";

const samples = join(import.meta.dirname, "../../samples");

export interface JupyterLab {
  /** Address with the token. */
  url: string;
  /** Folder of the notebooks, which has the clip `walk.bvh`. */
  folder: string;
  close(): Promise<void>;
}

/** Starts JupyterLab with settings of its own. */
export async function startJupyterLab(python: string): Promise<JupyterLab> {
  const place = mkdtempSync(join(tmpdir(), "jupyterlab-"));
  const [folder, config] = [join(place, "notebooks"), join(place, "config")];
  mkdirSync(folder);
  copyFileSync(join(samples, "curved-walk.bvh"), join(folder, "walk.bvh"));
  const settings = join(config, "lab/user-settings/@jupyterlab/apputils-extension");
  mkdirSync(settings, { recursive: true });
  // Otherwise it asks whether it may download news.
  const news = { fetchNews: "false", checkForUpdates: false, doNotDisturbMode: true };
  writeFileSync(join(settings, "notification.jupyterlab-settings"), JSON.stringify(news));
  const port = await freePort();
  const server = spawn(
    python,
    [
      ...["-m", "jupyterlab", "--no-browser", "--allow-root", `--port=${port}`],
      ...["--ServerApp.ip=127.0.0.1", "--IdentityProvider.token=test", `--notebook-dir=${folder}`],
    ],
    {
      stdio: ["ignore", "pipe", "pipe"],
      env: {
        ...process.env,
        JUPYTER_CONFIG_DIR: config,
        JUPYTER_DATA_DIR: join(place, "data"),
        JUPYTER_RUNTIME_DIR: join(place, "runtime"),
        IPYTHONDIR: join(place, "ipython"),
      },
    },
  );
  await started(server);
  return {
    url: `http://127.0.0.1:${port}`,
    folder,
    close: async () => {
      const closed = new Promise((resolve) => server.once("close", resolve));
      server.kill();
      await closed;
      rmSync(place, { recursive: true, force: true });
    },
  };
}

function freePort(): Promise<number> {
  return new Promise((resolve, reject) => {
    const server = createServer();
    server.on("error", reject);
    server.listen(0, "127.0.0.1", () => {
      const address = server.address();
      server.close(() => resolve(typeof address === "object" && address ? address.port : 0));
    });
  });
}

/** Resolves when the server reports that it runs. */
function started(server: ChildProcess): Promise<void> {
  return new Promise((resolve, reject) => {
    let output = "";
    const onData = (chunk: Buffer) => {
      output += chunk;
      if (/Jupyter Server .* is running at/.test(output)) resolve();
    };
    server.stdout?.on("data", onData);
    server.stderr?.on("data", onData);
    server.once("close", (code) => reject(new Error(`JupyterLab ended with ${code}:\n${output}`)));
  });
}

/** Writes a notebook of cells with code. Returns its name. */
export function writeNotebook({ folder }: JupyterLab, name: string, cells: readonly string[]) {
  const notebook = {
    cells: cells.map((source, i) => ({
      cell_type: "code",
      id: `cell-${i}`,
      execution_count: null,
      metadata: {},
      outputs: [],
      source,
    })),
    metadata: { kernelspec: { name: "python3", display_name: "Python 3", language: "python" } },
    nbformat: 4,
    nbformat_minor: 5,
  };
  writeFileSync(join(folder, name), JSON.stringify(notebook));
  return name;
}

/** A notebook that is open in JupyterLab. */
export class Notebook {
  constructor(readonly page: Page) {}

  async open({ url }: JupyterLab, name: string) {
    await this.page.goto(`${url}/lab/tree/${name}?token=test&reset`);
    await expect(this.cell(0)).toBeVisible({ timeout: 90_000 });
    // The kernel is ready for the first cell.
    await expect(this.page.locator("#jp-bottom-panel")).toContainText("| Idle", {
      timeout: 90_000,
    });
  }

  cell(index: number): Locator {
    return this.page.locator(".jp-Notebook .jp-CodeCell").nth(index);
  }

  output(index: number): Locator {
    return this.cell(index).locator(".jp-OutputArea-output").last();
  }

  /** Runs a cell, and waits until it has ended. */
  async run(index: number) {
    const prompt = this.cell(index).locator(".jp-InputPrompt");
    const before = await prompt.innerText();
    await this.cell(index).locator(".cm-content").click();
    await this.page.keyboard.press("Control+Enter");
    await expect(prompt).not.toHaveText(before);
    await expect(prompt).toHaveText(/^\[\d+\]:$/, { timeout: 60_000 });
  }
}

/** The viewer in the output of a cell. */
export class NotebookViewer {
  readonly element: Locator;
  readonly frame: FrameLocator;
  readonly playhead: Locator;
  readonly plants: Locator;

  constructor(output: Locator) {
    this.element = output.locator("iframe");
    this.frame = output.frameLocator("iframe");
    this.playhead = this.frame.getByRole("slider", { name: "Playhead" });
    this.plants = this.frame.getByRole("table").filter({ hasText: "Plant" }).first();
  }

  /** Waits until the clip is open and its figure is drawn. */
  async ready() {
    await expect(this.frame.locator("[data-state=ready][data-clip=open]")).toBeVisible({
      timeout: 60_000,
    });
    await expect(this.playhead).toBeVisible();
    await expect(this.frame.locator(".stage canvas")).toBeVisible();
  }
}
