// The loads of all rollers around the bearing's axis, one picture for each row; a roller can be chosen.

import { drawn } from "./elements.js";
import { force, read } from "./units.js";

// Of the picture; radii of the rollers' circle, of the largest load, of the angles.
const [SIZE, HOLE, RIM, OUTSIDE] = [420, 64, 168, 188];
const FLAT = 0.5; // a bar less high than this is not drawn
const TOPS = [1, 1.5, 2, 3, 4, 5, 6, 8, 10];
const WIDEST = 9; // degrees, of a bar
const SPOKES = 8;
const NO_FORCE = 1e-6; // of the sum of the loads: rounding

/**
 * @typedef {{y: number[], relief_um: (number | null)[]}} Relief
 * @typedef {{first: number, count: number, length: number, relief: {inner: Relief, outer: Relief}}} Row
 * @typedef {{rows: Row[], angle: number[], load: [number, number][], force: number[], most: number}} Loads
 */

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

  /** @param {Loads} answer @param {number} chosen */
  draw(answer, chosen) {
    const shape = answer.rows.map((row) => row.count).join();
    if (shape !== this.shape) {
      this.shape = shape;
      this.pictures = answer.rows.map((row, number) => this.build(row, number, answer.rows.length));
      this.host.replaceChildren(...this.pictures.map(({ svg }) => svg));
      this.host.classList.toggle("several", answer.rows.length > 1);
    }
    const factor = read("N")[1];
    const top = topOf(factor * Math.max(...answer.load.flat())) / factor;
    for (const [number, row] of answer.rows.entries()) this.update(this.pictures[number], row, answer, chosen, top);
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

  update(picture, row, answer, chosen, top) {
    const step = (2 * Math.PI) / row.count;
    const bar = Math.min(0.4 * step, (WIDEST * Math.PI) / 180);
    const size = Math.min(8, (0.42 * 2 * Math.PI * HOLE) / row.count);
    const radius = (load) => HOLE + size + ((RIM - HOLE - size) * load) / top;
    const within = chosen >= row.first && chosen < row.first + row.count;
    for (const [j, parts] of picture.rollers.entries()) {
      const number = row.first + j;
      const [at, [inner, outer]] = [answer.angle[number], answer.load[number]];
      const here = number === chosen;
      set(parts.band, "d", sector(at - step / 2, at + step / 2, HOLE - size - 3, RIM + 5));
      set(parts.inner, "d", barOf(at - bar, at, HOLE + size, radius(inner)));
      set(parts.outer, "d", barOf(at, at + bar, HOLE + size, radius(outer)));
      for (const [name, value] of [["cx", HOLE * Math.sin(at)], ["cy", HOLE * Math.cos(at)], ["r", size]])
        set(parts.mark, name, String(value));
      parts.mark.classList.toggle("loaded", inner > 0);
      parts.group.classList.toggle("chosen", here);
      set(parts.group, "aria-pressed", String(here));
      // One of the rollers is reached by the tab key, the others from there by arrow keys.
      set(parts.group, "tabindex", here || (!within && j === 0) ? "0" : "-1");
      const loads = `${newtons(inner)} inner, ${newtons(outer)} outer ring`;
      const words = `roller ${number + 1} at ${degrees(at)} degrees: ${loads}`;
      set(parts.group, "aria-label", words);
    }
    drawGrid(picture.grid, row, answer, top, radius);
    drawForce(picture.force, answer);
  }
}

/** The round number up to which loads are drawn: the same over much of a drag, so that bars grow. @param {number} load */
export function topOf(load) {
  if (!(load > 0)) return 1;
  const power = 10 ** Math.floor(Math.log10(load));
  return (TOPS.find((each) => each * power >= load) ?? 10) * power;
}

function drawGrid(grid, row, answer, top, radius) {
  const parts = [];
  for (let spoke = 0; spoke < SPOKES; spoke += 1) {
    const [degrees, at] = [(360 * spoke) / SPOKES, (2 * Math.PI * spoke) / SPOKES];
    const [x, y] = [Math.sin(at), Math.cos(at)];
    parts.push(drawn("line", { class: "spoke", x1: HOLE * x, y1: HOLE * y, x2: RIM * x, y2: RIM * y }));
    parts.push(text(OUTSIDE * x, OUTSIDE * y, `${degrees}°`, "angle"));
    const axis = { 0: "+y", 90: "+z" }[degrees];
    if (axis) parts.push(text(OUTSIDE * x, OUTSIDE * y + 14, axis, "angle"));
  }
  const at = emptiest(row, answer);
  const factor = read("N")[1];
  const rings = d3.ticks(0, factor * top, 3).slice(1).map((load) => load / factor);
  for (const load of rings) parts.push(drawn("circle", { class: "ring", r: radius(load) }));
  parts.push(drawn("circle", { class: "circle", r: HOLE }));
  for (const load of rings)
    parts.push(text(radius(load) * Math.sin(at), radius(load) * Math.cos(at), newtons(load), "of-ring"));
  grid.replaceChildren(...parts);
}

/** The angle between the two neighbours that bear least, the uppermost of such places. */
function emptiest(row, { angle, load }) {
  const sum = (j) => load[row.first + (j % row.count)].reduce((a, b) => a + b, 0);
  // What speed alone presses is nothing beside the largest load, and the same all round but for rounding.
  const slight = 1e-3 * Math.max(1e-6, ...load.flat());
  let [best, least] = [Math.PI, Infinity];
  for (let j = 0; j < row.count; j += 1) {
    const at = angle[row.first + j] + Math.PI / row.count;
    const pair = sum(j) + sum(j + 1) + slight * (Math.cos(at) + 1);
    if (pair < least) [best, least] = [at, pair];
  }
  return best;
}

function drawForce(host, { force, load }) {
  const radial = Math.hypot(force[1], force[2]);
  const sum = load.flat().reduce((a, b) => a + b, 0);
  if (!(radial > NO_FORCE * sum)) {
    host.replaceChildren(text(0, -7, "no radial", "force"), text(0, 7, "force", "force"));
    return;
  }
  const [x, y] = [force[2] / radial, force[1] / radial];
  const [tail, tip, wing] = [-6, 40, 7];
  const side = (sign) => `${(tip - 12) * x - sign * wing * y} ${(tip - 12) * y + sign * wing * x}`;
  host.replaceChildren(
    drawn("path", { class: "arrow", d: `M${tail * x} ${tail * y}L${(tip - 12) * x} ${(tip - 12) * y}` }),
    drawn("path", { class: "arrow-head", d: `M${tip * x} ${tip * y}L${side(1)}L${side(-1)}Z` }),
    text(-24 * x, -24 * y, newtons(radial), "force"),
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

export function text(x, y, words, style) {
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
