import { beforeEach, expect, test, vi } from "vitest";
import type { HostMessage, PageMessage } from "../model/sources/host";
import type { Source } from "../model/sources/source";
import { ClipSession, openSession, session } from "../store/clip-session";
import { detectOptions } from "../store/settings";
import { theme } from "../store/theme";
import { edit } from "../testing/edit";
import { createWalkingClip } from "../testing/walking-clip";

vi.mock("../engine", () => import("../testing/fake-engine"));

const { commitEdits, undo } = await import("./edit/edit");
const { followHost, shareWithHost } = await import("./host");
const { setDetectOptions, setOverrides } = await import("./analyse/detect");

const shared = { id: "", edits: [edit(0)], names: [] };

/** Messages that the host has received. */
const posted: PageMessage[] = [];
vi.spyOn(parent, "postMessage").mockImplementation((message: PageMessage) => {
  posted.push(message);
});

/** Clips that the host has opened. */
const opened: Source[] = [];
followHost((source) => opened.push(source));

const send = (data: HostMessage, source: Window | null = parent) =>
  dispatchEvent(new MessageEvent("message", { data, source }));

const lastState = () => {
  const message = posted.at(-1);
  return message?.type === "plantigrade-state" ? message.state : undefined;
};

beforeEach(async () => {
  openSession(
    new ClipSession(createWalkingClip("walk.bvh"), { name: "walk.bvh", data: new Blob(), shared }),
  );
  await shareWithHost(session.value);
});

test("asks for a clip, and opens that of the host with its settings and edits", async () => {
  expect(posted[0]).toEqual({ type: "plantigrade-ready" });
  const state = { settings: { method: "paper", joints: { left_toe: -1 } }, edits: [], names: [] };
  send({ type: "plantigrade-open", name: "jog.bvh", data: "HIERARCHY", state }, null);
  expect(opened).toEqual([]);
  send({ type: "plantigrade-open", name: "jog.bvh", data: "HIERARCHY", state });
  expect(opened).toMatchObject([
    {
      name: "jog.bvh",
      view: { method: "paper", joints: { left_toe: -1 }, lenient: "yes" },
      shared: { edits: [] },
    },
  ]);
  expect(await opened[0]?.data.text()).toBe("HIERARCHY");
});

test("has the edits of the host, and reports changes only", async () => {
  const before = posted.length;
  expect(session.value.edits.value).toEqual([edit(0)]);
  expect(posted.length).toBe(before);
  await commitEdits([edit(0), edit(50)], "");
  expect(lastState()).toEqual({ settings: {}, edits: [edit(0), edit(50)], names: [] });
  await undo();
  expect(lastState()?.edits).toEqual([edit(0)]);
  setDetectOptions({ method: "paper", r: 0.002 });
  setOverrides({ rate: 60 });
  expect(lastState()?.settings).toEqual({ method: "paper", r: 0.002, rate: 60 });
});

test("takes the state of the host without reporting it, and can undo it", async () => {
  const before = posted.length;
  const settings = { method: "height", height: 0.1, up: "z" } as const;
  send({ type: "plantigrade-state", state: { settings, edits: [edit(20)], names: [] } });
  expect(session.value.edits.value).toEqual([edit(20)]);
  expect(detectOptions.value).toMatchObject({ method: "height", height: 0.1, r: 0.001 });
  expect(session.value.overrides.value).toEqual({ up: "z" });
  expect(posted.length).toBe(before);
  await undo();
  expect(lastState()?.edits).toEqual([edit(0)]);
});

test("has the theme of the host", () => {
  send({ type: "plantigrade-theme", theme: "light" });
  expect(theme.value).toBe("light");
  send({ type: "plantigrade-theme", theme: "dark" });
  expect(theme.value).toBe("dark");
});
