/** Offline use: a service worker caches the files of the app. */

import { embedded } from "../store/embedded";
import { showToast } from "../store/toasts";

/** Registers the service worker after the page has loaded and `ready` has settled. */
export function registerServiceWorker(ready: Promise<unknown>) {
  if (!import.meta.env.PROD || embedded || !("serviceWorker" in navigator)) return;
  const start = () => void ready.finally(register);
  if (document.readyState === "complete") start();
  else addEventListener("load", start, { once: true });
}

async function register() {
  try {
    const worker = await navigator.serviceWorker.register("./sw.js");
    worker.addEventListener("updatefound", () => void notifyIfOutdated());
  } catch {
    // Private windows may not allow service workers; the page then requires a network.
  }
}

/** Offers a reload if a newer version than this page has been published. */
async function notifyIfOutdated() {
  // The first visit has no older version.
  if (!navigator.serviceWorker.controller) return;
  const currentScript = document
    .querySelector<HTMLScriptElement>("script[type=module]")
    ?.getAttribute("src");
  const newestPage = await fetch("./", { cache: "no-cache" })
    .then((response) => response.text())
    .catch(() => currentScript);
  if (!currentScript || newestPage?.includes(currentScript)) return;
  showToast({
    text: "A new version is available.",
    action: { name: "Reload", run: () => location.reload() },
  });
}
