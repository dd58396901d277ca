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
<script type="text/plain" id="second"></script>
<script type="module">const fake = ' id="clip">'; // </title> <title></script>`;

const hostileNames = [
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

it("replaces the content of blocks only", () => {
  const filled = fillBlocks(page, { clip: "abc", title: "walk" }).join("");
  expect(filled).toBe(page.replace("Plantigrade", "walk").replace(/(id="clip">)(?=<)/, "$1abc"));
  // A shared page can be shared again.
  expect(fillBlocks(filled, { clip: "", title: "Plantigrade" }).join("")).toBe(page);
});

it("escapes names that contain HTML", () => {
  for (const name of hostileNames) {
    const filled = fillBlocks(page, {
      title: titleText(name),
      enclosed: jsonText({ name, names: [{ name }] }),
    }).join("");
    const parsed = new DOMParser().parseFromString(filled, "text/html");
    expect(parsed.querySelectorAll("script")).toHaveLength(5);
    expect(parsed.querySelector("img, svg")).toBeNull();
    const text = parsed.getElementById("enclosed")?.textContent ?? "";
    expect(JSON.parse(text)).toEqual({ name, names: [{ name }] });
  }
});

it("rejects content that could end a block, and missing blocks", () => {
  expect(() => fillBlocks(page, { clip: "a</script>" })).toThrow("must not contain");
  expect(() => fillBlocks("<p>", { clip: "abc" })).toThrow("no block");
});

it("decodes what it encodes", async () => {
  const bytes = Uint8Array.from({ length: 1_000_000 }, (_, i) => (i * i * i) % 65_521);
  const fractions: number[] = [];
  const onProgress = (fraction: number) => fractions.push(fraction);
  const encoded = await (await encodeBlock(new Blob([bytes]), { onProgress })).text();
  expect(fractions.at(-1)).toBe(1);
  expect(encoded).toMatch(/^[A-Za-z0-9+/]+=*$/);
  document.body.innerHTML = `<script type="text/plain" id="clip">${encoded}</script>`;
  expect(blockText("clip")).toBe(encoded);
  const decoded = Buffer.from(await (await decodeBlock("clip")).arrayBuffer());
  // Not `toEqual`, which takes seconds for a million elements.
  expect(decoded.equals(bytes)).toBe(true);
});

it("stops encoding when it is aborted", async () => {
  const controller = new AbortController();
  const encoding = encodeBlock(new Blob([new Uint8Array(1e6)]), {
    signal: controller.signal,
    onProgress: () => controller.abort(),
  });
  await expect(encoding).rejects.toMatchObject({ name: "AbortError" });
});
