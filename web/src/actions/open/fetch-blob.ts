import { downloadUrl } from "../../model/sources/link";
import type { OnProgress } from "../../model/types";
import { formatBytes } from "../../util/format";

/** Downloads a file of at most `maxBytes`. Errors explain why it could not be downloaded. */
export async function fetchBlob(
  url: string,
  signal: AbortSignal,
  maxBytes: number,
  onProgress: (fraction: Parameters<OnProgress>[0] | undefined) => void,
): Promise<Blob> {
  const { host } = downloadUrl(url, location.href);
  let response: Response;
  try {
    response = await fetch(url, { signal, credentials: "omit" });
  } catch (error) {
    if (signal.aborted) throw error;
    throw new Error(
      navigator.onLine
        ? `No answer from ${host}: it cannot be reached, or it does not let other sites read this file (CORS).`
        : "This computer is offline.",
    );
  }
  if (!response.ok)
    throw new Error(`The server answered ${response.status} ${response.statusText}.`);
  const total = Number(response.headers.get("content-length"));
  if (total > maxBytes)
    throw new Error(`The file has ${formatBytes(total)}; the limit is ${formatBytes(maxBytes)}.`);
  if (!response.body) return response.blob();
  const parts: BlobPart[] = [];
  const reader = response.body.getReader();
  let received = 0;
  for (;;) {
    const { done, value } = await reader.read();
    if (done) return new Blob(parts);
    parts.push(value);
    received += value.byteLength;
    if (received > maxBytes) {
      await reader.cancel();
      throw new Error(`The file has more than ${formatBytes(maxBytes)}, the limit.`);
    }
    // A compressed body is longer than its content-length; the fraction is then unknown.
    onProgress(total && received <= total ? received / total : undefined);
  }
}
