import { bytes } from "../lib/time";

/** Downloads a file, telling the share that has come; says in words why it could not. */
export async function fetchBlob(
  url: string,
  signal: AbortSignal,
  limit: number,
  onProgress: (share: number | undefined) => void,
): Promise<Blob> {
  if (new URL(url, location.href).protocol === "http:" && location.protocol === "https:") {
    throw new Error("The link starts with http: only https links can be opened from here.");
  }
  let response: Response;
  try {
    response = await fetch(url, { signal, credentials: "omit" });
  } catch (error) {
    if (signal.aborted) throw error;
    const host = new URL(url, location.href).host;
    throw new Error(
      navigator.onLine
        ? `No answer from ${host}: it cannot be reached, or it does not let other sites read this file (CORS).`
        : "This computer is offline.",
    );
  }
  if (!response.ok)
    throw new Error(`The server answered ${response.status} ${response.statusText}.`);
  const total = Number(response.headers.get("content-length"));
  if (total > limit) throw new Error(`The file has ${bytes(total)}; the limit is ${bytes(limit)}.`);
  if (!response.body) return response.blob();
  const parts: BlobPart[] = [];
  const reader = response.body.getReader();
  let got = 0;
  for (;;) {
    const { done, value } = await reader.read();
    if (done) return new Blob(parts);
    parts.push(value);
    got += value.byteLength;
    if (got > limit) {
      await reader.cancel();
      throw new Error(`The file has more than ${bytes(limit)}, the limit.`);
    }
    // A compressed body is longer than its header says: then the share means nothing.
    onProgress(total && got <= total ? got / total : undefined);
  }
}
