/** Public source of a clip. */
export type Origin = { kind: "url"; url: string } | { kind: "sample"; name: string };

/** A parsed address hash: `#sample=name&t=1.25` or `#t=1.25&url=https://…`. */
export interface Link {
  origin: Origin;
  /** View state as text, not parsed yet. */
  view: string;
}

/** Parses the hash of an address. Returns undefined if it names no clip. */
export function parseHash(hash: string): Link | undefined {
  const text = hash.replace(/^#/, "");
  // A pasted address is rarely percent-encoded: everything after `url=` belongs to it.
  const [, prefix = "", address] = text.match(/^(|.*?&)url=(.*)$/s) ?? [];
  if (address !== undefined) {
    const url = decode(address);
    return url ? { origin: { kind: "url", url }, view: prefix.slice(0, -1) } : undefined;
  }
  const parts = text.split("&");
  const name = new URLSearchParams(text).get("sample");
  const others = parts.filter((part) => !part.startsWith("sample="));
  return name ? { origin: { kind: "sample", name }, view: others.join("&") } : undefined;
}

/** Formats a link as the hash of an address. */
export function formatHash({ origin, view }: Link): string {
  if (origin.kind === "sample") {
    return `#sample=${encodeURIComponent(origin.name)}${view && `&${view}`}`;
  }
  // Left readable unless that would be ambiguous.
  const url = /[%\s#]/.test(origin.url) ? encodeURIComponent(origin.url) : origin.url;
  return `#${view && `${view}&`}url=${url}`;
}

/** Returns the file name at the end of a URL, or the host if there is none. */
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
