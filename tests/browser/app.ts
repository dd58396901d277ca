/** The page as a test uses it. A test fails on anything the browser complains of meanwhile. */

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

export interface Saved {
  name: string;
  text: string;
  bytes: Uint8Array;
}

/** A segment as it is listed; times in seconds. */
export interface Listed {
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
  readonly remark: Locator;
  private readonly problems: string[] = [];
  // How a browser without a graphics card takes the picture from WebGL: its own note on itself.
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
    this.remark = page.locator(".toast");
    this.watch();
  }

  private watch() {
    const { page, site, problems } = this;
    const where = (message: ConsoleMessage) => message.location().url;
    page.on("console", (message) => {
      if (!/^(error|warning)$/.test(message.type())) return;
      problems.push(`console ${message.type()}: ${message.text()} (${where(message)})`);
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

  /** Says of a complaint of the browser that this test provokes it. */
  provokes(complaint: RegExp) {
    this.expected.push(complaint);
  }

  /** What the browser complained of and nobody expected. */
  complaints(): string[] {
    return this.problems.filter((problem) => !this.expected.some((known) => known.test(problem)));
  }

  /** Opens the page without a clip. */
  async empty() {
    await this.page.goto(this.site.home);
    await expect(this.state).toHaveAttribute("data-state", "empty");
    // By then the page listens: a person is not faster, and comes with a pointer.
    await this.page.mouse.move(2, 2);
    await expect(this.stage.locator("canvas")).toBeVisible();
  }

  /** Opens the page with a sample. */
  async sample(name: string) {
    await this.page.goto(`${this.site.home}#sample=${name}`);
    await this.opened(`${name}.bvh`);
  }

  /** Opens the page and drops a file on it. */
  async with(file: Payload) {
    await this.empty();
    await this.drop(file);
    await this.opened(file.name);
  }

  /** Waits until a clip is open and labelled. */
  async opened(name: string) {
    await expect(this.page).toHaveTitle(`${name} – Plantigrade`);
    await expect(this.state).toHaveAttribute("data-state", "ready");
    await expect(this.playhead.or(this.timeline.getByText("no motion"))).toBeVisible();
  }

  /** Files as the page gets them from a drag or the clipboard. */
  transfer(...files: Payload[]): Promise<JSHandle<DataTransfer>> {
    const sent = files.map(({ name, buffer }) => ({ name, data: buffer.toString("base64") }));
    return this.page.evaluateHandle((list) => {
      const transfer = new DataTransfer();
      for (const { name, data } of list) {
        const bytes = Uint8Array.from(atob(data), (char) => char.charCodeAt(0));
        transfer.items.add(new File([bytes], name));
      }
      return transfer;
    }, sent);
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

  /** The frame under the playhead. */
  async frame(): Promise<number> {
    return Number(await this.playhead.getAttribute("aria-valuenow"));
  }

  async lastFrame(): Promise<number> {
    return Number(await this.playhead.getAttribute("aria-valuemax"));
  }

  /** A point on the ruler of the timeline: 0 is the left edge of the canvas, 1 the right one. */
  async ruler(share: number): Promise<{ x: number; y: number }> {
    const box = await this.tracks.boundingBox();
    if (!box) throw new Error("The timeline has no canvas.");
    return { x: box.x + share * box.width, y: box.y + 12 };
  }

  /** Presses on the ruler; gives back the frame that shows. */
  async pressRuler(share: number): Promise<number> {
    const { x, y } = await this.ruler(share);
    await this.page.mouse.click(x, y);
    return this.frame();
  }

  async tab(name: Tab) {
    const tab = this.page.getByRole("tab", { name });
    if ((await tab.getAttribute("aria-selected")) !== "true") await tab.click();
    await expect(this.page.getByRole("tabpanel", { name })).toBeVisible();
  }

  /** A fact of the Clip tab by its name. */
  fact(name: string): Locator {
    return this.panel
      .getByRole("term")
      .filter({ hasText: new RegExp(`^${name}$`) })
      .locator("xpath=following-sibling::dd[1]");
  }

  /** What the Detect tab says of a foot: the share of frames planted and the number of plants. */
  async result(foot: "Left" | "Right"): Promise<{ share: number; plants: number }> {
    await this.tab("Detect");
    const text = this.fact(foot);
    await expect(this.panel.locator(".detect-result")).toHaveAttribute("aria-busy", "false");
    await expect(text).toHaveText(/\d+ % planted\s*\d+ plants?/);
    const [share = Number.NaN, plants = Number.NaN] =
      (await text.innerText()).match(/\d+/g)?.map(Number) ?? [];
    return { share, plants };
  }

  /** The segments that the Segment tab lists, as far as they are in sight. */
  async segments(): Promise<Listed[]> {
    await this.tab("Segment");
    const rows = this.panel.getByRole("listitem").filter({ has: this.page.getByRole("textbox") });
    await expect(rows.first()).toBeVisible();
    const found: Listed[] = [];
    for (const row of await rows.all()) {
      const label = (await row.getByRole("button").getAttribute("aria-label")) ?? "";
      const [number = 0, start = 0, length = 0] = (label.match(/[\d.]+/g) ?? []).map(Number);
      found.push({ number, start, length, name: await row.getByRole("textbox").inputValue() });
    }
    return found;
  }

  /** Shows what the list of the panel can be saved as. */
  private async unfoldSave() {
    const save = this.panel.getByRole("button", { name: "Save", exact: true });
    if ((await save.getAttribute("aria-expanded")) !== "true") await save.click();
  }

  /** Saves by a button of the Segment tab. */
  async saveSegments(button: "Segments" | "Table" | "BABEL" | "Clips"): Promise<Saved> {
    await this.tab("Segment");
    await this.unfoldSave();
    return this.download(() =>
      this.panel.getByRole("button", { name: new RegExp(`^${button}`) }).click(),
    );
  }

  /** What the page hands over as a download when something is done. */
  async download(act: () => Promise<void>): Promise<Saved> {
    const coming = this.page.waitForEvent("download");
    await act();
    const download = await coming;
    const bytes = readFileSync(await download.path());
    return { name: download.suggestedFilename(), text: bytes.toString("utf8"), bytes };
  }

  /** Opens the dialog that passes the clip on. */
  async share() {
    await this.head.getByRole("button", { name: "Share" }).click();
    await expect(this.dialog).toBeVisible();
  }

  /** The link to what is on show. */
  async link(): Promise<string> {
    await this.share();
    const link = await this.dialog.getByRole("textbox", { name: "Link" }).inputValue();
    await this.page.keyboard.press("Escape");
    return link;
  }

  /** The page in one file. */
  async sharePage(): Promise<Saved> {
    await this.share();
    const saved = await this.download(() =>
      this.dialog.getByRole("button", { name: "Save page" }).click(),
    );
    await this.page.keyboard.press("Escape");
    return saved;
  }

  /** Saves by a button of the Labels tab. */
  async save(
    button: "Labels" | "Frames" | "Intervals" | "Gait events" | "Arrays" | "Blender",
  ): Promise<Saved> {
    await this.tab("Labels");
    await this.unfoldSave();
    return this.download(() =>
      this.panel.getByRole("button", { name: new RegExp(`^${button}`) }).click(),
    );
  }
}

interface Given {
  app: App;
  /** The person has not seen the page before: there is a tour. */
  isNew: boolean;
}

export const test = base.extend<Given, { site: Site }>({
  isNew: [false, { option: true }],
  site: [
    // biome-ignore lint/correctness/noEmptyPattern: a fixture names what it needs by a pattern
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
          // A page without an address keeps nothing.
        }
      });
    }
    const app = new App(page, site);
    await use(app);
    expect(app.complaints(), "The browser has nothing to complain of").toEqual([]);
  },
});
