/** What is only decoration begins once somebody is there to see it: starting to draw takes a while. */

const signs = ["pointermove", "pointerdown", "keydown", "wheel", "dragenter"] as const;
/** Who only looks sees it after so many milliseconds. */
const patience = 8000;

/** Settles at the first sign of a person, or when the page has been open for a while. */
export const somebody = new Promise<void>((resolve) => {
  const quiet = { capture: true, once: true, passive: true };
  for (const sign of signs) addEventListener(sign, () => resolve(), quiet);
  setTimeout(resolve, patience);
});
