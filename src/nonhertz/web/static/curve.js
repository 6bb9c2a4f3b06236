// The parameter curve: a number of the result over the range of one field, drawn while it is worked out.
//
// Points come a few at a time, from both ends and the middle inwards, so that the first answer already shows the shape.
// The curve belongs to the case without the field that is varied: while its slider is dragged only the mark moves.

import { extent } from "./chart.js";
import { byId } from "./elements.js";
import { slid } from "./fields.js";
import { AGAIN, answerTo } from "./live.js";
import { digits, rounded } from "./numbers.js";
import { drawPanels } from "./panel.js";
import { withValue } from "./paths.js";
import { html, render } from "./preact.js";
import { amount, read } from "./units.js";

const POINTS = 33; // a power of two and one
const AT_ONCE = 4; // points of a request
const AROUND = 2; // a slider of ratios is varied from its value divided by this to its value times this
const SHARE = 0.1; // of its range, by which any other slider is varied to either side

/** @typedef {import("./fields.js").Slid} Slid */
/** @typedef {{name: string, label: string, unit: string, factor: number}} Quantity */
/** @typedef {{value: number, numbers?: (number | null)[], sentence?: string}} Point */

export class Curve {
  /** @param {HTMLElement} form */
  constructor(form) {
    this.form = form;
    this.host = byId("curve");
    this.shown = false;
    this.path = "";
    this.ends = ["", ""]; // as they are written
    this.drawnFor = "";
    /** @type {Map<number, Point>} */
    this.points = new Map();
    /** @type {Quantity[]} */
    this.quantities = [];
    this.name = ""; // of the quantity that is drawn
    this.note = "";
    /** @type {any} */
    this.document = null;
    /** @type {any} */
    this.key = null;
    /** @type {AbortController | null} */
    this.asking = null;
    form.addEventListener("input", ({ target }) => this.follow(/** @type {HTMLElement} */ (target)));
    this.draw();
  }

  /** The fields with sliders that the form has now. @returns {Slid[]} */
  fields() {
    const sliders = [...this.form.querySelectorAll(".slider")].map((slider) => slid.get(slider));
    return /** @type {Slid[]} */ (sliders.filter((field) => field && Number.isFinite(field.value)));
  }

  field() {
    return this.fields().find(({ path }) => path === this.path);
  }

  /** Offer the fields that the form has now. */
  offer() {
    const paths = this.fields().map(({ path }) => path);
    if (paths.includes(this.path) || !paths.length) this.draw();
    else this.choose(paths.includes("load.load") ? "load.load" : paths[0]);
  }

  /** Vary what is being dragged, or read it in another unit. @param {HTMLElement} target */
  follow(target) {
    const path = /** @type {HTMLElement | null} */ (target.closest(".field"))?.dataset.path ?? "";
    if (target.matches(".slider") ? path !== this.path : target.matches("select.unit") && path === this.path)
      this.choose(path);
  }

  /** Vary another field, around the value that it has. @param {string} path */
  choose(path) {
    const field = this.fields().find((field) => field.path === path);
    if (!field) return;
    this.path = path;
    const [least, most] = d3.extent([field.span.low, field.span.high]);
    const within = (end) => Math.min(Math.max(end, least), most);
    const [value, wide] = [within(field.value), SHARE * (most - least)];
    const around = isLogarithmic(field) ? [value / AROUND, value * AROUND] : [value - wide, value + wide];
    const [low, high] = d3.extent(around).map(within);
    this.ends = [low, high].map((end) => rounded(end / field.factor, (high - low) / 100 / field.factor));
    this.rested();
  }

  /** @param {boolean} shown */
  toggle(shown) {
    this.shown = shown;
    this.note = "";
    if (shown) this.rested();
    else this.forget();
    this.draw();
  }

  /** Note the case that is shown now, and where it is on the curve. @param {any} document @param {any} key */
  at(document, key) {
    this.document = document;
    this.key = key;
    if (this.shown && this.drawnFor === this.stands()) this.draw();
  }

  /** What the curve stands for: the case without the value that is varied, and the range. */
  stands() {
    return JSON.stringify([this.path, this.ends, this.document && withValue(this.document, this.path, undefined)]);
  }

  /** Work the curve out anew if it stands for another case. */
  rested() {
    if (this.shown && this.document && this.field() && this.stands() !== this.drawnFor) void this.run();
    else this.draw();
  }

  /** Results and fields are read in other units from now on. */
  reread() {
    this.forget();
    this.choose(this.path);
  }

  forget() {
    this.asking?.abort();
    this.asking = null;
    this.drawnFor = "";
    this.host.dataset.state = "idle";
  }

  async run() {
    this.forget();
    const values = this.values();
    if (!values) {
      this.note = "The ends must be two different numbers, of the same sign where the slider is logarithmic.";
      this.draw();
      return;
    }
    const stop = new AbortController();
    this.asking = stop;
    this.drawnFor = this.stands();
    this.points = new Map();
    this.host.dataset.state = "working";
    this.draw();
    const { document, path } = this;
    while (values.length) {
      const answer = await answerTo("curve", { document, path, values: values.slice(0, AT_ONCE) }, stop.signal);
      if (stop.signal.aborted) return;
      if (!answer) {
        await new Promise((again) => window.setTimeout(again, AGAIN));
        continue;
      }
      if (!answer.ok) {
        this.note = answer.mistakes[0].sentence;
        break;
      }
      for (const point of answer.points) this.points.set(point.value, point);
      values.splice(0, answer.points.length);
      this.quantities = answer.quantities;
      if (!this.quantities.some(({ name }) => name === this.name)) this.name = this.quantities[0].name;
      const failed = this.along().filter(({ sentence }) => sentence);
      this.note = failed.length ? this.failure(failed) : "";
      this.draw();
    }
    this.host.dataset.state = "done";
    this.draw();
  }

  /** The values of the points in the order in which they are asked for; null if the ends are no numbers. */
  values() {
    const field = /** @type {Slid} */ (this.field());
    const [low, high] = this.ends.map((end) => field.factor * Number(end || NaN));
    const ratios = isLogarithmic(field);
    if (!Number.isFinite(low) || !Number.isFinite(high) || low === high || (ratios && !(low / high > 0))) return null;
    const value = (share) => (ratios ? low * (high / low) ** share : low + (high - low) * share);
    return inwards(POINTS).map((share) => Number(value(share).toPrecision(12)));
  }

  along() {
    return [...this.points.values()].sort((one, other) => one.value - other.value);
  }

  /** @param {Point[]} failed */
  failure([first, ...others]) {
    const { factor, unit } = /** @type {Slid} */ (this.field());
    const where = `${digits(first.value / factor)} ${unit}: ${first.sentence}`;
    return `${others.length + 1} of ${this.points.size} values have no solution, the first at ${where}`;
  }

  draw() {
    render(html`<${Choices} curve=${this} />`, this.host);
    const [field, number] = [this.field(), this.quantities.findIndex(({ name }) => name === this.name)];
    if (!field || number < 0 || !this.points.size) return;
    if (!this.shown || this.stands() !== this.drawnFor) return; // ends are being written
    const [quantity, along] = [this.quantities[number], this.along()];
    const x = along.map(({ value }) => value / field.factor);
    const y = along.map(({ numbers }) => numbers?.[number] ?? null);
    const [over, unit, upright] = [field.label(), field.unit, read(quantity.unit)];
    const [label, range] = [capital(quantity.label), d3.nice(...extent(y), 5)];
    const panel = {
      name: "curve",
      heading: `${label} over ${over}`,
      upright: { label, symbol: label, title: label, unit: upright[0], factor: upright[1], range },
      marks: [{ kind: "line", x, y }, { kind: "points", x, y, symbol: "dot" }, ...this.mark(field, quantity)],
      description: words(quantity, field, x, y),
    };
    const axis = { label: over, symbol: over, title: unit ? `${over} [${unit}]` : over, unit, factor: 1 };
    const scale = { range: this.range(), logarithmic: isLogarithmic(field) };
    drawPanels({ along: { ...axis, ...scale }, panels: [panel] }, undefined, { last: "curve" });
  }

  /** Where the curve begins and ends, in the unit of the field. @returns {[number, number]} */
  range() {
    return d3.extent(this.ends.map(Number));
  }

  /** The case that is shown. @param {Slid} field @param {Quantity} quantity */
  mark(field, quantity) {
    const [value, number] = [field.value / field.factor, this.key?.[quantity.name]];
    const [low, high] = this.range();
    if (!(low <= value && value <= high)) return [];
    const look = { colour: "ink", dash: "dashed" };
    const rule = { kind: "across", x: value, ...look };
    return Number.isFinite(number) ? [rule, { kind: "points", x: [value], y: [quantity.factor * number], ...look }] : [rule];
  }
}

/** What is varied, from where to where, and which number is drawn. @param {{curve: Curve}} props */
function Choices({ curve }) {
  const options = (all) => all.map(([value, label]) => html`<option value=${value}>${label}</option>`);
  const end = (name, at) => html`<input type="text" id="curve-${name}" size="8" autocomplete="off" spellcheck=${false}
    value=${curve.ends[at]} onInput=${({ target }) => (curve.ends[at] = target.value)} onChange=${() => curve.rested()} />`;
  const draw = ({ target }) => {
    curve.name = target.value;
    curve.draw();
  };
  return html`<div class="stress-head">
      <h2 id="curve-title">Parameter curve</h2>
      <label class="check"><input type="checkbox" id="curve-on" checked=${curve.shown}
        onChange=${({ target }) => curve.toggle(target.checked)} /> shown</label>
      <span class="curve-choices" id="curve-choices" hidden=${!curve.shown}>
        <label>over <select id="curve-path" value=${curve.path} onChange=${({ target }) => curve.choose(target.value)}>
          ${options(curve.fields().map(({ path, label }) => [path, label()]))}</select></label>
        <label>from ${end("low", 0)}</label> <label>to ${end("high", 1)}</label>
        <span class="unit">${curve.field()?.unit}</span>
        <label>of <select id="curve-quantity" value=${curve.name} onChange=${draw}>
          ${options(curve.quantities.map(({ name, label }) => [name, label]))}</select></label></span></div>
    <p class="hint" id="curve-note" role="status">${curve.note}</p>
    <div class="figures" hidden=${!curve.shown}>
      <figure data-figure="curve"><figcaption></figcaption><div class="drawing"></div></figure></div>`;
}

/** Whether a slider's steps are ratios. @param {Slid} field */
function isLogarithmic({ span }) {
  return span.scale === "log";
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

/** @param {Quantity} quantity @param {Slid} field @param {number[]} x @param {(number | null)[]} y */
function words(quantity, field, x, y) {
  const solved = y.flatMap((value, place) => (value === null ? [] : [{ value, at: x[place] }]));
  if (!solved.length) return `${capital(quantity.label)} over ${field.label()}: no value has a solution.`;
  const inWords = (point) => `${amount(point.value, quantity.unit)} at ${digits(point.at)} ${field.unit}`;
  const sorted = [...solved].sort((one, other) => one.value - other.value);
  return `${capital(quantity.label)} over ${field.label()}: least ${inWords(sorted[0])}, largest ${inWords(sorted[sorted.length - 1])}.`;
}
