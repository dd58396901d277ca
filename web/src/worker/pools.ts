/** The workers that are not the clip's on show. */

import type { ArchiveApi } from "./archivist";
import { createPool } from "./pool";
import type { SurveyApi } from "./surveyor";
import { coreThread, thread } from "./thread";

/** Label files, each from its bytes to the facts of it. */
export const surveyors = createPool((onBroken) =>
  coreThread<SurveyApi>(
    new Worker(new URL("./surveyor.ts", import.meta.url), { type: "module" }),
    onBroken,
  ),
);

/** Packs and unpacks. */
export const archivist = createPool(
  (onBroken) =>
    thread<ArchiveApi>(
      new Worker(new URL("./archivist.ts", import.meta.url), { type: "module" }),
      onBroken,
    ),
  1,
);
