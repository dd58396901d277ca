/** Page object of the app. A test fails on unexpected messages and requests of the browser. */

import { readFileSync } from "node:fs";
import {
  test as base,
  type ConsoleMessage,
  expect,
  type JSHandle,
  type Locator,
  type Page,
} from "@playwright/test";
import type { Payload } from "./clips";
import { type Site, serve } from "./serve";

export { expect };

export interface SavedFile {
  name: string;
  text: string;
  bytes: Uint8Array;
}

/** A segment in the list; times in seconds. */
export interface ListedSegment {
  number: number;
  start: number;
  length: number;
  name: string;
}

export type Tab = "Detect" | "Evidence" | "Segment" | "Labels" | "Score" | "Clip";

export class App {
  readonly state: Locator;
  readonly head: Locator;
  readonly view: Locator;
  readonly stage: Locator;
  readonly timeline: Locator;
  readonly tracks: Locator;
  readonly playhead: Locator;
  readonly panel: Locator;
  readonly alert: Locator;
  readonly dialog: Locator;
  readonly toast: Locator;
  private readonly problems: string[] = [];
  // Messages of a browser that renders WebGL in software, and of Playwright.
  private readonly expected = [
    /GL Driver Message \(OpenGL, Performance,/,
    /Service Worker registration blocked by Playwright/,
  ];

  constructor(
    readonly page: Page,
    readonly site: Site,
  ) {
    this.state = page.locator("[data-state]");
    this.head = page.getByRole("banner");
    this.view = page.getByRole("region", { name: "View" });
    this.stage = this.view.getByRole("img");
    this.timeline = page.getByRole("region", { name: "Timeline" });
    this.tracks = this.timeline.locator("canvas");
    this.playhead = this.timeline.getByRole("slider", { name: "Playhead" });
    this.panel = page.getByRole("tabpanel");
    this.alert = page.getByRole("alert");
    this.dialog = page.getByRole("dialog");
    this.toast = page.locator(".toast");
    this.watch();
  }

  private watch() {
    const { page, site, problems } = this;
    const urlOf = (message: ConsoleMessage) => message.location().url;
    page.on("console", (message) => {
      if (!/^(error|warning)$/.test(message.type())) return;
      problems.push(`console ${message.type()}: ${message.text()} (${urlOf(message)})`);
    });
    page.on("pageerror", (error) => problems.push(`uncaught: ${error.stack ?? error.message}`));
    page.on("requestfailed", (request) => {
      problems.push(`failed request: ${request.url()} ${request.failure()?.errorText ?? ""}`);
    });
    page.on("request", (request) => {
      const { protocol, origin } = new URL(request.url());
      if (origin === site.origin || protocol === "blob:" || protocol === "data:") return;
      problems.push(`request to elsewhere: ${request.url()}`);
    });
  }

  /** Accepts a problem that this test causes on purpose. */
  expectProblem(problem: RegExp) {
    this.expected.push(problem);
  }

  /** Returns the problems that no test expects. */
  unexpectedProblems(): string[] {
    return this.problems.filter(
      (problem) => !this.expected.some((pattern) => pattern.test(problem)),
    );
  }

  /** Opens the start page. */
  async openStartPage() {
    await this.page.goto(this.site.home);
    await expect(this.state).toHaveAttribute("data-state", "empty");
    // Starts the preview; the page has registered its event handlers by then.
    await this.page.mouse.move(2, 2);
    await expect(this.stage.locator("canvas")).toBeVisible();
  }

  /** Opens the page with a sample. */
  async openSample(name: string) {
    await this.page.goto(`${this.site.home}#sample=${name}`);
    await this.waitForClip(`${name}.bvh`);
  }

  /** Opens the page and drops a file on it. */
  async openFile(file: Payload) {
    await this.openStartPage();
    await this.drop(file);
    await this.waitForClip(file.name);
  }

  /** Waits until a clip is open and processed. */
  async waitForClip(name: string) {
    await expect(this.page).toHaveTitle(`${name} – Plantigrade`);
    await expect(this.state).toHaveAttribute("data-state", "ready");
    await expect(this.playhead.or(this.timeline.getByText("no motion"))).toBeVisible();
  }

  /** Creates the data transfer of a drop or a paste. */
  transfer(...files: Payload[]): Promise<JSHandle<DataTransfer>> {
    const encoded = files.map(({ name, buffer }) => ({ name, data: buffer.toString("base64") }));
    return this.page.evaluateHandle((list) => {
      const transfer = new DataTransfer();
      for (const { name, data } of list) {
        const bytes = Uint8Array.from(atob(data), (char) => char.charCodeAt(0));
        transfer.items.add(new File([bytes], name));
      }
      return transfer;
    }, encoded);
  }

  async drop(...files: Payload[]) {
    const dataTransfer = await this.transfer(...files);
    await this.page.getByRole("main").dispatchEvent("drop", { dataTransfer });
  }

  async paste(...files: Payload[]) {
    await this.page.evaluate(
      (clipboardData) =>
        document.body.dispatchEvent(
          new ClipboardEvent("paste", { clipboardData, bubbles: true, cancelable: true }),
        ),
      await this.transfer(...files),
    );
  }

  /** Waits until the page has drawn a number of animation frames. */
  async animationFrames(count: number) {
    await this.page.evaluate(async (frames) => {
      for (let i = 0; i < frames; i++) await new Promise(requestAnimationFrame);
    }, count);
  }

  /** Returns a screenshot of the 3D view, as text so that failures are short. */
  async picture(): Promise<string> {
    return (await this.stage.screenshot()).toString("base64");
  }

  /** Returns a screenshot of the 3D view once it no longer changes. */
  async stillPicture(): Promise<string> {
    let before = "";
    await expect
      .poll(async () => {
        const last = before;
        before = await this.picture();
        return before === last;
      })
      .toBe(true);
    return before;
  }

  /** Returns the frame under the playhead. */
  async frame(): Promise<number> {
    return Number(await this.playhead.getAttribute("aria-valuenow"));
  }

  async lastFrame(): Promise<number> {
    return Number(await this.playhead.getAttribute("aria-valuemax"));
  }

  /** Returns a point on the ruler of the timeline: 0 is the left edge, 1 the right edge. */
  async ruler(position: number): Promise<{ x: number; y: number }> {
    const box = await this.tracks.boundingBox();
    if (!box) throw new Error("The timeline has no canvas.");
    return { x: box.x + position * box.width, y: box.y + 12 };
  }

  /** Clicks the ruler. Returns the frame under the playhead. */
  async pressRuler(position: number): Promise<number> {
    const { x, y } = await this.ruler(position);
    await this.page.mouse.click(x, y);
    return this.frame();
  }

  /** Shows a tab; on a phone, also raises the sheet. */
  async tab(name: Tab) {
    const panel = this.page.getByRole("tabpanel", { name });
    if (!(await panel.isVisible())) await this.page.getByRole("tab", { name }).click();
    await expect(panel).toBeVisible();
  }

  /** Returns the value of a property in the panel. */
  fact(name: string): Locator {
    return this.panel
      .getByRole("term")
      .filter({ hasText: new RegExp(`^${name}$`) })
      .locator("xpath=following-sibling::dd[1]");
  }

  /** Returns the result in the Detect tab: percentage of planted frames, and number of plants. */
  async result(foot: "Left" | "Right"): Promise<{ percent: number; plants: number }> {
    await this.tab("Detect");
    const text = this.fact(foot);
    await expect(this.panel.locator(".detect-result")).toHaveAttribute("aria-busy", "false");
    await expect(text).toHaveText(/\d+ % planted\s*\d+ plants?/);
    const [percent = Number.NaN, plants = Number.NaN] =
      (await text.innerText()).match(/\d+/g)?.map(Number) ?? [];
    return { percent, plants };
  }

  /** Returns the visible rows of the Segment tab. */
  async segments(): Promise<ListedSegment[]> {
    await this.tab("Segment");
    const rows = this.panel.getByRole("listitem").filter({ has: this.page.getByRole("textbox") });
    await expect(rows.first()).toBeVisible();
    // Read at once, since edits replace the rows.
    const texts = await rows.evaluateAll((items) =>
      items.map((item) => ({
        label: item.querySelector("button")?.getAttribute("aria-label") ?? "",
        name: item.querySelector("input")?.value ?? "",
      })),
    );
    const segments = texts.map(({ label, name }) => {
      const [number = 0, start = 0, length = 0] = (label.match(/[\d.]+/g) ?? []).map(Number);
      return { number, start, length, name };
    });
    return segments;
  }

  /** Expands the save buttons of the list in the panel. */
  private async expandSaveMenu() {
    const save = this.panel.getByRole("button", { name: "Save", exact: true });
    if ((await save.getAttribute("aria-expanded")) !== "true") await save.click();
  }

  /** Saves segments by a button of the Segment tab. */
  async saveSegments(
    button: "Segments" | "Table" | "BABEL" | "Audacity" | "ELAN" | "Clips",
  ): Promise<SavedFile> {
    await this.tab("Segment");
    await this.expandSaveMenu();
    return this.download(() =>
      this.panel.getByRole("button", { name: new RegExp(`^${button}`) }).click(),
    );
  }

  /** Saves the gait by a button of the Clip tab. */
  async saveGait(button: "Report" | "Steps" | "Joint angles"): Promise<SavedFile> {
    await this.tab("Clip");
    await this.expandSaveMenu();
    return this.download(() =>
      this.panel.getByRole("button", { name: new RegExp(`^${button} (CSV|HTML)`) }).click(),
    );
  }

  /** Returns the file that the page downloads after an action. */
  async download(action: () => Promise<void>): Promise<SavedFile> {
    const downloading = this.page.waitForEvent("download");
    await action();
    const download = await downloading;
    const bytes = readFileSync(await download.path());
    return { name: download.suggestedFilename(), text: bytes.toString("utf8"), bytes };
  }

  /** Opens the share dialog. */
  async openShareDialog() {
    await this.head.getByRole("button", { name: "Share" }).click();
    await expect(this.dialog).toBeVisible();
  }

  /** Returns the link to the current view. */
  async link(): Promise<string> {
    await this.openShareDialog();
    const link = await this.dialog.getByRole("textbox", { name: "Link" }).inputValue();
    await this.page.keyboard.press("Escape");
    return link;
  }

  /** Saves the clip as a single-file page. */
  async savePage(): Promise<SavedFile> {
    await this.openShareDialog();
    const saved = await this.download(() =>
      this.dialog.getByRole("button", { name: "Save page" }).click(),
    );
    await this.page.keyboard.press("Escape");
    return saved;
  }

  /** Saves labels by a button of the Labels tab. */
  async save(
    button:
      | "Labels"
      | "Every frame"
      | "Every plant"
      | "Gait events"
      | "Heel and toe events"
      | "Arrays"
      | "Blender",
  ): Promise<SavedFile> {
    await this.tab("Labels");
    await this.expandSaveMenu();
    return this.download(() =>
      this.panel.getByRole("button", { name: new RegExp(`^${button}`) }).click(),
    );
  }
}

interface Fixtures {
  app: App;
  /** True if the user is new and gets the tour. */
  isNew: boolean;
}

export const test = base.extend<Fixtures, { site: Site }>({
  isNew: [false, { option: true }],
  site: [
    // biome-ignore lint/correctness/noEmptyPattern: Playwright requires a destructuring pattern
    async ({}, use) => {
      const site = await serve();
      await use(site);
      await site.close();
    },
    { scope: "worker" },
  ],
  app: async ({ page, site, isNew }, use) => {
    if (!isNew) {
      await page.addInitScript(() => {
        try {
          localStorage.setItem("plantigrade:tour", "done");
        } catch {
          // Pages without an origin have no storage.
        }
      });
    }
    const app = new App(page, site);
    await use(app);
    expect(app.unexpectedProblems(), "unexpected problems in the browser").toEqual([]);
  },
});
