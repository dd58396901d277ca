/** Where a clip can be had from by anyone. */
export type Origin = { kind: "url"; url: string } | { kind: "sample"; name: string };

/** What the address asks for: `#sample=name&t=1.25` or `#t=1.25&url=https://…`. */
export interface Link {
  origin: Origin;
  /** How the clip is to be shown, not read yet. */
  view: string;
}

export function parseHash(hash: string): Link | undefined {
  const text = hash.replace(/^#/, "");
  // A pasted address is rarely percent-encoded: everything after `url=` belongs to it.
  const [, showing = "", rest] = text.match(/^(|.*?&)url=(.*)$/s) ?? [];
  if (rest !== undefined) {
    const url = decode(rest);
    return url ? { origin: { kind: "url", url }, view: showing.slice(0, -1) } : undefined;
  }
  const parts = text.split("&");
  const name = new URLSearchParams(text).get("sample");
  const others = parts.filter((part) => !part.startsWith("sample="));
  return name ? { origin: { kind: "sample", name }, view: others.join("&") } : undefined;
}

/** The same the other way round. */
export function formatHash({ origin, view }: Link): string {
  if (origin.kind === "sample") {
    return `#sample=${encodeURIComponent(origin.name)}${view && `&${view}`}`;
  }
  // Readable, unless it could be misread.
  const url = /[%\s#]/.test(origin.url) ? encodeURIComponent(origin.url) : origin.url;
  return `#${view && `${view}&`}url=${url}`;
}

/** The file name at the end of an address. */
export function fileNameOfUrl(url: string): string {
  try {
    const { pathname, hostname } = new URL(url);
    return decode(pathname.split("/").pop() ?? "") || hostname;
  } catch {
    return url;
  }
}

function decode(text: string): string {
  try {
    return /%[0-9a-f]{2}/i.test(text) ? decodeURIComponent(text) : text;
  } catch {
    return text;
  }
}
