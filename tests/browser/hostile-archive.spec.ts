/** Archives with unsafe names, wrong checksums and sizes, and damaged or encrypted entries. */

import { strToU8, unzipSync, zipSync } from "fflate";
import { type App, expect, test } from "./app";
import { file, good, type Payload, sample } from "./clips";

const signature = { local: 0x04034b50, central: 0x02014b50 };

function zip(files: Record<string, Payload>): Buffer {
  const entries = Object.entries(files).map(([name, { buffer }]) => [name, new Uint8Array(buffer)]);
  return Buffer.from(zipSync(Object.fromEntries(entries)));
}

/** Changes the records of an entry: the local header and that of the list of files. */
function patch(
  archive: Buffer,
  name: string,
  write: (record: Buffer, isLocal: boolean) => void,
): Buffer {
  const copy = Buffer.from(archive);
  for (let at = 0; at + 4 <= copy.length; at++) {
    const kind = copy.readUInt32LE(at);
    const nameAt = { [signature.local]: 30, [signature.central]: 46 }[kind];
    if (
      nameAt &&
      copy
        .subarray(at + nameAt)
        .toString("latin1")
        .startsWith(name)
    ) {
      write(copy.subarray(at), kind === signature.local);
    }
  }
  return copy;
}

const drop = (app: App, buffer: Buffer) =>
  app.drop({ name: "hostile.zip", mimeType: "application/zip", buffer });

const processed = (app: App) => expect(app.page.getByText(/^All processed/)).toBeVisible();

const wrongChecksum = (archive: Buffer, name: string) =>
  patch(archive, name, (record, isLocal) => record.writeUInt32LE(0x12345678, isLocal ? 14 : 16));

test("saves names that are safe on every system", async ({ app, page }) => {
  await app.openStartPage();
  const unsafe = [
    "../../etc/passwd.bvh",
    "..\\..\\win.bvh",
    "C:\\Users\\Public\\walk.bvh",
    "CON.bvh",
    "nul.bvh",
    "COM1.bvh",
    "line\nbreak\u001b[31m.bvh",
    "evil\u202efdp.bvh",
    "a:b|c?.bvh",
    "dots. . .bvh",
    "WALK.bvh",
    "\u0065\u0301.bvh",
    "\u00e9.bvh",
  ];
  await drop(app, zip(Object.fromEntries(unsafe.map((name) => [name, good("plain")]))));
  await processed(app);
  const saved = await app.download(() => page.getByRole("button", { name: /^Save all/ }).click());
  const names = Object.keys(unzipSync(saved.bytes));
  expect(names.length).toBeGreaterThan(unsafe.length);
  for (const name of names) {
    expect(name).not.toMatch(/[\p{Cc}\p{Cf}<>:"/\\|?*]|^\.+$|[. ]$/u);
    expect(name).not.toMatch(/^(con|prn|aux|nul|com\d|lpt\d)\s*(\.|$)/i);
  }
  const folded = names.map((name) => name.normalize("NFC").toLowerCase());
  expect(new Set(folded).size).toBe(names.length);
  // The table shows names without folders.
  await expect(page.getByRole("button", { name: "win.bvh", exact: true })).toBeVisible();
});

test("saves single files under safe names", async ({ app }) => {
  await app.openStartPage();
  await app.drop({ ...sample("curved-walk"), name: "CON.bvh" });
  await app.waitForClip("CON.bvh");
  expect((await app.save("Labels")).name).toBe("_CON.plants.json");
});

test("names the file whose checksum does not agree", async ({ app, page }) => {
  await app.openStartPage();
  const archive = zip({ "walks/curved.bvh": sample("curved-walk") });
  await drop(app, wrongChecksum(archive, "walks/curved.bvh"));
  await app.waitForClip("curved.bvh");
  await app.head.getByRole("button", { name: /notices?$/ }).click();
  await expect(app.dialog).toContainText(
    "The archive states another checksum for walks/curved.bvh",
  );
  await page.keyboard.press("Escape");
  // The archive without the fault has no such notice.
  await drop(app, archive);
  await app.waitForClip("curved.bvh");
  await expect(app.head.getByRole("button", { name: /notices?$/ })).toBeHidden();
});

test("counts notices of the archive in the table", async ({ app, page }) => {
  await app.openStartPage();
  const archive = zip({ "a.bvh": sample("curved-walk"), "b.bvh": sample("curved-walk") });
  await drop(app, wrongChecksum(archive, "b.bvh"));
  await processed(app);
  const notices = (name: string) =>
    page
      .getByRole("row", { name: new RegExp(name) })
      .getByRole("cell")
      .nth(3);
  await expect(notices("a\\.bvh")).toHaveText("0");
  await expect(notices("b\\.bvh")).toHaveText("1");
});

test("shows a notice on labels whose checksum does not agree", async ({ app }) => {
  await app.openStartPage();
  const labels = file("walk.json", JSON.stringify({ left: [1], right: [1] }));
  const archive = zip({ "walk.bvh": sample("curved-walk"), "walk.json": labels });
  await drop(app, wrongChecksum(archive, "walk.json"));
  await expect(app.toast).toContainText("another checksum for walk.json");
});

test("opens the other files if some cannot be unpacked", async ({ app, page }) => {
  await app.openStartPage();
  let archive = zip({
    "good.bvh": sample("curved-walk"),
    "encrypted.bvh": good("plain"),
    "method.bvh": good("plain"),
    "damaged.bvh": good("plain"),
    "outside.bvh": good("plain"),
  });
  archive = patch(archive, "encrypted.bvh", (record, isLocal) => {
    record.writeUInt16LE(1, isLocal ? 6 : 8);
  });
  archive = patch(archive, "method.bvh", (record, isLocal) => {
    record.writeUInt16LE(99, isLocal ? 8 : 10);
  });
  archive = patch(archive, "damaged.bvh", (record, isLocal) => {
    if (isLocal) record.fill(0xff, 30 + "damaged.bvh".length, 60 + "damaged.bvh".length);
  });
  archive = patch(archive, "outside.bvh", (record, isLocal) => {
    if (!isLocal) record.writeUInt32LE(0x7fffffff, 42);
  });
  await drop(app, archive);
  await processed(app);
  const row = (name: string) => page.getByRole("row", { name: new RegExp(`^${name}`) });
  await expect(row("encrypted.bvh")).toContainText("it is encrypted");
  await expect(row("method.bvh")).toContainText("method 99");
  await expect(row("damaged.bvh")).toContainText("cannot be unpacked");
  await expect(row("outside.bvh")).toContainText("incomplete");
  await row("good.bvh").getByRole("button", { name: "good.bvh", exact: true }).click();
  await app.waitForClip("good.bvh");
});

test("refuses archives whose content exceeds the limits, whatever they state", async ({ app }) => {
  await app.openSample("curved-walk");
  const bomb = zip({ "bomb.bvh": { name: "", mimeType: "", buffer: Buffer.alloc(300 * 2 ** 20) } });
  const stated = (size: number) =>
    patch(bomb, "bomb.bvh", (record, isLocal) => record.writeUInt32LE(size, isLocal ? 22 : 24));
  for (const buffer of [bomb, stated(10), stated(0xfffffff0)]) {
    await drop(app, buffer);
    await expect(app.alert).toContainText("hostile.zip could not be opened");
    await expect(app.alert).toContainText(/unpacks to more than (256|1024) MiB \(at bomb.bvh\)/);
    await app.alert.getByRole("button", { name: "Dismiss" }).click();
  }
  const many = Object.fromEntries(
    Array.from({ length: 5001 }, (_, i) => [`${i}.bvh`, strToU8("x")]),
  );
  await drop(app, Buffer.from(zipSync(many)));
  await expect(app.alert).toContainText("more than 5000 clips");
  await expect(app.alert).toContainText("curved-walk.bvh is still open");
});
