export type Link = { kind: "url"; url: string } | { kind: "sample"; name: string };

/** What the address asks for: `#url=https://…` or `#sample=name`. */
export function parseHash(hash: string): Link | undefined {
  const text = hash.replace(/^#/, "");
  // A pasted address is rarely percent-encoded: everything after `url=` belongs to it.
  if (text.startsWith("url=")) {
    const url = decode(text.slice(4));
    return url ? { kind: "url", url } : undefined;
  }
  const name = new URLSearchParams(text).get("sample");
  return name ? { kind: "sample", name } : undefined;
}

/** The file name at the end of an address. */
export function nameOfUrl(url: string): string {
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
