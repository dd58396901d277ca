/** The viewer of the Python package in JupyterLab. */

import { expect, test } from "@playwright/test";
import {
  type JupyterLab,
  Notebook,
  NotebookViewer,
  startJupyterLab,
  writeNotebook,
} from "./jupyterlab";

const python = process.env.PLANTIGRADE_JUPYTER ?? "";
let lab: JupyterLab;

test.beforeAll(async () => {
  lab = await startJupyterLab(python);
});

test.afterAll(() => lab.close());

const show = `import plantigrade
viewer = plantigrade.detect("walk.bvh").show()
viewer`;
const count = `print(viewer.detection.contact.sum(), len(viewer.detection.intervals))`;

test("edits in the viewer change the arrays of the next cell, and the reverse", async ({
  page,
}) => {
  const problems: string[] = [];
  page.on("pageerror", (error) => problems.push(error.message));
  page.on("request", (request) => {
    const { protocol, origin } = new URL(request.url());
    const isLocal = origin === lab.url || ["blob:", "data:", "about:"].includes(protocol);
    if (!isLocal) problems.push(`request to elsewhere: ${request.url()}`);
  });
  const notebook = new Notebook(page);
  const cells = [
    show,
    count,
    "viewer.detection = plantigrade.detect('walk.bvh').edit([('left', 'contact', 0, 245, True)])",
    "viewer.detection.method, viewer.detection.contact.shape",
  ];
  await notebook.open(lab, writeNotebook(lab, "widget.ipynb", cells));
  await notebook.run(0);
  const viewer = new NotebookViewer(notebook.output(0));
  await viewer.ready();
  await notebook.run(1);
  const before = await notebook.output(1).innerText();

  // It plays.
  await viewer.frame.getByRole("button", { name: "Play", exact: true }).click();
  await expect
    .poll(async () => Number(await viewer.playhead.getAttribute("aria-valuenow")))
    .toBeGreaterThan(20);
  await viewer.frame.getByRole("button", { name: "Pause" }).click();

  // A removed plant is removed from the array.
  await viewer.playhead.focus();
  await page.keyboard.press("Home");
  await page.keyboard.press("Shift+ArrowRight");
  await page.keyboard.press("e");
  await page.keyboard.press("Delete");
  await expect(viewer.frame.getByRole("button", { name: "edited" })).toBeVisible();
  await notebook.run(1);
  const after = await notebook.output(1).innerText();
  expect(Number.parseInt(after, 10)).toBeLessThan(Number.parseInt(before, 10));

  // What is undone in the viewer is undone in the array.
  await viewer.playhead.focus();
  await page.keyboard.press("Control+z");
  await notebook.run(1);
  await expect(notebook.output(1)).toHaveText(before);

  // An assigned detection is shown.
  await notebook.run(2);
  const edited = viewer.plants.getByRole("row", { name: /left, edited/ });
  await expect(edited).toHaveCount(1);

  // A notebook that moves the output loads the page again, which has the edits.
  await viewer.element.evaluate((frame: HTMLIFrameElement) => {
    frame.srcdoc = `${frame.srcdoc} `;
  });
  await viewer.ready();
  await expect(edited).toHaveCount(1);

  // A method that is chosen in the viewer is that of the detection.
  await viewer.frame.getByRole("button", { name: "Panel" }).click();
  await viewer.frame.getByRole("combobox", { name: "Method" }).selectOption("height-speed");
  await notebook.run(3);
  await expect(notebook.output(3)).toContainText("height-speed");
  expect(problems).toEqual([]);
});

test("a static viewer shows the clip without a widget", async ({ page }) => {
  const notebook = new Notebook(page);
  const cells = ["import plantigrade\nplantigrade.detect('walk.bvh').show(static=True)"];
  await notebook.open(lab, writeNotebook(lab, "static.ipynb", cells));
  await notebook.run(0);
  const viewer = new NotebookViewer(notebook.output(0));
  await viewer.ready();
  await expect(viewer.plants.getByRole("row")).toHaveCount(6);
});
