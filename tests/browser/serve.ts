/** A static file server without rewriting or a fallback page. */

import { readFile } from "node:fs/promises";
import { createServer } from "node:http";
import type { AddressInfo } from "node:net";
import { extname, join, normalize } from "node:path";
import { root } from "./clips";

const types: Record<string, string> = {
  ".html": "text/html; charset=utf-8",
  ".js": "text/javascript; charset=utf-8",
  ".css": "text/css; charset=utf-8",
  ".svg": "image/svg+xml",
  ".png": "image/png",
  ".webmanifest": "application/manifest+json",
  ".json": "application/json",
  ".wasm": "application/wasm",
  ".woff2": "font/woff2",
  ".bvh": "text/plain; charset=utf-8",
};

export interface Site {
  origin: string;
  /** URL of the page. */
  home: string;
  close(): Promise<void>;
}

/** Serves the site from a subfolder that its build does not know, and the samples from another. */
export async function serve(site = join(root, "web/dist")): Promise<Site> {
  const folders = { "/deep/sub/": site, "/clips/": join(root, "samples") };
  const server = createServer(async (request, response) => {
    try {
      const path = fileOf(new URL(request.url ?? "/", "http://host").pathname, folders);
      const body = await readFile(path);
      const type = types[extname(path)] ?? "application/octet-stream";
      response.writeHead(200, { "content-type": type, "content-length": body.length }).end(body);
    } catch {
      response.writeHead(404, { "content-type": "text/plain" }).end("File not found.");
    }
  });
  await new Promise<void>((resolve) => server.listen(0, "127.0.0.1", resolve));
  const origin = `http://127.0.0.1:${(server.address() as AddressInfo).port}`;
  return {
    origin,
    home: `${origin}/deep/sub/`,
    close: () => {
      server.closeAllConnections();
      return new Promise((resolve) => server.close(() => resolve()));
    },
  };
}

function fileOf(url: string, folders: Record<string, string>): string {
  const path = normalize(decodeURIComponent(url));
  for (const [prefix, folder] of Object.entries(folders)) {
    if (path.startsWith(prefix)) return join(folder, path.slice(prefix.length) || "index.html");
  }
  throw new Error("outside");
}
