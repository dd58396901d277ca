/** Line charts with two logarithmic axes, as SVG. Power laws appear as straight lines. */

const WIDTH = 780;
const HEIGHT = 380;
const LEFT = 90;
const RIGHT = 40;
const TOP = 44;
const BOTTOM = 48;
/** Line colours, distinguishable with colour blindness; the same as in the figures of RESULTS.md. */
const COLOURS = ["#0b6fc2", "#b35300", "#0a7d56", "#8e44ad"];

/**
 * Returns a chart. `series` are `{ label, points: [x, y][] }`; `x` and `y` are `{ title, text }`, where
 * `text` formats a tick.
 */
export function lineChart({ title, x, y, series }) {
  const allPoints = series.flatMap(({ points }) => points);
  const xAxis = logAxis(
    allPoints.map((point) => point[0]),
    LEFT,
    WIDTH - RIGHT,
  );
  const yAxis = logAxis(
    allPoints.map((point) => point[1]),
    HEIGHT - BOTTOM,
    TOP,
  );
  const text = (content, at, anchor, attributes = "") =>
    `<text x="${at[0]}" y="${at[1]}" text-anchor="${anchor}"${attributes}>${content}</text>`;
  const line = (from, to) =>
    `<line x1="${from[0]}" y1="${from[1]}" x2="${to[0]}" y2="${to[1]}" stroke="#e1e5ea"/>`;
  const parts = [text(title, [WIDTH / 2, 22], "middle", ' font-size="14"')];
  for (const value of xAxis.ticks) {
    const position = xAxis.at(value);
    parts.push(line([position, TOP], [position, HEIGHT - BOTTOM]));
    parts.push(text(x.text(value), [position, HEIGHT - BOTTOM + 16], "middle"));
  }
  for (const value of yAxis.ticks) {
    const position = yAxis.at(value);
    parts.push(line([LEFT, position], [WIDTH - RIGHT, position]));
    parts.push(text(y.text(value), [LEFT - 8, position + 4], "end"));
  }
  parts.push(text(x.title, [(LEFT + WIDTH - RIGHT) / 2, HEIGHT - 10], "middle"));
  const rotation = ` transform="rotate(-90 16 ${HEIGHT / 2})"`;
  parts.push(text(y.title, [16, HEIGHT / 2], "middle", rotation));
  series.forEach(({ label, points }, index) => {
    const colour = COLOURS[index % COLOURS.length];
    const positions = points.map((point) => [xAxis.at(point[0]), yAxis.at(point[1])]);
    const lineStyle = `stroke="${colour}" stroke-width="2"`;
    const path = `<polyline points="${positions.join(" ")}" fill="none" ${lineStyle}/>`;
    const dots = positions.map(
      ([cx, cy]) => `<circle cx="${cx}" cy="${cy}" r="3" fill="${colour}"/>`,
    );
    const legendY = TOP + 16 + 18 * index;
    const legendLine = `<line x1="${LEFT + 12}" y1="${legendY - 4}" x2="${LEFT + 30}" y2="${legendY - 4}" ${lineStyle}/>`;
    parts.push(path, ...dots, legendLine, text(label, [LEFT + 36, legendY], "start"));
  });
  const size = `width="${WIDTH}" height="${HEIGHT}" viewBox="0 0 ${WIDTH} ${HEIGHT}"`;
  return `<svg ${size} xmlns="http://www.w3.org/2000/svg" font-family="sans-serif" font-size="12">
<rect width="${WIDTH}" height="${HEIGHT}" fill="#ffffff"/>
${parts.join("\n")}
</svg>
`;
}

/** Returns the ticks of a logarithmic axis (powers of ten), and a function from values to pixels. */
function logAxis(values, from, to) {
  const low = Math.floor(Math.log10(Math.min(...values)));
  const high = Math.max(low + 1, Math.ceil(Math.log10(Math.max(...values))));
  return {
    ticks: Array.from({ length: high - low + 1 }, (_, step) => 10 ** (low + step)),
    at: (value) => round(from + ((Math.log10(value) - low) / (high - low)) * (to - from)),
  };
}

const round = (value) => Math.round(value * 10) / 10;
