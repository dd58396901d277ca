export {
  Cancelled,
  type Compared,
  type CutPart,
  createEngine,
  type Detected,
  type EditedParts,
  type Engine,
  type Opened,
  type OpenOptions,
  type Segmented,
  type Stoppable,
} from "./engine";
export { archivist, surveyors } from "./pools";
export type { Document, Orders, Survey } from "./surveyor";
export type * from "./types";
