/** A server behind a slow network, with the figures of Lighthouse's "slow 4G". */

import { existsSync, readFileSync, statSync } from "node:fs";
import { createServer } from "node:http";
import { extname, join, normalize } from "node:path";
import { setTimeout as delay } from "node:timers/promises";
import { brotliCompressSync, constants } from "node:zlib";

/** Bytes per millisecond: 1.6 Mbit/s. */
const RATE = 200;
/** Time until the first byte of a response, in milliseconds. */
const LATENCY = 150;
const CHUNK_BYTES = 4096;

const TYPES = {
  ".html": "text/html",
  ".js": "text/javascript",
  ".css": "text/css",
  ".svg": "image/svg+xml",
  ".wasm": "application/wasm",
};

/** Serves a folder with Brotli compression, as static hosts do. All responses share the network. */
export async function serveSlowly(folder) {
  const compressed = new Map();
  const content = (file) => {
    if (!compressed.has(file)) {
      const params = { [constants.BROTLI_PARAM_QUALITY]: 11 };
      compressed.set(file, brotliCompressSync(readFileSync(file), { params }));
    }
    return compressed.get(file);
  };
  /** Time at which the network has transferred everything so far. */
  let idleFrom = 0;
  const transfer = async (bytes) => {
    const now = performance.now();
    idleFrom = Math.max(idleFrom, now) + bytes / RATE;
    await delay(idleFrom - now);
  };
  const server = createServer(async (request, response) => {
    const path = normalize(decodeURIComponent(new URL(request.url, "http://localhost").pathname));
    const file = join(folder, path.endsWith("/") ? `${path}index.html` : path);
    await delay(LATENCY);
    if (!existsSync(file) || !statSync(file).isFile()) {
      response.writeHead(404, { "content-type": "text/html" });
      response.end("Not found");
      return;
    }
    const type = TYPES[extname(file)] ?? "application/octet-stream";
    response.writeHead(200, { "content-type": type, "content-encoding": "br" });
    const bytes = content(file);
    for (let start = 0; start < bytes.length; start += CHUNK_BYTES) {
      const chunk = bytes.subarray(start, start + CHUNK_BYTES);
      await transfer(chunk.length);
      response.write(chunk);
    }
    response.end();
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  return {
    address: `http://127.0.0.1:${server.address().port}/`,
    close: () => new Promise((resolve) => server.close(resolve)),
  };
}
