// A panel of a figure as the program describes it, drawn with Plot: one function for each kind of mark. Nothing here
// knows of contacts; numbers are in units of the program, and an axis has the factor to those that are read.

import {
  FAINT,
  FIRST,
  INK,
  MARGINS,
  NAMED,
  PLAIN,
  SECOND,
  draw,
  extent,
  figure,
  head,
  innerWidthOf,
  pinnedLine,
  reading,
  whenSeen,
  widthOf,
} from "./chart.js";
import { BANDS, FINE, resampled } from "./contours.js";
import { noteNumbers } from "./csv.js";
import { digits } from "./numbers.js";

/** @typedef {{label: string, symbol: string, title: string, unit: string, factor: number, range?: [number, number], cut?: boolean, ticks?: [number, string][], logarithmic?: boolean}} Axis */
/** @typedef {{kind: string, name?: string, colour?: string, dash?: string} & Record<string, any>} Mark */
/** @typedef {{name: string, heading: string, upright: Axis, marks: Mark[], description: string, remark?: string, height?: number, colours?: Axis, proportional?: boolean, round?: boolean, along?: Axis}} Panel */
/** @typedef {{along: Axis, panels: Panel[], conditions?: string}} Figure */
/** @typedef {import("./tilt.js").Axes} Axes where places are in a drawing */

const HEIGHT = 240; // pixels, unless a panel says otherwise
const LOW = 150; // pixels, below which there is little room for ticks
const LETTER = 6; // pixels, of a mean letter
const TOP = 0.9; // of the axis, at which words above lines still fit
const FAR = 2; // times the range, beyond which a line need not be drawn
const HIGHEST = 300; // pixels, of a panel in true proportions
const COLOURS = { first: FIRST, second: SECOND, ink: INK, faint: FAINT, paper: "var(--surface)" }; // of two lines at most
const DASHES = { dashed: "6 3", dotted: "2 3", ends: "7 2 1.5 2" };
const ANCHORS = { left: "start", center: "middle", right: "end" };
const HALO = { fill: INK, stroke: "var(--surface)", strokeWidth: 4 };

/** What figures show, of which only those that change are drawn again. @type {WeakMap<HTMLElement, {text: string, axes: Axes}>} */
const shown = new WeakMap();

/** What Plot draws of a mark; places beyond the axis are kept near it. @type {Record<string, (mark: any, look: any, frame: any) => any[]>} */
const MARKS = {
  line: ({ x, y, thin }, { stroke, strokeDasharray }, { near }) => [
    Plot.line(x, { x, y: near(y), stroke, strokeDasharray, strokeWidth: thin ? 1 : 1.6, clip: true }),
  ],
  steps: ({ edges, y }, { stroke }, { near }) => [
    Plot.rectY(y, { x1: edges.slice(0, -1), x2: edges.slice(1), y1: 0, y2: near(y), fill: stroke, fillOpacity: 0.12, clip: true }),
  ],
  band: ({ x, low, high }, { stroke }, { near }) => [
    Plot.areaY(x, { x, y1: near(low), y2: near(high), fill: stroke, fillOpacity: 0.12, clip: true }),
  ],
  area: ({ x, half_height, values }, _, { colours }) => {
    const id = `area-${x[0]}`;
    return [
      () => gradient(id, x, values, colours),
      Plot.areaY(x, { x, y1: half_height, y2: half_height.map((y) => -y), fill: `url(#${id})`, stroke: INK, strokeWidth: 0.7 }),
    ];
  },
  cells: ({ x, y, values }, _, { colours, words }) => {
    const places = d3.cross(d3.range(x.length - 1), d3.range(y.length - 1)).filter(([i, j]) => values[i][j] !== null);
    const at = (edges, which) => places.map((place) => edges[place[which]]);
    const after = (edges, which) => places.map((place) => edges[place[which] + 1]);
    const corners = { x1: at(x, 0), x2: after(x, 0), y1: at(y, 1), y2: after(y, 1) };
    const fill = places.map(([i, j]) => colours.factor * values[i][j]);
    const middle = (edges, which) => places.map((place) => (edges[place[which]] + edges[place[which] + 1]) / 2);
    const [along, up] = [middle(x, 0), middle(y, 1)];
    const title = (_, k) => words(along[k], up[k], values[places[k][0]][places[k][1]]);
    const tip = Plot.pointer({ x: along, y: up, title, maxRadius: 60, ariaHidden: true, fill: "var(--surface)", stroke: "var(--rule)" });
    return [Plot.rect(places, { ...corners, fill, inset: -0.5, clip: true }), Plot.tip(places, tip)];
  },
  contours: ({ x, y, values }, _, { colours, net }) => {
    const { even, ...corners } = resampled(x, y, values, net);
    const [, top] = colours.range;
    const thresholds = d3.range(0, top, top / BANDS).map((level) => colours.factor * level);
    const shown = even.map((value) => colours.factor * value);
    const look = { fill: (value) => value, stroke: "#ffffff66", strokeWidth: 0.5 };
    return [Plot.contour(shown, { width: net.columns, height: net.rows, ...corners, ...look, thresholds })];
  },
  points: ({ x, y, symbol = "circle" }, { stroke }, { colours, within }) => {
    const filter = y.map(within);
    const dots = (look) => Plot.dot(x, { x, y, filter, symbol: symbol === "dot" ? "circle" : symbol, ...look });
    // Over colours a symbol has a rim.
    return colours ? [dots({ r: 4, fill: "white", stroke: "black" })] : [dots({ r: symbol === "dot" ? 2 : 3, fill: stroke })];
  },
  bar: ({ low, high, y }, { stroke }) => [Plot.link([0], { x1: [low], x2: [high], y1: [y], y2: [y], stroke, strokeWidth: 3 })],
  span: ({ low, high }, { stroke }) => [Plot.rect([0], { x1: [low], x2: [high], fill: stroke, fillOpacity: 0.1 })],
  across: ({ x, words }, { stroke, strokeDasharray }, { middle, upright }) => [
    Plot.ruleX([x], { stroke, strokeDasharray, strokeWidth: 0.8 }),
    ...(words
      ? [Plot.text([x], { x: [x], y: [upright], text: [words], rotate: -90, dx: x > middle ? 7 : -7, fill: stroke })]
      : []),
  ],
  level: ({ y }, { stroke, strokeDasharray }) => [Plot.ruleY([y], { stroke, strokeDasharray, strokeWidth: 0.8 })],
  dimension: ({ low, high, y, words }, { stroke }, frame) => [
    Plot.link([0], { x1: [low], x2: [high], y1: [y], y2: [y], stroke, markerStart: "arrow-reverse", markerEnd: "arrow" }),
    ...written((low + high) / 2, y, words ?? "", "center", frame),
  ],
  words: ({ x, y, words, side = "center", clear }, _, frame) =>
    written(x, clear ? above(x, y, words, side, frame) : y, words, side, frame),
};

/** Words above a point, beside it where they would not fit into the axes. @param {number} x @param {number} y @param {string} words @param {string} side */
function written(x, y, words, side, { span: [low, high], wide }) {
  const half = (LETTER * Math.max(...words.split("\n").map(({ length }) => length))) / 2;
  const at = (wide * (x - low)) / (high - low);
  const fitting = side !== "center" ? side : at + half > wide ? "right" : at < half ? "left" : side;
  const dx = { left: 5, center: 0, right: -5 }[fitting];
  const options = { x: [x], y: [y], text: [typeset(words)], dx, dy: -6, textAnchor: ANCHORS[fitting], lineAnchor: "bottom" };
  return words ? [Plot.text([0], { ...options, ...HALO })] : [];
}

/** Where words that begin or end at a point are above all lines that they would cross. */
function above(x, y, words, side, { lines, range: [, top], span: [low, high], wide }) {
  const width = (LETTER * (words.length + 1) * (high - low)) / wide;
  const from = side === "right" ? x - width : x;
  const crossed = lines.flatMap((line) => line.y.filter((_, place) => from <= line.x[place] && line.x[place] <= from + width));
  return Math.min(Math.max(y, ...crossed), TOP * top);
}

/** Words with a true minus sign, as matplotlib sets them. @param {string} words */
function typeset(words) {
  return words.replace(/(?<![\w^])-(?=[\d.])/g, "\u2212");
}

/** A gradient along an area; its colours are those in its middle. */
function gradient(id, x, values, { range }) {
  const [low, high] = extent(x);
  const gradient = d3.create("svg:defs").append("linearGradient").attr("id", id);
  for (const [place, value] of x.entries()) {
    const stop = gradient.append("stop").attr("offset", (value - low) / (high - low || 1));
    stop.attr("stop-color", d3.interpolateViridis(Math.min(1, values[place] / range[1])));
  }
  return gradient.node().parentNode;
}

/**
 * Draw all panels of a figure, with the lines of a pinned one, into the figures of their names.
 * @param {Figure} drawn
 * @param {Figure | undefined} pinned
 * @param {{limits?: [number, number] | null, last?: string, net?: {columns: number, rows: number}, pinnedAs?: string, placed?: (axes: Axes) => void}} [how]
 *   limits of the upright axes if these are to stay as they were, the panel whose axis along is labelled, the grid of
 *   contours, what the pinned one is called, and what follows when a panel is drawn
 */
export function drawPanels(drawn, pinned, { limits = null, last = "", net = FINE, pinnedAs = "pinned", placed } = {}) {
  for (const panel of drawn.panels) {
    const labelled = panel.name === last || panel.along !== undefined;
    const before = pinned?.panels.find(({ name }) => name === panel.name);
    const how = [panel, panel.along ?? drawn.along, before, limits, labelled, net, pinnedAs];
    const host = figure(panel.name);
    whenSeen(host, () => {
      const text = JSON.stringify([widthOf(host), ...how]);
      if (shown.get(host)?.text !== text) shown.set(host, { text, axes: drawPanel(...how) });
      placed?.(shown.get(host).axes);
    });
  }
}

/**
 * @param {Panel} panel
 * @param {Axis} along
 * @param {Panel | undefined} pinned
 * @param {[number, number] | null} limits
 * @param {boolean} labelled
 * @param {{columns: number, rows: number}} net
 * @param {string} pinnedAs
 */
function drawPanel(panel, along, pinned, limits, labelled, net, pinnedAs) {
  const host = figure(panel.name);
  const upright = { ...panel.upright, range: limits ?? rangeOf(panel, pinned) };
  const lines = panel.marks.filter(({ kind }) => kind === "line");
  const areas = panel.marks.filter(({ kind }) => kind === "area");
  const { colours } = panel;
  const [low, high] = d3.extent(upright.range);
  const reach = FAR * (high - low);
  const frame = {
    near: (values) => values.map((value) => (value === null ? NaN : Math.min(high + reach, Math.max(low - reach, value)))),
    within: (value) => low <= value && value <= high,
    middle: along.range && (along.range[0] + along.range[1]) / 2,
    upright: (low + high) / 2,
    colours,
    net,
    span: along.range ?? [0, 1],
    wide: innerWidthOf(host),
    lines,
    range: upright.range,
    words: (place, height, number) =>
      [amount(along, place), amount(upright, height), amount(/** @type {Axis} */ (colours), number)].join("\n"),
  };
  noteNumbers(host, { along, panels: [panel] });
  const before = (pinned?.marks ?? []).filter(({ kind }) => kind === "line");
  const listed = panel.marks.filter(({ kind, name }) => name && (kind === "line" || (kind === "points" && !colours)));
  const swatch = ({ kind, colour = "first", dash = "solid" }) => `${colour} ${kind === "points" ? "dot" : dash}`;
  const key = listed.map((mark) => [swatch(mark), typeset(mark.name)]);
  const hasContours = panel.marks.some(({ kind }) => kind === "contours");
  const shades = colours && !hasContours ? [["gradient", `dark to bright: ${colours.symbol} 0 to ${value(colours, colours.range[1])}`]] : [];
  const margins = { ...MARGINS, ...(labelled ? { marginBottom: NAMED } : {}) };
  const { height, proportions } = sizeOf(host, panel, along, margins);
  const remark = typeset([proportions, panel.remark].filter((words) => words).join("; "));
  head(host, typeset(panel.heading), [...key, ...shades, ...(pinned ? [["pinned", pinnedAs]] : [])], remark);
  const chart = draw(
    host,
    {
      ...margins,
      height,
      x: { ...scale(along), label: labelled ? along.title : null },
      ...(colours ? { color: { ...shading(colours), legend: hasContours } } : {}),
      y: { ...scale(upright), label: short(upright), ticks: height < LOW ? 3 : 5, grid: !colours },
      marks: [
        ...(colours || low > 0 || high < 0 ? [] : [Plot.ruleY([0], { stroke: INK, strokeWidth: 0.8 })]),
        ...before.flatMap(({ x, y }) => pinnedLine(x, frame.near(y))),
        ...panel.marks.flatMap((mark) => MARKS[mark.kind](mark, look(mark), frame)),
        ...areas.flatMap((area) => readingOf(area, along, upright, colours)),
        ...(lines.length && !areas.length && (lines.length === 1 || lines.every(({ name }) => name))
          ? reading(lines[0].x, frame.near(lines[0].y), (place) => read(lines, place, along, upright))
          : []),
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

/** The height of a panel in pixels, and its proportions in words if these matter. @param {HTMLElement} host @param {Panel} panel @param {Axis} along @param {typeof MARGINS} margins */
function sizeOf(host, { upright, proportional, height = HEIGHT }, along, { marginTop, marginBottom }) {
  if (!proportional) return { height, proportions: "" };
  const natural = (innerWidthOf(host) * lengthOf(upright)) / lengthOf(along); // pixels in true proportions
  const drawn = Math.min(HIGHEST, Math.max(height, natural));
  const stretch = drawn / natural;
  const stretched = (symbol, times) => `${symbol} stretched ${digits(times, 2)} times`;
  const slightly = Math.abs(stretch - 1) <= 0.02;
  const words = stretch > 1 ? stretched(upright.symbol, stretch) : stretched(along.symbol, 1 / stretch);
  return { height: drawn + marginTop + marginBottom, proportions: slightly ? "true proportions" : words };
}

/** @param {Axis} axis */
function lengthOf({ range }) {
  return Math.abs(range[1] - range[0]);
}

/** The range of the upright axis, downwards or upwards, with that of what is pinned unless the axis is cut. */
function rangeOf({ upright }, pinned) {
  const [low, high] = upright.range ?? [0, 1];
  const other = pinned?.upright.range;
  if (upright.cut || !other) return [low, high];
  const [below, above] = low < high ? [Math.min, Math.max] : [Math.max, Math.min];
  return [below(low, other[0]), above(high, other[1])];
}

/** @param {Mark} mark */
function look({ colour = "first", dash = "solid" }) {
  return { stroke: COLOURS[colour], strokeDasharray: DASHES[dash] };
}

/** @param {Axis} axis */
function scale({ factor, range, ticks, logarithmic }) {
  const words = new Map(ticks?.map(([place, label]) => [factor * place, label]));
  return {
    ...(ticks ? { ticks: [...words.keys()] } : {}),
    ...(logarithmic ? { type: "log", ticks: 6 } : {}),
    domain: range?.map((end) => factor * end),
    transform: (value) => factor * value,
    labelAnchor: "center",
    labelArrow: "none",
    tickFormat: ticks ? (place) => words.get(place) : PLAIN,
  };
}

/** What colours stand for. @param {Axis} colours */
function shading({ factor, range, title }) {
  const legend = { label: title, width: 220, height: 52, ticks: 4, marginLeft: 8, tickFormat: PLAIN };
  const domain = range.map((end) => factor * end);
  return { type: "linear", domain, clamp: true, interpolate: d3.interpolateViridis, ...legend };
}

/** The label of an upright axis, which has little room. @param {Axis} axis */
function short({ symbol, label, unit }) {
  return unit ? `${symbol || label} [${unit}]` : symbol || label;
}

/** What is at a place of the first line, and near it on the others. @param {Mark[]} lines @param {number} place @param {Axis} along @param {Axis} upright */
function read(lines, place, along, upright) {
  const at = lines[0].x[place];
  const near = ({ x, y }) => y[x === lines[0].x ? place : d3.minIndex(x, (other) => (other === null ? Infinity : Math.abs(other - at)))];
  const named = (line) => `${lines.length > 1 ? line.name : upright.symbol} ${value(upright, near(line))}`;
  return [amount(along, at), ...lines.map(named)].join("\n");
}

/** What is at a place of an area: how wide it is and the value in its middle. */
function readingOf({ x, half_height, values }, along, upright, colours) {
  const wide = (place) => `${upright.symbol} ±${value(upright, half_height[place])}`;
  return reading(x, half_height, (place) => [amount(along, x[place]), wide(place), amount(colours, values[place])].join("\n"));
}

/** A number with its unit, as people read it. @param {Axis} axis @param {number | null} number */
function value({ factor, unit }, number) {
  return `${digits(number === null ? null : factor * number, 4)} ${unit}`.trimEnd();
}

/** The same after the symbol of its axis. @param {Axis} axis @param {number | null} number */
function amount(axis, number) {
  return `${axis.symbol} ${value(axis, number)}`;
}
