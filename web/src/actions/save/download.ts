import { Cancelled, Superseded } from "../../engine";
import { failureOf } from "../../model/failure";
import { session } from "../../store/clip-session";
import { reportFailure } from "../../store/errors";
import { announce } from "../../store/view";
import { safeFileName } from "../../util/file-names";

/**
 * Downloads a file to the user's computer, under a name that every system allows. The file is made when all edits
 * so far are applied.
 */
export async function download(name: string, make: () => Promise<Blob>): Promise<void> {
  const fileName = safeFileName(name);
  try {
    await session.value.editsDone();
    const url = URL.createObjectURL(await make());
    const link = document.createElement("a");
    link.href = url;
    link.download = fileName;
    link.click();
    setTimeout(() => URL.revokeObjectURL(url), 10_000);
    announce(`Saved ${fileName}`);
  } catch (error) {
    const isAborted = error instanceof Error && error.name === "AbortError";
    const isCancelled = error instanceof Cancelled && !(error instanceof Superseded);
    if (isCancelled || isAborted) return;
    reportFailure("saved", fileName, failureOf(error), () => void download(fileName, make));
  }
}

/**
 * Returns a function that makes a file of the open clip, once `ready` resolves. It fails if another clip is open by
 * then, since its file would have the name of this one.
 */
export function ofOpenClip<T>(make: () => Promise<T>, ready = async () => {}): () => Promise<T> {
  const { signal } = session.value;
  return async () => {
    await ready();
    if (signal.aborted) throw new Superseded();
    return make();
  };
}
