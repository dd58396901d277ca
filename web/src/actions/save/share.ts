/** Sharing a clip as a link, as a single-file page, or as a picture. */

import player from "virtual:player";
import type { CallOptions } from "../../engine";
import { wasmBytes } from "../../engine/wasm-module";
import { formatHash } from "../../model/sources/link";
import { encodeBlock, fillBlocks, jsonText, titleText } from "../../model/sources/player-html";
import { formatViewState } from "../../model/stored/view-state";
import { type EmbeddedClip, embedded } from "../../store/embedded";
import { runJob } from "../../store/jobs";
import { frame } from "../../store/playback";
import { edits, segmentNames, source } from "../../store/session";
import { dialog, stageHandle } from "../../store/view";
import { stemOf } from "../../util/file-names";
import { randomId } from "../../util/random-id";
import { pause } from "../view/playback";
import { currentViewState } from "../view/view-state";
import { download, ofOpenClip } from "./download";

export function openShareDialog() {
  // The current moment is shared.
  pause();
  dialog.value = "share";
}

/** Returns a link to the current view; undefined if the clip is a local file. */
export function currentLink(): string | undefined {
  const origin = source.value?.origin;
  if (!origin) return undefined;
  const view = formatViewState(currentViewState());
  return new URL(formatHash({ origin, view }), home()).href;
}

const home = () => location.href.replace(/#.*$/s, "");

const stem = () => stemOf(source.value?.name ?? "clip");

/** Downloads a page that contains the clip and the player. */
export function savePage(): Promise<void> {
  const name = `${stem()}.html`;
  const create = () => runJob({ title: "Creating", name }, new AbortController(), createPage);
  return download(name, ofOpenClip(create));
}

async function createPage(options: CallOptions): Promise<Blob> {
  const { name, data } = source.value ?? { name: "clip.bvh", data: new Blob() };
  const clip: EmbeddedClip = {
    version: 1,
    id: randomId(),
    name,
    showing: formatViewState(currentViewState()),
    edits: edits.value,
    names: segmentNames.value,
    ...publicHome(),
  };
  const contents = {
    title: titleText(`${name} – Plantigrade`),
    enclosed: jsonText(clip),
    clip: await encodeBlock(data, options),
  };
  if (embedded) return toPage(fillBlocks(ownHtml(), contents));
  const { first, second } = await wasmBytes();
  const modules = { core: await encodeBlock(first), second: await encodeBlock(second) };
  return toPage(fillBlocks(await playerHtml(), { ...contents, ...modules }));
}

const toPage = (parts: (string | Blob)[]) => new Blob(parts, { type: "text/html" });

async function playerHtml(): Promise<string> {
  const response = await fetch(player);
  if (!response.ok) throw new Error(`The player could not be downloaded (${response.status}).`);
  return response.text();
}

/** Returns the HTML of this page, which contains the player, as it was loaded. */
function ownHtml(): string {
  const page = document.documentElement.cloneNode(true) as HTMLElement;
  page.querySelector("#app")?.replaceChildren();
  delete page.dataset.theme;
  return `<!doctype html>\n${page.outerHTML}`;
}

/** Returns the address of the app, unless it is a local one. */
function publicHome(): Pick<EmbeddedClip, "home"> {
  if (embedded) return "home" in embedded && embedded.home ? { home: embedded.home } : {};
  const isLocal = /^(localhost|127\.|\[::1)/.test(location.hostname);
  return isLocal ? {} : { home: home() };
}

/** Downloads a picture of the view. */
export const savePicture = () =>
  download(`${stem()}-${frame.value}.png`, async () => {
    const picture = await stageHandle.value?.picture();
    if (!picture)
      throw new Error("The picture could not be rendered: this browser does not support WebGL.");
    return picture;
  });
