/** Opening the clip of the address or of a shared page, or the preview of the start page. */

import { engine } from "../../engine";
import { messageOf } from "../../model/failure";
import { fileNameOfUrl, type Link, parseHash } from "../../model/sources/link";
import { tableVisible } from "../../store/batch";
import { type EmbeddedClip, embedded, embeddedSource } from "../../store/embedded";
import { reportOpenFailure } from "../../store/errors";
import { firstInteraction } from "../../store/first-interaction";
import { clip } from "../../store/session";
import { runDetection } from "../analyse/detect";
import { followHost } from "../host";
import { parseLinkView } from "../view/view-state";
import { beginOpening, openingSignal, openSample, openSource, openUrl, showClip } from "./open";
import { previewSample } from "./samples";

/** Opens the embedded clip or that of the host, follows `#url=` or `#sample=`, or starts the preview. */
export async function openFromAddress(): Promise<void> {
  if (embedded) {
    if ("host" in embedded) followHost((source) => void openSource(source));
    else if (!clip.value) await openEmbedded(embedded);
    return;
  }
  const link = parseHash(location.hash);
  if (link && (await followLink(link))) return;
  if (!clip.value) await startPreview();
}

async function openEmbedded(page: EmbeddedClip): Promise<void> {
  try {
    const view = await parseLinkView(page.showing);
    await openSource({ ...(await embeddedSource(page)), view });
  } catch (error) {
    reportOpenFailure(page.name, {
      message: messageOf(error),
      hint: "Ask the sender for a new copy of the page.",
    });
  }
}

async function followLink({ origin, view: text }: Link): Promise<boolean> {
  const name = origin.kind === "url" ? fileNameOfUrl(origin.url) : `${origin.name}.bvh`;
  const signal = beginOpening(name, "fetch");
  const view = await parseLinkView(text);
  if (signal.aborted) return true;
  tableVisible.value = false;
  return origin.kind === "url" ? openUrl(origin.url, { view }) : openSample(origin.name, { view });
}

/** Plays a sample as the background of the start page. */
export async function startPreview(): Promise<void> {
  if (!previewSample) return;
  const signal = openingSignal();
  // Hidden by the table, it would only take processor time from the batch.
  const isUnwanted = () => signal.aborted || tableVisible.value;
  await firstInteraction;
  if (isUnwanted()) return;
  try {
    const data = await (await fetch(previewSample.url)).blob();
    const source = { name: `${previewSample.name}.bvh`, data };
    if (isUnwanted()) return;
    const opened = await engine.open(data, source.name, { signal });
    if (isUnwanted() || !opened.ok) return;
    showClip(opened.clip, source, true);
    await runDetection();
  } catch {
    // The preview is decorative; the start page works without it.
  }
}
