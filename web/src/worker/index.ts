export {
  Cancelled,
  type Compared,
  createEngine,
  type Detected,
  type Engine,
  type Opened,
  type OpenOptions,
} from "./engine";
export type * from "./types";
