// The numbers of a figure as CSV, in the units in which they are read.

/** @typedef {import("./panel.js").Figure} Figure */

/** What a table has of a mark: places along, upright, and what colours stand for. @type {Record<string, (mark: any) => any[][]>} */
const NUMBERS = {
  line: ({ x, y }) => d3.zip(x, y),
  bars: ({ x, y }) => d3.zip(x, y),
  points: ({ name, x, y }) => (name ? d3.zip(x, y) : []),
  area: ({ x, half_height, values }) => d3.zip(x, half_height, values),
  contours: ({ x, y, values }) => listed(x, y, values),
  cells: ({ x, y, values }) => listed(...[x, y].map((edges) => d3.pairs(edges, (low, high) => (low + high) / 2)), values),
};

/** @type {WeakMap<HTMLElement, Figure>} what is drawn in a place */
const drawn = new WeakMap();

/** A grid of values as a list. @returns {any[][]} */
function listed(x, y, values) {
  return x.flatMap((at, i) => y.map((height, j) => [at, height, values[i][j]]));
}

/** Note what is drawn. @param {HTMLElement} host @param {Figure} figure */
export function noteNumbers(host, figure) {
  drawn.set(host, figure);
}

/** A row for each point of each mark. @param {HTMLElement} host */
export function csvOf(host) {
  const { along, panels } = /** @type {Figure} */ (drawn.get(host));
  const coloured = panels.find(({ colours }) => colours);
  const places = [along, ...(coloured ? [coloured.upright] : [])].map(({ symbol, unit }) => `${symbol} [${unit}]`);
  const rows = panels.flatMap(({ name, upright, colours, round, marks }) =>
    // Points on a circle mark rollers.
    marks.filter(({ kind }) => !(round && kind === "points")).flatMap((mark) =>
      (NUMBERS[mark.kind]?.(mark) ?? []).map((numbers) => {
        const axes = [along, upright, colours].slice(0, numbers.length);
        const { symbol, unit } = axes[axes.length - 1];
        const cells = numbers.map((number, place) => (number === null ? "" : axes[place].factor * number));
        return [name, quoted(mark.name ?? symbol), ...cells, ...(coloured && numbers.length < 3 ? ["", ""] : [unit])].join();
      }),
    ),
  );
  return [["panel", "line", ...places, "value", "unit"].join(), ...rows, ""].join("\n");
}

/** @param {string} words */
function quoted(words) {
  return /[",]/.test(words) ? `"${words.replaceAll('"', '""')}"` : words;
}
