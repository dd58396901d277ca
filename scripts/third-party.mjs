/**
 * Notices of third-party software: names, versions, licences and licence texts of what is part of
 * the site, the npm package, the Python package and the binary. Run as a script, writes them to target/third-party.
 */

import { mkdirSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { ask, main, root, Stop } from "./run.mjs";
import { targetFolder } from "./setup.mjs";

/** Packages of the build whose code becomes part of the site. */
const bundledTools = [
  "rolldown",
  "vite",
  "workbox-core",
  "workbox-precaching",
  "workbox-routing",
  "workbox-strategies",
];

/**
 * @typedef {{ name: string, version: string, licence: string, texts: string[] }} Package
 *   A package with its licence expression and the texts of its licence files.
 * @typedef {{ text: string, packages: (Package & { copyright: string[] })[] }} Group
 *   Packages with the same licence text, except for their lines of copyright.
 */

/** Returns the packages of the site: scripts, font, and the crates of the wasm module. */
export const sitePackages = () => [...npmPackages(), ...wasmPackages()];

/** Returns the crates of the wasm module, which are those of the npm package. */
export const wasmPackages = () => [
  ...cratesOf("plantigrade-wasm", "wasm32-unknown-unknown"),
  rustLibrary(),
];

/** Returns the crates of the binary for this system. */
export const binaryPackages = () => nativePackages("plantigrade-cli");

/** Returns the crates of the Python package for this system. */
export const wheelPackages = () => nativePackages("plantigrade-python");

/** Returns packages, each name and version once. */
export function uniquePackages(packages) {
  const byName = new Map(packages.map((info) => [`${info.name} ${info.version}`, info]));
  return [...byName.values()];
}

function nativePackages(crate) {
  const host = /^host: (.+)$/m.exec(ask("rustc", ["-vV"]) ?? "")?.[1];
  if (!host) throw new Stop("rustc was not found. Run npm run build first.");
  return [...cratesOf(crate, host), rustLibrary()];
}

/** Returns the npm packages on which the site depends, and tools whose code it contains. */
function npmPackages() {
  const lock = JSON.parse(readFileSync(join(root, "package-lock.json"), "utf8"));
  const dependencies = Object.entries(lock.packages)
    .filter(([path, { dev }]) => path && !dev)
    .map(([path]) => path);
  const folders = [...dependencies, ...bundledTools.map((name) => `node_modules/${name}`)];
  return folders.map((folder) => {
    const path = join(root, folder);
    const { name, version, license } = JSON.parse(readFileSync(join(path, "package.json"), "utf8"));
    return { name, version, licence: license, texts: licenceTexts(name, path, license) };
  });
}

/** Returns the crates that are compiled into a crate of the workspace, without those that run at build time. */
function cratesOf(crate, platform) {
  const options = ["--format-version", "1", "--locked", "--offline"];
  const output = ask("cargo", ["metadata", ...options, "--filter-platform", platform]);
  if (!output) throw new Stop("The crates could not be listed. Run npm run build first.");
  const { packages, resolve } = JSON.parse(output);
  const packageOf = new Map(packages.map((info) => [info.id, info]));
  const nodeOf = new Map(resolve.nodes.map((node) => [node.id, node]));
  const found = new Set();
  const visit = (id) => {
    const isMacro = packageOf.get(id).targets.some(({ kind }) => kind.includes("proc-macro"));
    if (found.has(id) || isMacro) return;
    found.add(id);
    for (const { pkg, dep_kinds } of nodeOf.get(id).deps) {
      if (dep_kinds.some(({ kind }) => kind === null)) visit(pkg);
    }
  };
  visit(packages.find(({ name }) => name === crate).id);
  return [...found]
    .map((id) => packageOf.get(id))
    .filter(({ source }) => source)
    .map(({ name, version, license, manifest_path }) => ({
      name,
      version,
      licence: license.replaceAll("/", " OR "),
      texts: licenceTexts(name, dirname(manifest_path), license),
    }));
}

/** Returns the standard library of Rust, which has the licences of this project. */
function rustLibrary() {
  const toolchain = readFileSync(join(root, "rust-toolchain.toml"), "utf8");
  const version = /channel = "(.+)"/.exec(toolchain)?.[1] ?? "";
  const mit = readFileSync(join(root, "LICENSE-MIT"), "utf8");
  const text = mit.replace(/^Copyright.*$/m, "Copyright (c) The Rust Project Contributors");
  return {
    name: "Rust standard library",
    version,
    licence: "MIT OR Apache-2.0",
    texts: [text],
  };
}

/**
 * Returns the texts of the licence files in a folder. Where one can choose, MIT is chosen, because
 * its text is the shortest.
 */
function licenceTexts(name, folder, licence) {
  const files = readdirSync(folder).filter((file) =>
    /^(licen[cs]e|copying|notice|unlicense)/i.test(file),
  );
  const isChoice = /\bMIT\b/.test(licence) && files.some((file) => /mit/i.test(file));
  const chosen = files.filter((file) => !isChoice || /mit|notice|unicode|whatwg/i.test(file));
  if (!chosen.length) throw new Stop(`The package ${name} has no licence file.`);
  return chosen.map((file) =>
    readFileSync(join(folder, file), "utf8")
      .replace(/^\ufeff/, "")
      .replace(/\r\n?/g, "\n")
      // The licences of what a tool contains do not apply to what it adds to the site.
      .replace(/^# Licenses of bundled dependencies.*/ms, "")
      .trim(),
  );
}

/** Matches what precedes the terms of a licence: titles and lines of copyright. */
const head =
  /^(?:[^\S\n]*(?:(?:Copyright|\(c\)|©).*|\W*(?:the )?mit license(?: \(mit\))?\W*)?\n)+/i;

/** Separates the terms of a licence from lines of copyright. */
function splitCopyright(text) {
  const copyrightIn = (part) => part.match(/^\s*(?:Copyright|\(c\)|©).*\S/gim) ?? [];
  const start = head.exec(text)?.[0] ?? "";
  // The appendix of the Apache licence is a template, in which authors may enter their names.
  const isApache = /^\s*Apache License/.test(text);
  const appendixTitle = isApache ? /^\s*APPENDIX: How to apply/m : /$^/;
  const [terms = "", appendix = ""] = text.slice(start.length).split(appendixTitle);
  const lines = [...copyrightIn(start), ...copyrightIn(appendix)].map((line) => line.trim());
  return { terms: terms.trim(), copyright: lines.filter((line) => !/[[{]yyyy[\]}]/.test(line)) };
}

/** Groups packages by the text of their licence; lines of copyright are listed by package. */
export function groupByLicence(packages) {
  /** @type {Map<string, Group>} */
  const groups = new Map();
  const sorted = packages.toSorted((a, b) =>
    a.name.toLowerCase() < b.name.toLowerCase() ? -1 : 1,
  );
  for (const info of sorted) {
    for (const text of info.texts) {
      const { terms, copyright } = splitCopyright(text);
      const key = terms
        .toLowerCase()
        .replace(/[^a-z0-9]+/g, " ")
        .trim();
      const group = groups.get(key) ?? { text: terms, packages: [] };
      group.packages.push({ ...info, copyright });
      groups.set(key, group);
    }
  }
  return [...groups.values()].toSorted((a, b) => b.packages.length - a.packages.length);
}

const intro = (subject) => `${subject} contains the following software of others.`;

/** Returns notices as plain text. */
export function noticesText(packages, subject) {
  const groups = groupByLicence(packages).map(({ text, packages }) => {
    const list = packages.map(({ name, version, licence, copyright }) =>
      [`${name} ${version} (${licence})`, ...copyright.map((line) => `  ${line}`)].join("\n"),
    );
    return `${list.join("\n")}\n\n${text}\n`;
  });
  return `${intro(subject)}\n\n${groups.join(`\n${"-".repeat(80)}\n\n`)}`;
}

/** Returns the licence that all packages of a group have in common, MIT if they can choose it. */
function titleOf(packages) {
  const lists = packages.map(({ licence }) => licence.match(/[\w.-]+/g) ?? []);
  const common = (lists[0] ?? []).filter(
    (name) => !/^(AND|OR|WITH)$/.test(name) && lists.every((list) => list.includes(name)),
  );
  return common.includes("MIT") ? "MIT" : common.join(" and ");
}

const escapeHtml = (text) =>
  text.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(">", "&gt;");

/** Returns notices as a page. */
export function noticesHtml(packages, subject) {
  const sections = groupByLicence(packages).map(({ text, packages }) => {
    const items = packages.map(({ name, version, licence, copyright }) => {
      const lines = copyright.map((line) => `<br>${escapeHtml(line)}`).join("");
      return `<li><b>${escapeHtml(name)}</b> ${escapeHtml(version)} (${escapeHtml(licence)})${lines}</li>`;
    });
    return `<section>
<h2>${escapeHtml(titleOf(packages))}</h2>
<ul>
${items.join("\n")}
</ul>
<pre tabindex="0">${escapeHtml(text)}</pre>
</section>`;
  });
  return `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="dark light">
<title>Third-party software – ${escapeHtml(subject)}</title>
<style>
body { max-width: 80ch; margin: 0 auto; padding: 24px 16px; font: 15px / 1.5 system-ui, sans-serif; overflow-wrap: anywhere; }
h1 { font-size: 22px; }
h2 { margin-top: 40px; font-size: 17px; }
li { margin: 6px 0; }
pre { padding: 12px; overflow-x: auto; border: 1px solid; border-radius: 6px; font: 12px / 1.5 ui-monospace, monospace; }
</style>
</head>
<body>
<main>
<h1>Third-party software</h1>
<p>${escapeHtml(intro(subject))}</p>
${sections.join("\n")}
</main>
</body>
</html>
`;
}

/** Folder of the notices of the site, which its build reads. */
const siteFolder = join(root, "web/third-party");

/** Writes the notices of the site. */
export function writeSiteNotices() {
  const packages = sitePackages();
  mkdirSync(siteFolder, { recursive: true });
  writeFileSync(join(siteFolder, "notices.html"), noticesHtml(packages, "Plantigrade"));
  writeFileSync(join(siteFolder, "notices.txt"), noticesText(packages, "Plantigrade"));
}

if (process.argv[1] === import.meta.filename) {
  await main(async () => {
    const folder = join(targetFolder(), "third-party");
    mkdirSync(folder, { recursive: true });
    for (const [name, packages] of [
      ["site", sitePackages()],
      ["npm", wasmPackages()],
      ["python", uniquePackages([...wheelPackages(), ...sitePackages()])],
      ["binary", binaryPackages()],
    ]) {
      writeFileSync(join(folder, `${name}.txt`), noticesText(packages, "Plantigrade"));
    }
    console.log(`\nThe notices are in ${folder}.`);
  });
}
