/** Returns a file name without the extension `.bvh`. */
export const stemOf = (name: string) => name.replace(/\.bvh$/i, "");

/** Makes names unique by appending numbers, ignoring case. */
export function uniqueNames(names: readonly string[]): string[] {
  const used = new Set<string>();
  return names.map((name) => {
    let unique = name;
    for (let n = 2; used.has(unique.toLowerCase()); n++) unique = `${name}-${n}`;
    used.add(unique.toLowerCase());
    return unique;
  });
}

/** True for the companion files and folders that macOS adds to archives. */
export const isMacCompanion = (path: string) => /(^|\/)(__MACOSX(\/|$)|\._)/.test(path);
