import { strToU8, Zip, ZipDeflate } from "fflate";

/** Writes a zip archive. Files are compressed when they are added, so that uncompressed texts do not accumulate. */
export class ZipWriter {
  private readonly chunks: Uint8Array<ArrayBuffer>[] = [];
  private readonly zip = new Zip((error, chunk) => {
    if (error) throw error;
    this.chunks.push(chunk as Uint8Array<ArrayBuffer>);
  });

  add(name: string, data: string | Uint8Array) {
    const entry = new ZipDeflate(name, { level: 6 });
    this.zip.add(entry);
    entry.push(typeof data === "string" ? strToU8(data) : data, true);
  }

  finish(): Blob {
    this.zip.end();
    return new Blob(this.chunks, { type: "application/zip" });
  }
}
