// The loads of all rollers around the bearing's axis, one picture for each row; a roller can be chosen.

import { drawn } from "./elements.js";
import { digits } from "./numbers.js";
import { force } from "./units.js";

// Of the picture; radii of the rollers' circle, of the largest load, of the angles.
const [SIZE, HOLE, RIM, OUTSIDE] = [420, 64, 168, 188];
const FLAT = 0.5; // a bar less high than this is not drawn

/** @typedef {{first: number, count: number}} Row */
/** @typedef {import("./panel.js").Figure} Figure round */

export class Polar {
  /**
   * @param {HTMLElement} host
   * @param {(roller: number) => void} choose called with the number of a roller that is clicked
   */
  constructor(host, choose) {
    this.host = host;
    this.choose = choose;
    this.shape = "";
    /** @type {{svg: any, grid: any, force: any, rollers: Record<string, any>[]}[]} */
    this.pictures = [];
  }

  /** @param {{rows: Row[], loads: Figure}} answer @param {number} chosen */
  draw({ rows, loads }, chosen) {
    const shape = rows.map((row) => row.count).join();
    if (shape !== this.shape) {
      this.shape = shape;
      this.pictures = rows.map((row, number) => this.build(row, number, rows.length));
      this.host.replaceChildren(...this.pictures.map(({ svg }) => svg));
      this.host.classList.toggle("several", rows.length > 1);
    }
    for (const [number, row] of rows.entries()) this.update(this.pictures[number], row, loads.along, loads.panels[number], chosen);
  }

  build(row, number, rows) {
    const name = rows > 1 ? `Row ${number + 1}: loads` : "Loads";
    const svg = drawn("svg", { viewBox: `${-SIZE / 2} ${-SIZE / 2} ${SIZE} ${SIZE}`, role: "group" });
    svg.setAttribute("aria-label", `${name} of the rollers around the axis; arrow keys go from roller to roller`);
    const [grid, force] = [drawn("g", { "aria-hidden": "true" }), drawn("g", { "aria-hidden": "true" })];
    const rollers = Array.from({ length: row.count }, (_, j) => this.roller(row.first + j, row));
    if (rows > 1) svg.append(text(14 - SIZE / 2, 12 - SIZE / 2, `Row ${number + 1}`, "row"));
    svg.append(grid, ...rollers.map(({ group }) => group), force);
    return { svg, grid, force, rollers };
  }

  roller(number, row) {
    const group = drawn("g", { class: "roller", role: "button", "data-roller": String(number) });
    const parts = {
      band: drawn("path", { class: "band" }),
      inner: drawn("path", { class: "inner-load" }),
      outer: drawn("path", { class: "outer-load" }),
      mark: drawn("circle", { class: "mark" }),
    };
    group.append(...Object.values(parts));
    group.addEventListener("click", () => this.choose(number));
    group.addEventListener("keydown", (event) => {
      const step = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key];
      if (step === undefined && event.key !== "Enter" && event.key !== " ") return;
      event.preventDefault();
      const next = row.first + ((number - row.first + (step ?? 0) + row.count) % row.count);
      this.choose(next);
      this.host.querySelector(`[data-roller="${next}"]`)?.focus();
    });
    return { group, ...parts };
  }

  update(picture, row, along, { upright, marks }, chosen) {
    const [inner, outer] = marks.filter(({ kind }) => kind === "bars");
    const step = (2 * Math.PI) / row.count;
    const size = Math.min(8, 0.42 * HOLE * step);
    const radius = (load) => HOLE + size + ((RIM - HOLE - size) * load) / upright.range[1];
    const within = chosen >= row.first && chosen < row.first + row.count;
    const bar = ({ x, y, width, aside }, j) => barOf(x[j] + aside - width / 2, x[j] + aside + width / 2, HOLE + size, radius(y[j]));
    const inUnit = (load) => `${digits(upright.factor * load)} ${upright.unit}`;
    for (const [j, parts] of picture.rollers.entries()) {
      const number = row.first + j;
      const at = inner.x[j];
      const here = number === chosen;
      set(parts.band, "d", sector(at - step / 2, at + step / 2, HOLE - size - 3, RIM + 5));
      set(parts.inner, "d", bar(inner, j));
      set(parts.outer, "d", bar(outer, j));
      for (const [name, value] of [["cx", HOLE * Math.sin(at)], ["cy", HOLE * Math.cos(at)], ["r", size]])
        set(parts.mark, name, String(value));
      parts.mark.classList.toggle("loaded", inner.y[j] > 0);
      parts.group.classList.toggle("chosen", here);
      set(parts.group, "aria-pressed", String(here));
      // One of the rollers is reached by the tab key, the others from there by arrow keys.
      set(parts.group, "tabindex", here || (!within && j === 0) ? "0" : "-1");
      const loads = `${inUnit(inner.y[j])} inner, ${inUnit(outer.y[j])} outer ring`;
      set(parts.group, "aria-label", `roller ${number + 1} at ${degrees(at)} degrees: ${loads}`);
    }
    drawGrid(picture.grid, along.ticks, marks.filter(({ kind }) => kind === "words"), radius);
    drawForce(picture.force, marks.find(({ kind }) => kind === "arrow"));
  }
}

/** Spokes with their angles, and rings with their loads. */
function drawGrid(grid, spokes, rings, radius) {
  const parts = spokes.flatMap(([at, words]) => {
    const [x, y] = [Math.sin(at), Math.cos(at)];
    const lines = words.split(" ").map((part, k) => text(OUTSIDE * x, OUTSIDE * y + 14 * k, part, "angle"));
    return [drawn("line", { class: "spoke", x1: HOLE * x, y1: HOLE * y, x2: RIM * x, y2: RIM * y }), ...lines];
  });
  for (const { y: load } of rings) parts.push(drawn("circle", { class: "ring", r: radius(load) }));
  parts.push(drawn("circle", { class: "circle", r: HOLE }));
  for (const { x: at, y: load, words } of rings)
    parts.push(text(radius(load) * Math.sin(at), radius(load) * Math.cos(at), words, "of-ring"));
  grid.replaceChildren(...parts);
}

/** An arrow through the middle, or words alone where it has no direction. */
function drawForce(host, { x: at, words }) {
  if (at === null) {
    host.replaceChildren(...words.split("\n").map((line, k) => text(0, 14 * k - 7, line, "force")));
    return;
  }
  const [x, y] = [Math.sin(at), Math.cos(at)];
  const [tail, tip, wing] = [-6, 40, 7];
  const side = (sign) => `${(tip - 12) * x - sign * wing * y} ${(tip - 12) * y + sign * wing * x}`;
  host.replaceChildren(
    drawn("path", { class: "arrow", d: `M${tail * x} ${tail * y}L${(tip - 12) * x} ${(tip - 12) * y}` }),
    drawn("path", { class: "arrow-head", d: `M${tip * x} ${tip * y}L${side(1)}L${side(-1)}Z` }),
    text(-24 * x, -24 * y, words, "force"),
  );
}

function barOf(from, to, low, high) {
  return high - low > FLAT ? sector(from, to, low, high) : "";
}

/** A part of a ring between two angles, from the bottom counter-clockwise, and two radii. */
function sector(from, to, low, high) {
  const point = (at, radius) => `${(radius * Math.sin(at)).toFixed(2)} ${(radius * Math.cos(at)).toFixed(2)}`;
  const large = to - from > Math.PI ? 1 : 0;
  const out = `A${high} ${high} 0 ${large} 0 ${point(to, high)}`;
  const back = `A${low} ${low} 0 ${large} 1 ${point(from, low)}`;
  return `M${point(from, low)}L${point(from, high)}${out}L${point(to, low)}${back}Z`;
}

function text(x, y, words, style) {
  return drawn("text", { x: x.toFixed(1), y: y.toFixed(1), class: style }, [words]);
}

function set(element, name, value) {
  if (element.getAttribute(name) !== value) element.setAttribute(name, value);
}

/** @param {number} at rad */
export function degrees(at) {
  return ((at * 180) / Math.PI).toFixed(1);
}

/** @param {number} load N */
export function newtons(load) {
  const { value, unit } = force(load);
  return `${value.includes(".") && !value.includes("e") ? value.replace(/\.?0+$/, "") : value} ${unit}`;
}
