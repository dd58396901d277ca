/** The app once visited opens without a network: a service worker keeps its files. */

import { embedded } from "../store/embedded";
import { showToast } from "../store/toasts";

export function keepOffline() {
  if (!import.meta.env.PROD || embedded || !("serviceWorker" in navigator)) return;
  // The page comes first; its files are kept when it has nothing left to load.
  if (document.readyState === "complete") void register();
  else addEventListener("load", () => void register(), { once: true });
}

async function register() {
  try {
    const worker = await navigator.serviceWorker.register("./sw.js");
    worker.addEventListener("updatefound", () => void tellIfOld());
  } catch {
    // Private windows may forbid it: then the page needs a network, as any other.
  }
}

/** A reload always shows the newest version; what is open stays as it is until then. */
async function tellIfOld() {
  // Who comes for the first time has nothing older.
  if (!navigator.serviceWorker.controller) return;
  const own = document.querySelector<HTMLScriptElement>("script[type=module]")?.getAttribute("src");
  const newest = await fetch("./", { cache: "no-cache" })
    .then((response) => response.text())
    .catch(() => own);
  if (!own || newest?.includes(own)) return;
  showToast({
    text: "A new version is ready.",
    action: { name: "Reload", run: () => location.reload() },
  });
}
