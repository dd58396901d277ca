/** Passing a clip on: as a link, as a page in one file, as a picture. */

import player from "virtual:player";
import { fill, jsonText, packed, titleText } from "../lib/blocks";
import { writeHash } from "../lib/hash";
import { stemOf } from "../lib/names";
import { writeShowing } from "../lib/showing";
import { staged } from "../viewer/staged";
import type { Stoppable } from "../worker";
import { coreBytes } from "../worker/module";
import { type Enclosed, enclosed } from "./enclosed";
import { handOver } from "./handOver";
import { pause } from "./playback";
import { showingNow } from "./showing";
import { dialog, edits, frame, segmentNames, source } from "./state";
import { withProgress } from "./work";

export function askToShare() {
  // What is shared is the moment on show: it must not run away.
  pause();
  dialog.value = "share";
}

/** A link to what is on show; nothing where the clip is a file of one's own. */
export function linkNow(): string | undefined {
  const origin = source.value?.origin;
  if (!origin) return undefined;
  const { href } = new URL(writeHash({ origin, showing: writeShowing(showingNow()) }), home());
  return href;
}

const home = () => location.href.replace(/#.*$/s, "");

const stem = () => stemOf(source.value?.name ?? "clip");

/** Hands a page that shows all this by itself to the browser as a download. */
export function savePage(): Promise<void> {
  const name = `${stem()}.html`;
  return handOver(name, () =>
    withProgress({ what: "Making", name }, new AbortController(), makePage),
  );
}

async function makePage(stoppable: Stoppable): Promise<Blob> {
  const { name, data } = source.value ?? { name: "clip.bvh", data: new Blob() };
  const made: Enclosed = {
    version: 1,
    id: Array.from(crypto.getRandomValues(new Uint8Array(8)), (byte) => byte.toString(16)).join(""),
    name,
    showing: writeShowing(showingNow()),
    edits: edits.value,
    names: segmentNames.value,
    ...homeForOthers(),
  };
  const contents = {
    title: titleText(`${name} – Plantigrade`),
    enclosed: jsonText(made),
    clip: await packed(data, stoppable),
  };
  const parts = enclosed
    ? fill(thisPage(), contents)
    : fill(await playerPage(), { ...contents, core: await packed(await coreBytes()) });
  return new Blob(parts, { type: "text/html" });
}

async function playerPage(): Promise<string> {
  const response = await fetch(player);
  if (!response.ok) throw new Error(`The player could not be had (${response.status}).`);
  return response.text();
}

/** This page as it came, which holds the player itself. */
function thisPage(): string {
  const page = document.documentElement.cloneNode(true) as HTMLElement;
  page.querySelector("#app")?.replaceChildren();
  delete page.dataset.theme;
  return `<!doctype html>\n${page.outerHTML}`;
}

/** Where others find the app; an address on this computer is none for them. */
function homeForOthers(): Pick<Enclosed, "home"> {
  if (enclosed) return enclosed.home ? { home: enclosed.home } : {};
  const isHere = /^(localhost|127\.|\[::1)/.test(location.hostname);
  return isHere ? {} : { home: home() };
}

/** Hands a picture of the view to the browser as a download. */
export const savePicture = () =>
  handOver(`${stem()}-${frame.value}.png`, async () => {
    const picture = await staged.value?.picture();
    if (!picture) throw new Error("There is no picture: this browser shows no 3D.");
    return picture;
  });
