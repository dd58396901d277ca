import { beforeEach, expect, it } from "vitest";
import {
  blockText,
  decodeBlock,
  encodeBlock,
  fillBlocks,
  jsonText,
  titleText,
} from "./player-html";

const page = `<!doctype html><title>Plantigrade</title><div id="app"></div>
<script type="text/plain" id="enclosed"></script>
<script type="text/plain" id="clip"></script>
<script type="text/plain" id="core"></script>
<script type="module">const mark = ' id="clip">'; // </title> <title></script>`;

const nasty = [
  "</script><img src=x onerror=alert(1)>",
  "</SCRIPT ><script>alert(1)</script>",
  "<!-- <script>",
  "]]>&lt;/script&gt;",
  "</title><svg onload=alert(1)>",
  "\u2028\u2029\0$& $1 $` \\u003c/script>",
  '"); alert("',
  "läufer 走る 🦶",
];

beforeEach(() => {
  document.documentElement.innerHTML = "";
});

it("fills the blocks of a page and leaves the rest as it is", () => {
  const filled = fillBlocks(page, { clip: "abc", title: "walk" }).join("");
  expect(filled).toBe(page.replace("Plantigrade", "walk").replace(/(id="clip">)(?=<)/, "$1abc"));
  // What was filled can be filled anew: a shared page is shared again.
  expect(fillBlocks(filled, { clip: "", title: "Plantigrade" }).join("")).toBe(page);
});

it("gives no name a way out of its block", () => {
  for (const name of nasty) {
    const filled = fillBlocks(page, {
      title: titleText(name),
      enclosed: jsonText({ name, names: [{ name }] }),
    }).join("");
    const parsed = new DOMParser().parseFromString(filled, "text/html");
    expect(parsed.querySelectorAll("script")).toHaveLength(4);
    expect(parsed.querySelector("img, svg")).toBeNull();
    const held = parsed.getElementById("enclosed")?.textContent ?? "";
    expect(JSON.parse(held)).toEqual({ name, names: [{ name }] });
  }
});

it("puts nothing into a block that could end it", () => {
  expect(() => fillBlocks(page, { clip: "a</script>" })).toThrow("end too early");
  expect(() => fillBlocks("<p>", { clip: "abc" })).toThrow("no room");
});

it("decodes what it encodes", async () => {
  const bytes = Uint8Array.from({ length: 1_000_000 }, (_, i) => (i * i * i) % 65_521);
  const shares: number[] = [];
  const onProgress = (share: number) => shares.push(share);
  const made = await (await encodeBlock(new Blob([bytes]), { onProgress })).text();
  expect(shares.at(-1)).toBe(1);
  expect(made).toMatch(/^[A-Za-z0-9+/]+=*$/);
  document.body.innerHTML = `<script type="text/plain" id="clip">${made}</script>`;
  expect(blockText("clip")).toBe(made);
  const decoded = Buffer.from(await (await decodeBlock("clip")).arrayBuffer());
  // Not `toEqual`, which takes seconds for a million elements.
  expect(decoded.equals(bytes)).toBe(true);
});

it("stops encoding when it is aborted", async () => {
  const stop = new AbortController();
  const made = encodeBlock(new Blob([new Uint8Array(1e6)]), {
    signal: stop.signal,
    onProgress: () => stop.abort(),
  });
  await expect(made).rejects.toMatchObject({ name: "AbortError" });
});
