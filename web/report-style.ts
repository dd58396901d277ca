/** Hash of the style of the gait report, which windows of the app open. */

import { createHash } from "node:crypto";
import { readFileSync } from "node:fs";
import { join } from "node:path";

const file = join(import.meta.dirname, "../crate/core/src/formats/gait/report/report.css");

/** Source expression that allows the style in a content security policy; windows inherit that of the app. */
export const reportStyleSource = `'sha256-${createHash("sha256").update(readFileSync(file)).digest("base64")}'`;
