import type { Failure } from "../types";

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
    return { origin: { kind: "url", url: decode(address) }, view: prefix.slice(0, -1) };
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

/**
 * Returns the URL of a file to download. Throws a failure if the address is invalid or of a kind
 * that cannot be downloaded. An address without a scheme is relative to `page`.
 */
export function downloadUrl(address: string, page: string): URL {
  const hint =
    "A link to a clip ends with #url= and the https address of a BVH file, such as #url=https://example.org/walk.bvh.";
  const fail = (message: string): Failure => ({ message, hint });
  const shown = `“${address.slice(0, 80)}${address.length > 80 ? "…" : ""}”`;
  if (!address.trim()) throw fail("The link contains no address of a clip.");
  const isAbsolute = /^\s*[a-z][a-z0-9+.-]*:/i.test(address);
  const url = parseUrl(address, isAbsolute ? undefined : page);
  if (!url) throw fail(`The address in the link, ${shown}, is not valid.`);
  // The content security policy of the page allows http for its own site only.
  const isOfPage = url.protocol === "http:" && url.origin === new URL(page).origin;
  if (url.protocol !== "https:" && !isOfPage)
    throw fail(
      `The address in the link, ${shown}, starts with “${url.protocol}”. Only https addresses can be downloaded.`,
    );
  if (url.username || url.password)
    throw fail(
      `The address in the link contains a user name or a password, which a page cannot send.`,
    );
  return url;
}

/** Returns the file name at the end of a URL, or the host if there is none. */
export function fileNameOfUrl(url: string): string {
  try {
    const { protocol, pathname, hostname } = new URL(url);
    if (!/^https?:$/.test(protocol)) return "The link";
    return decode(pathname.split("/").pop() ?? "") || hostname || url;
  } catch {
    return url || "The link";
  }
}

function parseUrl(address: string, base?: string): URL | undefined {
  try {
    return new URL(address, base);
  } catch {
    return undefined;
  }
}

function decode(text: string): string {
  try {
    return /%[0-9a-f]{2}/i.test(text) ? decodeURIComponent(text) : text;
  } catch {
    return text;
  }
}
