import type uPlot from "uplot";
import type { PlotData } from "./plot-data";

export type DragLine = ReturnType<typeof createDragLine>;

/** The grip of a level that can be dragged up and down: an element of its own, wide enough for a finger. */
export function createDragLine(plot: uPlot, host: HTMLElement) {
  const grip = document.createElement("div");
  grip.className = "drag-line";
  const text = document.createElement("b");
  grip.append(text);
  plot.over.append(grip);
  let shown: PlotData["level"];
  const drag = (event: PointerEvent) => {
    event.stopPropagation();
    if (event.type === "pointerdown") {
      grip.setPointerCapture(event.pointerId);
      // The slider is the way of the keyboard; the plot's own keys should not be lost either.
      event.preventDefault();
      host.focus({ preventScroll: true });
    }
    if (!grip.hasPointerCapture(event.pointerId)) return;
    const top = event.clientY - plot.over.getBoundingClientRect().top;
    shown?.set(plot.posToVal(top, "y"));
  };
  grip.addEventListener("pointerdown", drag);
  grip.addEventListener("pointermove", drag);
  grip.addEventListener("click", (event) => event.stopPropagation());
  return {
    show({ level }: PlotData) {
      shown = level;
      grip.hidden = !level;
      if (!level) return;
      grip.style.translate = `0 ${plot.valToPos(level.at, "y")}px`;
      if (text.textContent !== level.text) text.textContent = level.text;
    },
  };
}
