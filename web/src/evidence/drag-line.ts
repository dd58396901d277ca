import type uPlot from "uplot";
import type { PlotData } from "./plot-data";

export type DragLine = ReturnType<typeof createDragLine>;

/** Creates the handle of a draggable horizontal line, large enough to touch. */
export function createDragLine(plot: uPlot, host: HTMLElement) {
  const handle = document.createElement("div");
  handle.className = "drag-line";
  const label = document.createElement("b");
  handle.append(label);
  plot.over.append(handle);
  let current: PlotData["dragLine"];
  const onDrag = (event: PointerEvent) => {
    event.stopPropagation();
    if (event.type === "pointerdown") {
      handle.setPointerCapture(event.pointerId);
      // The keyboard alternative is the slider, so the handle is not focusable; keys still reach the plot.
      event.preventDefault();
      host.focus({ preventScroll: true });
    }
    if (!handle.hasPointerCapture(event.pointerId)) return;
    const top = event.clientY - plot.over.getBoundingClientRect().top;
    current?.onDrag(plot.posToVal(top, "y"));
  };
  handle.addEventListener("pointerdown", onDrag);
  handle.addEventListener("pointermove", onDrag);
  handle.addEventListener("click", (event) => event.stopPropagation());
  return {
    update({ dragLine }: PlotData) {
      current = dragLine;
      handle.hidden = !dragLine;
      if (!dragLine) return;
      handle.style.translate = `0 ${plot.valToPos(dragLine.value, "y")}px`;
      if (label.textContent !== dragLine.label) label.textContent = dragLine.label;
    },
  };
}
