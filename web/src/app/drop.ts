import { openFiles } from "../actions/open/open-files";
import { filesOfTransfer } from "../actions/open/transfer";
import { failureOf } from "../model/failure";
import { reportOpenFailure } from "../store/errors";
import { filesDragged } from "../store/view";

/** Opens files that are dropped anywhere on the page or pasted, until `signal` aborts. */
export function listenForDrops(signal: AbortSignal) {
  // `dragenter` of an element precedes `dragleave` of the previous one: the files have left the page
  // when no entered element remains.
  const entered = new Set<EventTarget>();
  const hasFiles = (event: DragEvent) => event.dataTransfer?.types.includes("Files") ?? false;
  const onDragOver = (event: DragEvent) => {
    if (!hasFiles(event)) return;
    event.preventDefault();
    if (event.dataTransfer) event.dataTransfer.dropEffect = "copy";
  };
  const updateDragged = () => {
    filesDragged.value = entered.size > 0;
  };
  addEventListener(
    "dragenter",
    (event) => {
      if (!hasFiles(event) || !event.target) return;
      event.preventDefault();
      entered.add(event.target);
      updateDragged();
    },
    { signal },
  );
  addEventListener(
    "dragleave",
    (event) => {
      if (event.target) entered.delete(event.target);
      // Elements that were removed from the page get no `dragleave`.
      for (const element of entered) {
        if (element instanceof Node && !element.isConnected) entered.delete(element);
      }
      updateDragged();
    },
    { signal },
  );
  addEventListener("dragover", onDragOver, { signal });
  addEventListener(
    "drop",
    (event) => {
      if (!hasFiles(event)) return;
      event.preventDefault();
      entered.clear();
      updateDragged();
      if (!event.dataTransfer) return;
      void filesOfTransfer(event.dataTransfer).then(openFiles, (error) =>
        reportOpenFailure("The dropped files", failureOf(error)),
      );
    },
    { signal },
  );
  addEventListener(
    "paste",
    (event) => {
      const files = [...(event.clipboardData?.files ?? [])];
      if (!files.length) return;
      event.preventDefault();
      void openFiles({ files });
    },
    { signal },
  );
}
