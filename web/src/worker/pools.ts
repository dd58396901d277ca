/** The workers that are not the clip's on show. */

import type { ArchiveApi } from "./archivist";
import { createPool } from "./pool";
import { startArchivist, startSurveyor } from "./start";
import type { SurveyApi } from "./surveyor";
import { coreThread, thread } from "./thread";

/** Label files, each from its bytes to the facts of it. */
export const surveyors = createPool((onBroken) => coreThread<SurveyApi>(startSurveyor(), onBroken));

/** Packs and unpacks. */
export const archivist = createPool(
  (onBroken) => thread<ArchiveApi>(startArchivist(), onBroken),
  1,
);
