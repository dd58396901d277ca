import { render } from "preact";
import { expect, test, vi } from "vitest";
import { lazy } from "./lazy";

test("loads a component when it is shown, and again after a failure", async () => {
  const load = vi.fn(async () => ({ name }: { name: string }) => <p>Hello {name}</p>);
  load.mockRejectedValueOnce(new Error("offline"));
  const Panel = lazy(load);
  const root = document.createElement("div");
  render(<Panel name="walk" />, root);
  await vi.waitFor(() => expect(root.textContent).toContain("could not be loaded"));
  root.querySelector("button")?.click();
  await vi.waitFor(() => expect(root.textContent).toBe("Hello walk"));
  Panel.preload();
  expect(load).toHaveBeenCalledTimes(2);
});
