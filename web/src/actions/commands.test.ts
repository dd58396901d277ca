import { expect, it, vi } from "vitest";

vi.mock("../engine", () => import("../testing/fake-engine"));

const { commandForKey, commands, keysOf, keyTable, tooltip } = await import("./commands");
const { keyText } = await import("./key-bindings");
const { classicKeys } = await import("../store/preferences");

it.each([false, true])("binds each key to one command (classic: %s)", (isClassic) => {
  classicKeys.set(isClassic);
  const bound = commands.flatMap((command) => keysOf(command).map(keyText));
  expect(new Set(bound).size).toBe(bound.length);
  classicKeys.set(false);
  const ids = commands.map(({ id }) => id);
  expect(new Set(ids).size).toBe(ids.length);
});

it("ignores Shift unless a binding requires it", () => {
  const id = (key: string, shiftKey = false, mod = false) =>
    commandForKey({ key, shiftKey }, mod)?.id;
  expect(id("ArrowLeft")).toBe("frame-back");
  expect(id("ArrowLeft", true)).toBe("previous-edge");
  expect(id("L", true)).toBe("loop");
  expect(id("l")).toBe("shuttle-ahead");
  expect(id(",")).toBe("frame-back");
  expect(id(">", true)).toBe("faster");
  expect(id("?", true)).toBe("keys");
  expect(id("+", true)).toBe("zoom-in");
  expect(id("z", false, true)).toBe("undo");
  expect(id("Z", true, true)).toBe("redo");
  expect(id("s", true, true)).toBeUndefined();
  expect(id("y")).toBe("apply-similar");
  expect(id("z")).toBeUndefined();
});

it("lists every command in the key overlay", () => {
  const shown = keyTable().flatMap(({ rows }) => rows.map(({ help }) => help));
  for (const { help } of commands) expect(shown).toContain(help);
  expect(keyTable()[0]?.rows[2]).toEqual({ help: "Previous, next frame", keys: ["←", "→"] });
  expect(keyTable()[0]?.rows[3]?.keys).toEqual(["Shift", "←", "→"]);
});

it("makes tooltips of label and key", () => {
  expect(tooltip("redo")).toBe("Redo (Ctrl Shift Z)");
  expect(tooltip("play", "Pause")).toBe("Pause (Space)");
});

it("names the modifier of the computer", () => {
  vi.stubGlobal("navigator", { platform: "MacIntel" });
  expect(tooltip("redo")).toBe("Redo (⌘ Shift Z)");
  vi.unstubAllGlobals();
});

it("has the former keys as a choice", () => {
  classicKeys.set(true);
  expect(commandForKey({ key: "l", shiftKey: false }, false)?.id).toBe("loop");
  expect(commandForKey({ key: "k", shiftKey: false }, false)?.id).toBe("split");
  expect(commandForKey({ key: ",", shiftKey: false }, false)?.id).toBe("slower");
  classicKeys.set(false);
});
