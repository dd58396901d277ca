import type { Stoppable } from "../worker";
import { type Work, work } from "./state";

/** Lets the worker do what may take long: tells how far it is, and lets a person stop it. */
export async function withProgress<T>(
  about: Pick<Work, "what" | "name">,
  controller: AbortController,
  run: (stoppable: Stoppable) => Promise<T>,
  onStop = () => {},
): Promise<T> {
  const stop = () => {
    controller.abort();
    remove();
    onStop();
  };
  let here: Work = { ...about, stop };
  const remove = () => {
    work.value = work.value.filter((other) => other !== here);
  };
  work.value = [...work.value, here];
  const onProgress = (share: number) => {
    const before = here;
    here = { ...about, stop, share };
    work.value = work.value.map((other) => (other === before ? here : other));
  };
  try {
    return await run({ signal: controller.signal, onProgress });
  } finally {
    remove();
  }
}
