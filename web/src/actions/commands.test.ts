import { expect, it, vi } from "vitest";

vi.mock("../engine", () => import("../testing/fake-engine"));

const { commandForKey, commands, keyTable, keyText, tooltip } = await import("./commands");

it("binds each key to one command", () => {
  const bound = commands.flatMap(({ keys }) => keys.map(keyText));
  expect(new Set(bound).size).toBe(bound.length);
  const ids = commands.map(({ id }) => id);
  expect(new Set(ids).size).toBe(ids.length);
});

it("ignores Shift unless a binding requires it", () => {
  const id = (key: string, shiftKey = false, mod = false) =>
    commandForKey({ key, shiftKey }, mod)?.id;
  expect(id("ArrowLeft")).toBe("frame-back");
  expect(id("ArrowLeft", true)).toBe("previous-edge");
  expect(id("L", true)).toBe("loop");
  expect(id("?", true)).toBe("keys");
  expect(id("+", true)).toBe("zoom-in");
  expect(id("z", false, true)).toBe("undo");
  expect(id("Z", true, true)).toBe("redo");
  expect(id("s", true, true)).toBeUndefined();
  expect(id("q")).toBeUndefined();
});

it("lists every command in the key overlay", () => {
  const shown = keyTable.flatMap(({ rows }) => rows.map(({ help }) => help));
  for (const { help } of commands) expect(shown).toContain(help);
  expect(keyTable[0]?.rows[1]).toEqual({ help: "Previous, next frame", keys: ["←", "→"] });
  expect(keyTable[0]?.rows[2]?.keys).toEqual(["Shift", "←", "→"]);
});

it("makes tooltips of label and key", () => {
  expect(tooltip("redo")).toBe("Redo (Ctrl Shift Z)");
  expect(tooltip("play", "Pause")).toBe("Pause (Space)");
});
