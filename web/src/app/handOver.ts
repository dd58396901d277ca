import { Cancelled } from "../worker";
import { failTo } from "./failing";
import { announcement } from "./state";

/** Hands what is made to the browser as a download. */
export async function handOver(file: string, make: () => Promise<Blob>): Promise<void> {
  try {
    const url = URL.createObjectURL(await make());
    const link = document.createElement("a");
    link.href = url;
    link.download = file;
    link.click();
    setTimeout(() => URL.revokeObjectURL(url), 10_000);
    announcement.value = `Saved ${file}`;
  } catch (error) {
    if (error instanceof Cancelled || (error instanceof Error && error.name === "AbortError"))
      return;
    failTo("saved", file, error);
  }
}
