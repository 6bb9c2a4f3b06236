// A panel of a figure as the program describes it, drawn with Plot: one function for each kind of mark. Nothing here
// knows of contacts; numbers are in units of the program, and an axis has the factor to those that are read.

import { FAINT, FIRST, INK, MARGINS, NAMED, PLAIN, SECOND, draw, figure, head, pinnedKey, pinnedLine, reading } from "./chart.js";
import { digits } from "./numbers.js";

/** @typedef {{label: string, symbol: string, title: string, unit: string, factor: number, range?: [number, number], cut?: boolean}} Axis */
/** @typedef {{kind: string, name?: string, colour?: string, dash?: string} & Record<string, any>} Mark */
/** @typedef {{name: string, heading: string, upright: Axis, marks: Mark[], description: string, remark?: string, height?: number}} Panel */
/** @typedef {{along: Axis, panels: Panel[], conditions?: string}} Figure */

const HEIGHT = 240; // pixels, unless a panel says otherwise
const LOW = 150; // pixels, below which there is little room for ticks
const FAR = 2; // times the range, beyond which a line need not be drawn
const COLOURS = { first: FIRST, second: SECOND, ink: INK, faint: FAINT };
const DASHES = { dashed: "6 3", dotted: "2 3", ends: "7 2 1.5 2" };
const ANCHORS = { left: "start", center: "middle", right: "end" };
const HALO = { fill: INK, stroke: "var(--surface)", strokeWidth: 4 };

/** What Plot draws of a mark; places beyond the axis are kept near it. @type {Record<string, (mark: any, look: any, frame: any) => any[]>} */
const MARKS = {
  line: ({ x, y }, { stroke, strokeDasharray }, { near }) => [
    Plot.line(x, { x, y: near(y), stroke, strokeDasharray, strokeWidth: 1.6, clip: true }),
  ],
  steps: ({ edges, y }, { stroke }, { near }) => [
    Plot.rectY(y, { x1: edges.slice(0, -1), x2: edges.slice(1), y1: 0, y2: near(y), fill: stroke, fillOpacity: 0.12, clip: true }),
  ],
  band: ({ x, low, high }, { stroke }, { near }) => [
    Plot.areaY(x, { x, y1: near(low), y2: near(high), fill: stroke, fillOpacity: 0.12, clip: true }),
  ],
  points: ({ x, y }, { stroke }) => [Plot.dot(x, { x, y, r: 3, fill: stroke })],
  span: ({ low, high }, { stroke }) => [Plot.rect([0], { x1: [low], x2: [high], fill: stroke, fillOpacity: 0.1 })],
  across: ({ x, words }, { stroke, strokeDasharray }, { middle, upright }) => [
    Plot.ruleX([x], { stroke, strokeDasharray, strokeWidth: 0.8 }),
    ...(words
      ? [Plot.text([x], { x: [x], y: [upright], text: [words], rotate: -90, dx: x > middle ? 7 : -7, fill: stroke })]
      : []),
  ],
  level: ({ y }, { stroke }) => [Plot.ruleY([y], { stroke, strokeWidth: 0.8 })],
  dimension: ({ low, high, y, words }, { stroke }) => [
    Plot.link([0], { x1: [low], x2: [high], y1: [y], y2: [y], stroke, markerStart: "arrow-reverse", markerEnd: "arrow" }),
    ...written((low + high) / 2, y, words ?? ""),
  ],
  words: ({ x, y, words, side = "center" }) => written(x, y, words, side),
};

/** Words above a point. @param {number} x @param {number} y @param {string} words @param {string} [side] */
function written(x, y, words, side = "center") {
  const dx = { left: 5, center: 0, right: -5 }[side];
  const options = { x: [x], y: [y], text: [words], dx, dy: -6, textAnchor: ANCHORS[side], lineAnchor: "bottom" };
  return words ? [Plot.text([0], { ...options, ...HALO })] : [];
}

/**
 * Draw all panels of a figure, with the lines of a pinned one, into the figures of their names.
 * @param {Figure} drawn
 * @param {Figure | undefined} pinned
 * @param {[number, number] | null} [limits] of the upright axes, if these are to stay as they were
 * @param {string} [last] the panel whose axis along is labelled
 * @returns {import("./tilt.js").Axes[]} where places are in the drawings
 */
export function drawPanels(drawn, pinned, limits = null, last = "") {
  return drawn.panels.map((panel, place) =>
    drawPanel(panel, drawn.along, pinned?.panels[place], limits, panel.name === last),
  );
}

/**
 * @param {Panel} panel
 * @param {Axis} along
 * @param {Panel | undefined} pinned
 * @param {[number, number] | null} limits
 * @param {boolean} labelled
 */
function drawPanel(panel, along, pinned, limits, labelled) {
  const host = figure(panel.name);
  const upright = { ...panel.upright, range: limits ?? rangeOf(panel, pinned) };
  const lines = panel.marks.filter(({ kind }) => kind === "line");
  const [low, high] = upright.range;
  const reach = FAR * (high - low);
  const frame = {
    near: (values) => values.map((value) => value && Math.min(high + reach, Math.max(low - reach, value))),
    middle: along.range && (along.range[0] + along.range[1]) / 2,
    upright: (low + high) / 2,
  };
  const before = (pinned?.marks ?? []).filter(({ kind }) => kind === "line");
  const key = lines.filter(({ name }) => name).map(({ name, colour = "first", dash = "solid" }) => [`${colour} ${dash}`, name]);
  head(host, panel.heading, [...key, ...pinnedKey(pinned ?? null)], panel.remark);
  const height = panel.height ?? HEIGHT;
  const chart = draw(
    host,
    {
      ...MARGINS,
      ...(labelled ? { marginBottom: NAMED } : {}),
      height,
      x: { ...scale(along), label: labelled ? along.title : null },
      y: { ...scale(upright), label: short(upright), ticks: height < LOW ? 3 : 5, grid: true },
      marks: [
        Plot.ruleY([0], { stroke: INK, strokeWidth: 0.8 }),
        ...before.flatMap(({ x, y }) => pinnedLine(x, frame.near(y))),
        ...panel.marks.flatMap((mark) => MARKS[mark.kind](mark, look(mark), frame)),
        ...(lines.length ? reading(lines[0].x, frame.near(lines[0].y), (place) => read(lines, place, along, upright)) : []),
      ],
    },
    panel.description,
  );
  const place = (name, { factor }) => {
    const { apply } = chart.scale(name);
    return (value) => apply(factor * value);
  };
  return { x: place("x", along), y: place("y", upright), height, limits: upright.range };
}

/** The range of the upright axis, with that of what is pinned unless the axis is cut. */
function rangeOf({ upright }, pinned) {
  const [low, high] = upright.range ?? [0, 1];
  const other = pinned?.upright.range;
  return upright.cut || !other ? [low, high] : [Math.min(low, other[0]), Math.max(high, other[1])];
}

/** @param {Mark} mark */
function look({ colour = "first", dash = "solid" }) {
  return { stroke: COLOURS[colour], strokeDasharray: DASHES[dash] };
}

/** @param {Axis} axis */
function scale({ factor, range }) {
  return {
    domain: range?.map((end) => factor * end),
    transform: (value) => factor * value,
    labelAnchor: "center",
    labelArrow: "none",
    tickFormat: PLAIN,
  };
}

/** The label of an upright axis, which has little room. @param {Axis} axis */
function short({ symbol, label, unit }) {
  return unit ? `${symbol || label} [${unit}]` : symbol || label;
}

/** What is at a place of all lines that share their places. @param {Mark[]} lines @param {number} place @param {Axis} along @param {Axis} upright */
function read(lines, place, along, upright) {
  const amount = ({ factor, unit }, value) => `${digits(value === null ? null : factor * value, 4)} ${unit}`.trimEnd();
  const values = lines.map(({ name, y }) => `${lines.length > 1 ? name : upright.symbol} ${amount(upright, y[place])}`);
  return [`${along.symbol} ${amount(along, lines[0].x[place])}`, ...values].join("\n");
}
