// The parameter curve: a number of the result over the range of one field, drawn while it is worked out.
//
// Points come a few at a time, from both ends and the middle inwards, so that the first answer already shows the shape.
// The curve belongs to the case without the field that is varied: while its slider is dragged only the mark moves.

import { extent } from "./chart.js";
import { byId, element } from "./elements.js";
import { ends, factorOf, isLogarithmic, nameOf, unitOf, valueOf } from "./fields.js";
import { AWAY, post } from "./live.js";
import { digits, rounded } from "./numbers.js";
import { drawPanels } from "./panel.js";
import { withValue } from "./paths.js";
import { amount, read } from "./units.js";

const POINTS = 33; // a power of two and one
const AT_ONCE = 4; // points of a request
const AROUND = 2; // a slider of ratios is varied from its value divided by this to its value times this
const SHARE = 0.1; // of its range, by which any other slider is varied to either side

/** @typedef {import("./fields.js").Control} Control */
/** @typedef {{name: string, label: string, unit: string, factor: number}} Quantity */
/** @typedef {{value: number, numbers?: (number | null)[], sentence?: string}} Point */
/** @typedef {{path: string, label: string, control: Control, slider: HTMLInputElement}} Choice */

export class Curve {
  /** @param {HTMLElement} form */
  constructor(form) {
    this.form = form;
    /** @type {Choice[]} */
    this.choices = [];
    this.path = "";
    this.drawnFor = "";
    /** @type {Map<number, Point>} */
    this.points = new Map();
    /** @type {Quantity[]} */
    this.quantities = [];
    /** @type {any} */
    this.document = null;
    /** @type {any} */
    this.key = null;
    /** @type {AbortController | null} */
    this.asking = null;
    form.addEventListener("input", ({ target }) => {
      if (target instanceof HTMLInputElement && target.type === "range") this.follow(target);
      if (target instanceof HTMLSelectElement && target.dataset.unitOf === this.chosen()?.control.id)
        this.choose(this.path);
    });
    byId("curve-on").addEventListener("change", () => this.toggled());
    byId("curve-path").addEventListener("change", ({ target }) => this.choose(target.value));
    for (const end of ["curve-low", "curve-high"]) byId(end).addEventListener("change", () => this.rested());
    byId("curve-quantity").addEventListener("change", () => this.draw());
  }

  get shown() {
    return byId("curve-on").checked;
  }

  /** Offer the sliders that the form has now. */
  offer() {
    const sliders = /** @type {NodeListOf<HTMLInputElement>} */ (this.form.querySelectorAll('input[type="range"]'));
    this.choices = [...sliders].flatMap((slider) => {
      const control = /** @type {Control | null} */ (document.getElementById(slider.dataset.for ?? ""));
      return control && Number.isFinite(valueOf(slider, control))
        ? [{ path: control.name, label: nameOf(control), control, slider }]
        : [];
    });
    const known = this.choices.some(({ path }) => path === this.path);
    const options = this.choices.map(({ path, label }) => element("option", { value: path }, [label]));
    byId("curve-path").replaceChildren(...options);
    if (known) byId("curve-path").value = this.path;
    else if (this.choices.length) this.choose(this.first());
  }

  /** The load to begin with, if there is one. */
  first() {
    return this.choices.find(({ path }) => path === "load.load")?.path ?? this.choices[0].path;
  }

  /** Vary what is being dragged. @param {HTMLInputElement} slider */
  follow(slider) {
    const path = /** @type {Control} */ (document.getElementById(slider.dataset.for ?? "")).name;
    if (!this.choices.some((choice) => choice.path === path)) this.offer();
    if (path !== this.path && this.choices.some((choice) => choice.path === path)) this.choose(path);
  }

  /** Vary another field, around the value that it has. @param {string} path */
  choose(path) {
    this.path = path;
    byId("curve-path").value = path;
    const choice = this.chosen();
    if (!choice) return;
    const { slider, control } = choice;
    const [least, most] = ends(slider);
    const value = Math.min(Math.max(valueOf(slider, control), least), most);
    const wide = SHARE * (most - least);
    const around = isLogarithmic(slider) ? [value / AROUND, value * AROUND] : [value - wide, value + wide];
    const [low, high] = [Math.min(...around), Math.max(...around)].map((end) => Math.min(Math.max(end, least), most));
    const factor = factorOf(choice.control);
    byId("curve-low").value = rounded(low / factor, (high - low) / 100 / factor);
    byId("curve-high").value = rounded(high / factor, (high - low) / 100 / factor);
    byId("curve-unit").textContent = unitOf(choice.control);
    this.rested();
  }

  chosen() {
    return this.choices.find(({ path }) => path === this.path) ?? null;
  }

  toggled() {
    byId("curve-choices").hidden = byId("curve-figures").hidden = !this.shown;
    byId("curve-note").textContent = "";
    if (this.shown) this.rested();
    else this.forget();
  }

  /** Note the case that is shown now, and where it is on the curve. @param {any} document @param {any} key */
  at(document, key) {
    this.document = document;
    this.key = key;
    if (this.shown && this.drawnFor === this.name()) this.draw();
  }

  /** What the curve stands for: the case without the value that is varied, and the range. */
  name() {
    const rest = this.document && withValue(this.document, this.path, undefined);
    return JSON.stringify([this.path, byId("curve-low").value, byId("curve-high").value, rest]);
  }

  /** Work the curve out anew if it stands for another case. */
  rested() {
    if (!this.shown || !this.document || !this.chosen()) return;
    const name = this.name();
    if (name !== this.drawnFor) void this.run(name);
    else this.draw();
  }

  /** Results and fields are read in other units from now on. */
  reread() {
    this.forget();
    if (this.chosen()) this.choose(this.path);
  }

  forget() {
    this.asking?.abort();
    this.asking = null;
    this.drawnFor = "";
    byId("curve").dataset.state = "idle";
  }

  /** @param {string} name */
  async run(name) {
    this.forget();
    const values = this.values();
    if (!values) {
      byId("curve-note").textContent = "Give two different numbers as ends, of one sign for a slider of ratios.";
      return;
    }
    const stop = new AbortController();
    this.asking = stop;
    this.drawnFor = name;
    this.points = new Map();
    byId("curve").dataset.state = "working";
    const [document, path, left] = [this.document, this.path, [...values]];
    while (left.length) {
      const answer = await this.ask({ document, path, values: left.slice(0, AT_ONCE) }, stop);
      if (stop.signal.aborted || !answer) return;
      if (!answer.ok) {
        byId("curve-note").textContent = answer.mistakes[0].sentence;
        byId("curve").dataset.state = "done";
        return;
      }
      for (const point of answer.points) this.points.set(point.value, point);
      left.splice(0, answer.points.length);
      this.nameQuantities(answer.quantities);
      this.draw();
    }
    byId("curve").dataset.state = "done";
  }

  /** @param {{document: object, path: string, values: number[]}} wanted @param {AbortController} stop */
  async ask(wanted, stop) {
    try {
      return await (await post("curve", wanted, stop.signal)).json();
    } catch {
      if (!stop.signal.aborted) byId("curve-note").textContent = AWAY;
      return null;
    }
  }

  /** The values of the points in the order in which they are asked for; null if the ends are no numbers. */
  values() {
    const choice = /** @type {Choice} */ (this.chosen());
    const factor = factorOf(choice.control);
    const [low, high] = ["curve-low", "curve-high"].map((end) => factor * Number(byId(end).value || NaN));
    const ratios = isLogarithmic(choice.slider);
    if (!Number.isFinite(low) || !Number.isFinite(high) || low === high || (ratios && !(low / high > 0))) return null;
    const value = (share) => (ratios ? low * (high / low) ** share : low + (high - low) * share);
    return inwards(POINTS).map((share) => Number(value(share).toPrecision(12)));
  }

  /** Offer what there is to draw, keeping the choice. @param {Quantity[]} quantities */
  nameQuantities(quantities) {
    if (JSON.stringify(quantities) === JSON.stringify(this.quantities)) return;
    this.quantities = quantities;
    const choice = byId("curve-quantity");
    const before = choice.value;
    choice.replaceChildren(...quantities.map(({ name, label }) => element("option", { value: name }, [label])));
    if (quantities.some(({ name }) => name === before)) choice.value = before;
  }

  draw() {
    const choice = this.chosen();
    const number = this.quantities.findIndex(({ name }) => name === byId("curve-quantity").value);
    if (!choice || number < 0 || byId("curve-figures").hidden) return;
    const factor = factorOf(choice.control);
    const along = [...this.points.values()].sort((one, other) => one.value - other.value);
    const x = along.map(({ value }) => value / factor);
    const y = along.map(({ numbers }) => numbers?.[number] ?? null);
    const failed = along.filter(({ sentence }) => sentence);
    const first = failed[0] && `${digits(failed[0].value / factor)} ${unitOf(choice.control)}: ${failed[0].sentence}`;
    byId("curve-note").textContent = first
      ? `${failed.length} of ${along.length} values have no solution, the first at ${first}`
      : "";
    const quantity = this.quantities[number];
    const [unit, upright] = [unitOf(choice.control), read(quantity.unit)];
    const label = capital(quantity.label);
    const range = /** @type {[number, number]} */ (d3.nice(...extent(y), 5));
    const panel = {
      name: "curve",
      heading: `${label} over ${choice.label}`,
      upright: { label, symbol: label, title: label, unit: upright[0], factor: upright[1], range },
      marks: [{ kind: "line", x, y }, { kind: "points", x, y, symbol: "dot" }, ...this.mark(choice, quantity, factor)],
      description: words(quantity, choice, x, y),
    };
    const title = unit ? `${choice.label} [${unit}]` : choice.label;
    const axis = { label: choice.label, symbol: choice.label, title, unit, factor: 1, range: this.range(), logarithmic: isLogarithmic(choice.slider) };
    drawPanels({ along: axis, panels: [panel] }, undefined, { last: "curve" });
  }

  /** What the fields say of where the curve begins and ends. @returns {[number, number]} */
  range() {
    const [low, high] = ["curve-low", "curve-high"].map((end) => Number(byId(end).value));
    return low < high ? [low, high] : [high, low];
  }

  /** The case that is shown. */
  mark(choice, quantity, factor) {
    const [value, number] = [valueOf(choice.slider, choice.control) / factor, this.key?.[quantity.name]];
    const [low, high] = this.range();
    if (!(low <= value && value <= high)) return [];
    const look = { colour: "ink", dash: "dashed" };
    const rule = { kind: "across", x: value, ...look };
    return Number.isFinite(number) ? [rule, { kind: "points", x: [value], y: [quantity.factor * number], ...look }] : [rule];
  }
}

/** Shares from 0 to 1, each half-way between those before it. @param {number} count */
function inwards(count) {
  const last = count - 1;
  const order = [0, last, last / 2];
  for (let step = last / 4; step >= 1; step /= 2) for (let at = step; at < last; at += 2 * step) order.push(at);
  return order.map((at) => at / last);
}

/** @param {string} text */
function capital(text) {
  return text.charAt(0).toUpperCase() + text.slice(1);
}

/** @param {Quantity} quantity @param {Choice} choice @param {number[]} x @param {(number | null)[]} y */
function words(quantity, choice, x, y) {
  const solved = y.flatMap((value, place) => (value === null ? [] : [{ value, at: x[place] }]));
  if (!solved.length) return `${capital(quantity.label)} over ${choice.label}: no value has a solution.`;
  const told = (each) => `${amount(each.value, quantity.unit)} at ${digits(each.at)} ${unitOf(choice.control)}`;
  const sorted = [...solved].sort((one, other) => one.value - other.value);
  return `${capital(quantity.label)} over ${choice.label}: least ${told(sorted[0])}, largest ${told(sorted[sorted.length - 1])}.`;
}
