/** `npm run package`: builds the npm package in target/npm from crate/wasm and crate/wasm/npm. */

import { copyFileSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { main, root, run, step } from "./run.mjs";
import { setup, singleModule } from "./setup.mjs";
import { noticesText, wasmPackages } from "./third-party.mjs";

/** Folder of the built package. */
const folder = join(root, "target/npm");

/** Builds the package; requires the tools that setup builds. */
export async function buildPackage() {
  step("Building the npm package");
  const sources = join(root, "crate/wasm/npm");
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  await singleModule(folder);
  rmSync(join(folder, "plantigrade_bg.wasm.d.ts"));
  for (const name of ["README.md", "package.json", "index.ts"]) {
    copyFileSync(join(sources, name), join(folder, name));
  }
  for (const name of ["LICENSE-MIT", "LICENSE-APACHE"]) {
    copyFileSync(join(root, name), join(folder, name));
  }
  writeFileSync(
    join(folder, "THIRD-PARTY.txt"),
    noticesText(wasmPackages(), "The WebAssembly module of Plantigrade"),
  );
  const options = ["--target", "es2023", "--module", "nodenext", "--lib", "es2023,dom,esnext"];
  const strict = ["--strict", "--declaration", "--types", "node", "--typeRoots"];
  await run(process.execPath, [
    join(root, "node_modules/@typescript/native/bin/tsc"),
    ...options,
    ...strict,
    join(root, "node_modules/@types"),
    "--stripInternal",
    "--ignoreConfig",
    join(folder, "index.ts"),
  ]);
  rmSync(join(folder, "index.ts"));
  // The package has the version of the project.
  const { version } = JSON.parse(readFileSync(join(root, "package.json"), "utf8"));
  const manifest = JSON.parse(readFileSync(join(folder, "package.json"), "utf8"));
  writeFileSync(
    join(folder, "package.json"),
    `${JSON.stringify({ ...manifest, version }, null, 2)}\n`,
  );
}

if (process.argv[1] === import.meta.filename) {
  await main(async () => {
    await setup();
    await buildPackage();
    console.log("\nThe package is in target/npm, ready to be packed or published.");
  });
}
