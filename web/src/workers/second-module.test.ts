import { expect, test, vi } from "vitest";

const first = { memory: {} };

vi.mock("../wasm/plantigrade", () => ({ default: async () => first }));

const module = {} as WebAssembly.Module;

test("calls wait for the second module, except for those of the first", async () => {
  vi.resetModules();
  const { startSecondModule, startWasm, withSecondModule } = await import("./wasm-runtime");
  const instantiate = vi.spyOn(WebAssembly, "instantiate").mockResolvedValue({} as never);
  const request = vi.fn(() => startSecondModule(module));
  request.mockRejectedValueOnce(new Error("offline"));
  let clip = "walk";
  const api = withSecondModule(
    { open: async () => "opened", gait: async (frames: number) => `${clip} ${frames}` },
    ["open"],
    () => clip,
  );
  startWasm(module, request);
  expect(await api.open()).toBe("opened");
  expect(request).not.toHaveBeenCalled();
  await expect(api.gait(1)).rejects.toThrow("offline");
  expect(await api.gait(2)).toBe("walk 2");
  expect(instantiate).toHaveBeenCalledWith(module, { __wasm_split: first });
  await Promise.all([api.gait(3), api.gait(4)]);
  expect(request).toHaveBeenCalledTimes(2);
  expect(instantiate).toHaveBeenCalledTimes(1);
  const pending = api.gait(5);
  clip = "run";
  await expect(pending).rejects.toThrow("Another clip was opened.");
});
