/** A file's name without the ending of clips. */
export const stemOf = (name: string) => name.replace(/\.bvh$/i, "");

/** The names, each followed by a number where one before is the same. */
export function uniqueNames(names: readonly string[]): string[] {
  const taken = new Set<string>();
  return names.map((name) => {
    let free = name;
    for (let n = 2; taken.has(free.toLowerCase()); n++) free = `${name}-${n}`;
    taken.add(free.toLowerCase());
    return free;
  });
}
