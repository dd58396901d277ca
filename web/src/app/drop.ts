import { filesOfTransfer } from "../actions/collect-files";
import { openFiles } from "../actions/open-files";
import { messageOf, reportOpenFailure } from "../store/errors";
import { filesDragged } from "../store/view";

/** Files dropped anywhere on the page, or pasted into it. */
export function listenForDrops(signal: AbortSignal) {
  // Each element left is another one entered: only when all are left the files are gone.
  const inside = new Set<EventTarget>();
  const hasFiles = (event: DragEvent) => event.dataTransfer?.types.includes("Files") ?? false;
  const over = (event: DragEvent) => {
    if (!hasFiles(event)) return;
    event.preventDefault();
    if (event.dataTransfer) event.dataTransfer.dropEffect = "copy";
  };
  const settle = () => {
    filesDragged.value = inside.size > 0;
  };
  addEventListener(
    "dragenter",
    (event) => {
      if (!hasFiles(event) || !event.target) return;
      event.preventDefault();
      inside.add(event.target);
      settle();
    },
    { signal },
  );
  addEventListener(
    "dragleave",
    (event) => {
      if (event.target) inside.delete(event.target);
      // What was removed while it was entered never leaves by itself.
      for (const at of inside) if (at instanceof Node && !at.isConnected) inside.delete(at);
      settle();
    },
    { signal },
  );
  addEventListener("dragover", over, { signal });
  addEventListener(
    "drop",
    (event) => {
      if (!hasFiles(event)) return;
      event.preventDefault();
      inside.clear();
      settle();
      if (!event.dataTransfer) return;
      void filesOfTransfer(event.dataTransfer).then(openFiles, (error) =>
        reportOpenFailure("What was dropped", { message: messageOf(error) }),
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
