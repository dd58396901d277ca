/** The first interaction. The preview starts only then, because starting to draw is slow. */

const events = ["pointermove", "pointerdown", "keydown", "wheel", "dragenter"] as const;

/** Time after which the preview starts without an interaction, in milliseconds. */
const fallbackMs = 8000;

let resolve: () => void;

/** Resolves at the first interaction, or after `fallbackMs`. */
export const firstInteraction = new Promise<void>((done) => {
  resolve = done;
});

export function listenForFirstInteraction() {
  const options = { capture: true, once: true, passive: true };
  for (const event of events) addEventListener(event, () => resolve(), options);
  setTimeout(resolve, fallbackMs);
}
