import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { opening } from "../../store/jobs";
import { openClip } from "../../store/session";

vi.mock("../../engine", () => import("../../testing/fake-engine"));

const { openFiles } = await import("./open-files");
const { followHistory } = await import("./navigation");

const file = (name: string) => new File(["HIERARCHY"], name);
let controller = new AbortController();

beforeEach(() => {
  controller = new AbortController();
  followHistory(controller.signal);
});
afterEach(() => controller.abort());

it("Back ends the opening of a clip that was not read yet", async () => {
  await openFiles({ files: [file("walk.bvh")] });
  const { state } = history;
  const pending = openFiles({ files: [file("slow.bvh")] });
  await vi.waitFor(() => expect(opening.value?.fraction).toBe(0.1));
  dispatchEvent(new PopStateEvent("popstate", { state }));
  await pending;
  expect(opening.value).toBeNull();
  expect(openClip.value?.name).toBe("walk.bvh");
});
