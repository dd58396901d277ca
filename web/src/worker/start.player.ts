/** Starts the workers of a page in one file: it holds them as text. */

import Archivist from "./archivist?worker&inline";
import Surveyor from "./surveyor?worker&inline";
import ClipWorker from "./worker?worker&inline";

export const startClipWorker = () => new ClipWorker();
export const startSurveyor = () => new Surveyor();
export const startArchivist = () => new Archivist();
