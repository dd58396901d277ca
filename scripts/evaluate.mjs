/** `npm run evaluate`: writes RESULTS.md and its figures. */

import { main, run, step } from "./run.mjs";
import { CRATES, toolchain } from "./setup.mjs";

await main(async () => {
  await toolchain();
  step("Evaluating the detector");
  await run("cargo", ["run", "--locked", "--release", "-p", "plantigrade-evaluate"], {
    source: CRATES,
  });
});
