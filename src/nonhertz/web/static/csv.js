// The numbers of a figure's lines as CSV, in the units in which they are read.

/** @typedef {import("./panel.js").Figure} Figure */

/** @type {WeakMap<HTMLElement, Figure>} what is drawn in a place */
const drawn = new WeakMap();

/** Note what is drawn. @param {HTMLElement} host @param {Figure} figure */
export function noteNumbers(host, figure) {
  if (figure.panels.some(({ marks }) => linesOf(marks).length)) drawn.set(host, figure);
}

/** Whether a place has lines. @param {HTMLElement} host */
export function hasNumbers(host) {
  return drawn.has(host);
}

/** @param {import("./panel.js").Mark[]} marks */
function linesOf(marks) {
  return marks.filter(({ kind }) => kind === "line" || kind === "bars");
}

/** A row for each point of each line. @param {HTMLElement} host */
export function csvOf(host) {
  const { along, panels } = /** @type {Figure} */ (drawn.get(host));
  const quoted = (words) => (/[",]/.test(words) ? `"${words.replaceAll('"', '""')}"` : words);
  const rows = panels.flatMap(({ name, upright, marks }) =>
    linesOf(marks).flatMap((line) =>
      line.x.map((x, place) => {
        const [at, value] = [[along, x], [upright, line.y[place]]].map(([axis, number]) => number !== null && axis.factor * number);
        return [name, quoted(line.name ?? upright.symbol), at, value, upright.unit].map((cell) => (cell === false ? "" : cell)).join();
      }),
    ),
  );
  return [["panel", "line", `${along.symbol} [${along.unit}]`, "value", "unit"].join(), ...rows, ""].join("\n");
}
