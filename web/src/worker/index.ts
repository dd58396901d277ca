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
export type * from "./types";
