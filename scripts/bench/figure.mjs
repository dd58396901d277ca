/** A figure of lines over two logarithmic axes, as SVG: on those, what grows in proportion is straight. */

const WIDTH = 780;
const HEIGHT = 380;
const LEFT = 90;
const RIGHT = 40;
const TOP = 44;
const BOTTOM = 48;
/** Colours that differ for everyone, in order; those of the results' figures. */
const COLOURS = ["#0b6fc2", "#b35300", "#0a7d56", "#8e44ad"];

/** `series` are `{ label, points: [x, y][] }`; `x` and `y` are `{ title, text }`, where `text` writes a value. */
export function figure({ title, x, y, series }) {
  const all = series.flatMap((one) => one.points);
  const across = axis(
    all.map((point) => point[0]),
    LEFT,
    WIDTH - RIGHT,
  );
  const up = axis(
    all.map((point) => point[1]),
    HEIGHT - BOTTOM,
    TOP,
  );
  const text = (words, at, anchor, more = "") =>
    `<text x="${at[0]}" y="${at[1]}" text-anchor="${anchor}"${more}>${words}</text>`;
  const line = (from, to) =>
    `<line x1="${from[0]}" y1="${from[1]}" x2="${to[0]}" y2="${to[1]}" stroke="#e1e5ea"/>`;
  const parts = [text(title, [WIDTH / 2, 22], "middle", ' font-size="14"')];
  for (const value of across.ticks) {
    const place = across.at(value);
    parts.push(line([place, TOP], [place, HEIGHT - BOTTOM]));
    parts.push(text(x.text(value), [place, HEIGHT - BOTTOM + 16], "middle"));
  }
  for (const value of up.ticks) {
    const place = up.at(value);
    parts.push(line([LEFT, place], [WIDTH - RIGHT, place]));
    parts.push(text(y.text(value), [LEFT - 8, place + 4], "end"));
  }
  parts.push(text(x.title, [(LEFT + WIDTH - RIGHT) / 2, HEIGHT - 10], "middle"));
  const turned = ` transform="rotate(-90 16 ${HEIGHT / 2})"`;
  parts.push(text(y.title, [16, HEIGHT / 2], "middle", turned));
  series.forEach(({ label, points }, index) => {
    const colour = COLOURS[index % COLOURS.length];
    const places = points.map((point) => [across.at(point[0]), up.at(point[1])]);
    const path = `<polyline points="${places.join(" ")}" fill="none" stroke="${colour}" stroke-width="2"/>`;
    const dots = places.map(([cx, cy]) => `<circle cx="${cx}" cy="${cy}" r="3" fill="${colour}"/>`);
    const key = TOP + 16 + 18 * index;
    const sample = `<line x1="${LEFT + 12}" y1="${key - 4}" x2="${LEFT + 30}" y2="${key - 4}" stroke="${colour}" stroke-width="2"/>`;
    parts.push(path, ...dots, sample, text(label, [LEFT + 36, key], "start"));
  });
  const size = `width="${WIDTH}" height="${HEIGHT}" viewBox="0 0 ${WIDTH} ${HEIGHT}"`;
  return `<svg ${size} xmlns="http://www.w3.org/2000/svg" font-family="sans-serif" font-size="12">
<rect width="${WIDTH}" height="${HEIGHT}" fill="#ffffff"/>
${parts.join("\n")}
</svg>
`;
}

/** Powers of ten around the values, and where between two places a value stands. */
function axis(values, from, to) {
  const low = Math.floor(Math.log10(Math.min(...values)));
  const high = Math.max(low + 1, Math.ceil(Math.log10(Math.max(...values))));
  return {
    ticks: Array.from({ length: high - low + 1 }, (_, step) => 10 ** (low + step)),
    at: (value) => round(from + ((Math.log10(value) - low) / (high - low)) * (to - from)),
  };
}

const round = (value) => Math.round(value * 10) / 10;
