import { expect, test, vi } from "vitest";
import type { ClipApi } from "./clip.worker";

const exposed: { api?: ClipApi } = {};
const hashes: ((hash: string) => void)[] = [];

vi.mock("comlink", () => ({
  expose: (api: ClipApi) => {
    exposed.api = api;
  },
  transfer: (value: unknown) => value,
}));

vi.mock("../wasm/plantigrade", () => ({}));

vi.mock("./to-plain", () => ({
  clipToPlain: (_: unknown, name: string) => ({ name }),
  detectionToPlain: () => ({ parts: {} }),
  transferables: () => [],
}));

vi.mock("./wasm-runtime", async () => ({
  ...(await vi.importActual("./wasm-runtime")),
  wasmReady: Promise.resolve(),
  methodReady: async () => {},
  readClip: async () => fakeClip(),
  sha256: () => new Promise((resolve) => hashes.push(resolve)),
  withSecondModule: (api: ClipApi) => api,
}));

/** Creates a clip that fails in the way of the bindings when it is used after `free`. */
function fakeClip() {
  let isFree = false;
  return {
    free() {
      isFree = true;
    },
    detect: () => ({ edit() {}, free() {} }),
    save(_detection: unknown, _format: string, name: string, hash: string) {
      if (isFree) throw new Error("null pointer passed to rust");
      return `${name} ${hash}`;
    },
  };
}

test("saves a clip whose hash is not known yet while another clip is opened", async () => {
  await import("./clip.worker");
  const { api } = exposed;
  if (!api) throw new Error("The worker has no calls.");
  const file = new Blob();
  await api.open(file, "walk", false);
  await api.detect({ method: "robust", r: 0.001, w: 1 });
  const saved = api.save("json");
  await api.open(file, "run", false);
  hashes[0]?.("1234");
  expect(await saved).toBe("walk 1234");
});
