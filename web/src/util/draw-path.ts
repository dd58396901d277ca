/** Draws the lines of the current path; `lineWidth` is in units of the context. */
export function drawPath(ctx: CanvasRenderingContext2D, color: string, lineWidth: number) {
  ctx.strokeStyle = color;
  ctx.lineWidth = lineWidth;
  ctx.stroke();
}
