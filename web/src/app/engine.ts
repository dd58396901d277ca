import { createEngine } from "../worker";

/** The one worker of the page. */
export const engine = createEngine();
