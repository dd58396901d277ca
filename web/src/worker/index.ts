export { Cancelled, createEngine, type Detected, type Engine, type Opened } from "./engine";
export type * from "./types";
