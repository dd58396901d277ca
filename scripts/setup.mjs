/** Sets up a new machine: npm packages, the Rust toolchain, and the wasm modules with their bindings. */

import { createHash } from "node:crypto";
import { existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { homedir } from "node:os";
import { join } from "node:path";
import { ask, root, run, Stop, step } from "./run.mjs";

const WASM = "wasm32-unknown-unknown";
export const CRATES = "The crates registry (crates.io)";

/**
 * Selects the crates with tests on this machine. All commands that build tests select the same ones, because the
 * selection determines the features of dependencies, which would otherwise be compiled again.
 */
export const TESTED_CRATES = ["--workspace", ...without("wasm", "bindgen", "python")];

/** Excludes crates from a workspace command. */
export function without(...crates) {
  return crates.flatMap((crate) => ["--exclude", `plantigrade-${crate}`]);
}

/** Installs what is missing and builds the wasm modules. */
export async function setup() {
  checkNode();
  await packages();
  await toolchain();
  await bindings();
}

function checkNode() {
  const [major, minor] = process.versions.node.split(".").map(Number);
  if (major < 20 || (major === 20 && minor < 19)) {
    throw new Stop(`Node.js ${process.versions.node} is too old. Install 20.19 or newer.`);
  }
}

/** Installs the npm packages of the lock file, if they have changed. */
async function packages() {
  const lock = createHash("sha256")
    .update(readFileSync(join(root, "package-lock.json")))
    .digest("hex");
  const stamp = join(root, "node_modules", ".plantigrade-lock");
  if (existsSync(stamp) && readFileSync(stamp, "utf8") === lock) return;
  step("Installing npm packages");
  await run("npm", ["ci", "--no-audit", "--no-fund"], { source: "The npm registry" });
  writeFileSync(stamp, lock);
}

/** Installs the pinned Rust toolchain with the wasm target, clippy and rustfmt, if it is missing. */
export async function toolchain() {
  if (ask("cc", ["--version"]) === undefined && process.platform !== "win32") {
    throw new Stop(
      "No C linker (cc) was found, which Rust requires. Install build-essential (Debian, Ubuntu), gcc (Fedora) or the Xcode command line tools (macOS).",
    );
  }
  if (ask("rustup", ["--version"]) === undefined) {
    if (ask("cargo", ["--version"]) === undefined) {
      throw new Stop(
        "Rust was not found. Install rustup from https://rustup.rs and open a new terminal.",
      );
    }
    // A toolchain without rustup is accepted if it has the wasm target.
    const libraries = ask("rustc", ["--print", "target-libdir", "--target", WASM]);
    if (!libraries || !existsSync(libraries)) {
      throw new Stop(
        `The Rust toolchain lacks the ${WASM} target. Install rustup from https://rustup.rs.`,
      );
    }
    return;
  }
  const pinned = /channel = "(.+)"/.exec(
    readFileSync(join(root, "rust-toolchain.toml"), "utf8"),
  )?.[1];
  const hasAll = (list, ...required) =>
    required.every((name) => list?.split("\n").some((line) => line.startsWith(name)));
  const targets = ask("rustup", ["target", "list", "--installed", "--toolchain", pinned]);
  const components = ask("rustup", ["component", "list", "--installed", "--toolchain", pinned]);
  if (hasAll(targets, WASM) && hasAll(components, "clippy", "rustfmt")) return;
  step(`Installing Rust ${pinned} for the browser`);
  const args = ["toolchain", "install", pinned, "--profile", "minimal", "--no-self-update"];
  await run("rustup", [...args, "--component", "clippy,rustfmt", "--target", WASM], {
    source: "The Rust server (static.rust-lang.org)",
  });
}

/**
 * Returns the compiler flags of the module. Less inlining makes it 3 % smaller without making it
 * slower.
 */
function moduleFlags() {
  return ["-Cllvm-args=-inline-threshold=50", ...pathFlags()];
}

/** Returns compiler flags with which panic messages contain no paths of this machine. */
export function pathFlags() {
  const registry = join(process.env.CARGO_HOME ?? join(homedir(), ".cargo"), "registry/src");
  const folders = existsSync(registry) ? readdirSync(registry) : [];
  const prefixes = [...folders.map((name) => join(registry, name)), "crate/core/src"];
  return prefixes.map((prefix) => `--remap-path-prefix=${prefix}=`);
}

/** Folder of the bindings and the two modules of the app. */
const bindingsFolder = join(root, "web/src/wasm");

/** Compiles the core to two wasm modules of the app, and generates their JavaScript bindings and types. */
async function bindings() {
  step("Building the WebAssembly modules");
  const [module] = await Promise.all([
    compileModule(["--features", "split"], ["-Clink-arg=--emit-relocs"]),
    bindgen(),
  ]);
  mkdirSync(bindingsFolder, { recursive: true });
  const first = join(targetFolder(), "first.wasm");
  await run(tool("wasm-split"), [module, first, join(bindingsFolder, "plantigrade_second.wasm")]);
  // The second module imports the table of functions, which the linker exports.
  await bind(first, bindingsFolder, ["--keep-lld-exports"]);
}

/** Writes the core as one wasm module, with its bindings and types, to a folder. */
export async function singleModule(folder) {
  step("Building the WebAssembly module");
  const [module] = await Promise.all([compileModule([], []), bindgen()]);
  await bind(module, folder, []);
}

/** Compiles the bindings for the browser and returns the path of the module. */
async function compileModule(cargoOptions, compilerOptions) {
  await run("cargo", ["fetch", "--locked"], { source: CRATES });
  const crate = ["-p", "plantigrade-wasm", "--lib", ...cargoOptions];
  const flags = `target.${WASM}.rustflags=${JSON.stringify(moduleFlags())}`;
  // Numbers are written with a small table instead of one of 17 kB, which does not compress.
  const zmij = 'profile.release.package.zmij.opt-level="s"';
  const config = ["--config", flags, "--config", zmij];
  const build = ["rustc", "--locked", "--release", "--target", WASM, ...crate, ...config];
  await run("cargo", [...build, "--", ...compilerOptions], { source: CRATES });
  return join(targetFolder(), WASM, "release/plantigrade_wasm.wasm");
}

/** Generates the JavaScript bindings and types of a module. */
async function bind(module, folder, options) {
  // Function names would make up a tenth of the module.
  const strip = ["--remove-name-section", "--remove-producers-section"];
  const names = ["--target", "web", "--out-name", "plantigrade", "--out-dir", folder];
  await run(tool("wasm-bind"), [...names, ...strip, ...options, module]);
}

/** Builds the tools that generate the bindings and run their tests. */
export async function bindgen() {
  await run("cargo", ["build", "--locked", "--profile", "tool", "-p", "plantigrade-bindgen"], {
    source: CRATES,
  });
}

/** Returns the path of a built tool of the project. */
export function tool(name) {
  return join(targetFolder(), "tool", process.platform === "win32" ? `${name}.exe` : name);
}

/** Returns the target folder of cargo. */
export function targetFolder() {
  return process.env.CARGO_TARGET_DIR ?? join(root, "target");
}
