import AxeBuilder from "@axe-core/playwright";
import type { Page } from "@playwright/test";
import { type App, expect, test } from "./app";
import { bad, clip, file, good, sample } from "./clips";
import { storeRecord } from "./stored-records";
import { atEachSize, onPhones } from "./viewports";

/** States of the page, and functions that reach them. */
const states: Record<string, (app: App) => Promise<void>> = {
  "the start page": (app) => app.openStartPage(),
  "the Detect tab": (app) => app.openSample("bowling"),
  "the Evidence tab": async (app) => {
    await app.openSample("bowling");
    await app.tab("Evidence");
    // The plot may be drawn again, and lose the focus, while it becomes visible.
    await expect(async () => {
      await app.page.getByRole("slider", { name: "Sorted norms" }).press("ArrowRight");
      await expect(app.view.getByText(/^Frame \d+$/)).toBeVisible({ timeout: 2000 });
    }).toPass();
  },
  "the Evidence tab with thresholds": async (app) => {
    await app.openSample("bowling");
    await app.page.getByRole("combobox", { name: "Method" }).selectOption("dual");
    await app.tab("Evidence");
    await expect(app.panel).toContainText("thresholds");
  },
  "the Segment tab": async (app) => {
    await app.openSample("limp-to-run");
    await app.tab("Segment");
    await app.drop(file("reference.csv", "start_frame,end_frame,label\n0,300,walk\n300,744,run\n"));
    await expect(app.panel).toContainText("reference.csv");
    await app.page.getByRole("combobox", { name: "Method" }).selectOption("lsd");
    await app.panel.getByRole("button", { name: /^Loop segment 1/ }).click();
    await app.panel.getByRole("button", { name: "Save", exact: true }).click();
  },
  "the Labels tab": async (app) => {
    await app.openSample("bowling");
    await app.tab("Labels");
  },
  "the Score tab": async (app) => {
    await app.openSample("bowling");
    await app.drop(clip("samples/bowling.json"));
    await app.tab("Score");
  },
  "the Clip tab": async (app) => {
    await app.openSample("bowling");
    await app.tab("Clip");
  },
  "the list of keyboard shortcuts": async (app) => {
    await app.openSample("bowling");
    await app.page.keyboard.press("?");
    await expect(app.dialog).toBeVisible();
  },
  "the share dialog of a sample": async (app) => {
    await app.openSample("bowling");
    await app.openShareDialog();
  },
  "the share dialog of a file": async (app) => {
    await app.openFile(good("plain"));
    await app.openShareDialog();
  },
  "a toast about an invalid link": async (app) => {
    await app.page.goto(`${app.site.home}#sample=bowling&method=magic`);
    await app.waitForClip("bowling.bvh");
    await expect(app.toast).toContainText("magic");
  },
  "the list of notices": async (app) => {
    await app.openFile(good("breaks-off"));
    await app.head.getByRole("button", { name: /notice/ }).click();
    await expect(app.dialog).toBeVisible();
  },
  "an invalid file": async (app) => {
    await app.openFile(good("plain"));
    await app.drop(bad("not-a-number"));
    await expect(app.alert).toBeVisible();
  },
  "the batch table": async (app) => {
    await app.openStartPage();
    await app.drop(bad("ragged-row"), good("no-motion"), good("plain"));
    await expect(app.page.getByText(/^All processed/)).toBeVisible();
  },
  "a selected plant": async (app) => {
    await app.openSample("curved-walk");
    await app.tab("Labels");
    await app.page.keyboard.press("e");
    await app.page.keyboard.press("b");
  },
  "messages on the storage of edits": async (app) => {
    await app.page.goto(app.site.home);
    await storeRecord(app, sample("curved-walk"), "{");
    await app.openSample("curved-walk");
    await app.timeline.getByRole("button", { name: "Details" }).click();
    await expect(app.panel).toContainText("damaged and cannot be read");
  },
  "a detection that failed": async (app) => {
    await app.page.addInitScript(() => {
      const { postMessage } = Worker.prototype;
      Worker.prototype.postMessage = function (message: { path?: string[] }, ...rest: never[]) {
        if (message.path?.[0] === "detect") this.dispatchEvent(new ErrorEvent("error"));
        else postMessage.call(this, message, ...rest);
      };
    });
    await app.page.goto(`${app.site.home}#sample=bowling`);
    await expect(app.timeline.getByRole("button", { name: "Try again" })).toBeVisible();
  },
  "the notices of third-party software": async (app) => {
    await app.page.goto(`${app.site.home}third-party.html`);
  },
  "the legend and a selected plant": async (app) => {
    await app.openSample("bowling");
    await app.tab("Labels");
    await app.page.keyboard.press("e");
    await app.timeline.getByRole("button", { name: "Tracks" }).click();
  },
  "a selected cut": async (app) => {
    await app.openSample("limp-to-run");
    await app.tab("Segment");
    for (let i = 0; i < 9; i++) await app.page.keyboard.press("ArrowRight");
    await app.page.keyboard.press("x");
    await expect(app.panel.getByRole("spinbutton", { name: "Cut at frame" })).toHaveValue("9");
  },
  "a cleaned clip": async (app) => {
    await app.openSample("limp-to-run");
    await app.tab("Clip");
    await app.panel.getByRole("button", { name: "Fix foot skate" }).click();
    await expect(app.panel.getByRole("button", { name: "Discard" })).toBeVisible();
  },
  "a skeleton without motion": (app) => app.openFile(good("no-motion")),
};

for (const [name, reach] of Object.entries(states)) {
  test(`${name} is accessible`, async ({ app, page }) => {
    await reach(app);
    await expectAccessible(page);
  });
}

atEachSize(() => {
  test("the Labels tab is accessible", async ({ app, page }) => {
    await app.openSample("bowling");
    await page.getByRole("tab", { name: "Labels" }).click();
    await page.keyboard.press("e");
    await expectAccessible(page);
  });
});

onPhones(() => {
  test("the buttons for edits are accessible", async ({ app, page }) => {
    await app.openSample("bowling");
    await page.keyboard.press("e");
    await expect(app.page.getByRole("group", { name: "Edit", exact: true })).toBeVisible();
    await expectAccessible(page);
  });
});

/** Expects no violations in either theme. */
async function expectAccessible(page: Page) {
  for (const colorScheme of ["dark", "light"] as const) {
    await page.emulateMedia({ colorScheme });
    const { violations } = await new AxeBuilder({ page }).analyze();
    const found = violations.flatMap(({ id, nodes }) =>
      nodes.map(({ target, failureSummary }) => `${id}: ${target.join(" ")} ${failureSummary}`),
    );
    expect(found, `${colorScheme} theme`).toEqual([]);
  }
}

test("forced colours show borders, and what is pressed, selected and current", async ({
  app,
  page,
}) => {
  await page.emulateMedia({ forcedColors: "active" });
  await app.openSample("curved-walk");
  await app.tab("Labels");
  await page.keyboard.press("e");
  const selectedColours = await page.evaluate(() => {
    const probe = document.body.appendChild(document.createElement("i"));
    probe.style.cssText = "background: Highlight; color: HighlightText; forced-color-adjust: none";
    const { backgroundColor, color } = getComputedStyle(probe);
    probe.remove();
    return { backgroundColor, color };
  });
  const button = (name: string) => app.view.getByRole("button", { name });
  const plants = app.panel.getByRole("button", { name: /^\d+\s*(Left|Right)/ });
  for (const [active, other] of [
    [button("Follow"), button("Trails")],
    [page.getByRole("tab", { selected: true }), page.getByRole("tab", { selected: false }).first()],
    [plants.nth(0), plants.nth(1)],
    [plants.nth(0).locator(".confidence"), plants.nth(1).locator(".confidence")],
  ] as const) {
    await expect(active).toHaveCSS("color", selectedColours.color);
    await expect(other).not.toHaveCSS("color", selectedColours.color);
  }
  for (const active of [button("Follow"), page.getByRole("tab", { selected: true }), plants.nth(0)])
    await expect(active).toHaveCSS("background-color", selectedColours.backgroundColor);
  for (const bordered of [
    button("Trails"),
    app.panel.getByRole("button", { name: "Undo" }),
    app.panel.getByRole("button", { name: "Add plant" }),
    app.head.getByRole("button", { name: "Share" }),
  ]) {
    await expect(bordered).not.toHaveCSS("border-top-width", "0px");
  }
});
