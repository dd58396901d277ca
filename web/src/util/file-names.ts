/** Returns a file name without the extension `.bvh`. */
export const stemOf = (name: string) => name.replace(/\.bvh$/i, "");

/** Makes names unique by appending numbers, ignoring case and the encoding of accents. */
export function uniqueNames(names: readonly string[]): string[] {
  const used = new Set<string>();
  const keyOf = (name: string) => name.normalize("NFC").toLowerCase();
  return names.map((name) => {
    let unique = name;
    for (let n = 2; used.has(keyOf(unique)); n++) unique = `${name}-${n}`;
    used.add(keyOf(unique));
    return unique;
  });
}

/** Returns the last part of a path of any system. */
export const baseNameOf = (path: string) => path.slice(path.search(/[^/\\]*$/));

/** Names of devices on Windows, with any extension. */
const reservedName = /^(con|prn|aux|nul|conin\$|conout\$|(com|lpt)[0-9¹²³])(?=\s*(\.|$))/i;

/** Characters that a file system does not allow, and those that hide how a name reads. */
const unsafeCharacters = /[\p{Cc}\p{Cf}\p{Zl}\p{Zp}<>:"/\\|?*]/gu;

/** File systems allow 255 bytes; a number and an extension may follow. */
const maxNameBytes = 200;

/** Returns a name that every file system allows, for a file or for the start of its name. */
export function safeFileName(name: string): string {
  const clean = baseNameOf(name.replace(/^\s*[a-z]:/i, ""))
    .toWellFormed()
    .replace(unsafeCharacters, "_")
    .replace(/^\s+|[\s.]+$/g, "")
    // Commands take such a name for an option.
    .replace(/^-/, "_")
    .replace(reservedName, "_$1");
  return shorten(clean) || "clip";
}

/** Shortens a name in its middle, so that its extension remains. */
function shorten(name: string): string {
  return startOf(name, maxNameBytes) === name
    ? name
    : `${startOf(name, maxNameBytes - 100)}…${name.slice(-24)}`.toWellFormed();
}

/** Returns the start of a text that is at most a number of bytes long in UTF-8. */
export const startOf = (text: string, bytes: number) =>
  text.slice(0, new TextEncoder().encodeInto(text, new Uint8Array(bytes)).read);

/** True for the companion files and folders that macOS adds to archives. */
export const isMacCompanion = (path: string) => /(^|\/)(__MACOSX(\/|$)|\._)/.test(path);
