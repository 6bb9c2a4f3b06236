// What all figures share: margins, axes, common marks, and text alternatives.

import { html, render } from "./preact.js";
import { save } from "./save.js";

export const INK = "currentColor";
export const FIRST = "var(--first)";
export const SECOND = "var(--second)";
const PINNED = "var(--pinned)";
export const FAINT = "var(--faint)";

// The same side margins for all figures along y, so that the same y lines up.
export const MARGINS = { marginLeft: 58, marginRight: 16, marginTop: 14, marginBottom: 24 };
export const NAMED = 38; // the bottom margin where the axis has a label

/** 2000, not 2,000, which half the world reads as 2. @param {number} value */
export const PLAIN = (value) => String(Number(value.toPrecision(4))).replace("-", "\u2212");

// Widths of the drawings. Asking the browser after each drawing would force it to lay out the page six times.
/** @type {WeakMap<Element, number>} */
const widths = new WeakMap();
/** @type {() => void} */
let resized = () => {};
const observer = new ResizeObserver((entries) => {
  const changed = entries.filter(
    ({ target, contentRect }) => contentRect.width > 0 && widths.get(target) !== Math.floor(contentRect.width),
  );
  for (const { target, contentRect } of changed) widths.set(target, Math.floor(contentRect.width));
  if (changed.length) resized();
});

/** Set what to call when the width of a drawing changes. @param {() => void} redraw */
export function whenResized(redraw) {
  resized = redraw;
}

const STILL = 150; // ms without anything to draw, after which figures out of sight are drawn, too
/** @type {Map<HTMLElement, () => void>} */
const waiting = new Map();
/** @type {WeakSet<Element>} */
const unseen = new WeakSet();
const sight = new IntersectionObserver((entries) => {
  for (const { target, isIntersecting } of entries) {
    if (isIntersecting) unseen.delete(target);
    else unseen.add(target);
    if (isIntersecting) drawNow(/** @type {HTMLElement} */ (target));
  }
});
let still = 0;

/** Draw a figure now if it is in sight, otherwise when it comes there or a drag rests. @param {HTMLElement} host @param {() => void} drawing */
export function whenSeen(host, drawing) {
  sight.observe(host);
  waiting.set(host, drawing);
  window.clearTimeout(still);
  still = window.setTimeout(() => [...waiting.keys()].forEach(drawNow), STILL);
  if (!unseen.has(host)) drawNow(host);
  else document.documentElement.toggleAttribute("data-drawing", true);
}

/** @param {HTMLElement} host */
function drawNow(host) {
  const drawing = waiting.get(host);
  waiting.delete(host);
  drawing?.();
  document.documentElement.toggleAttribute("data-drawing", waiting.size > 0);
}

/** The width of a figure's drawing in pixels. @param {HTMLElement} host */
export function widthOf(host) {
  const room = /** @type {HTMLElement} */ (host.querySelector(".drawing"));
  const known = widths.get(room);
  if (known) return known;
  if (room.clientWidth) widths.set(room, room.clientWidth);
  observer.observe(room);
  return Math.max(200, room.clientWidth);
}

/** The same without the margins. @param {HTMLElement} host */
export function innerWidthOf(host) {
  return widthOf(host) - MARGINS.marginLeft - MARGINS.marginRight;
}

/** @param {string} name @returns {HTMLElement} */
export function figure(name) {
  return /** @type {HTMLElement} */ (document.querySelector(`[data-figure="${name}"]`));
}

/**
 * Draw into a figure, with a text alternative.
 * @param {HTMLElement} host
 * @param {any} options for Plot, without the width
 * @param {string} words
 */
export function draw(host, options, words) {
  const room = /** @type {HTMLElement} */ (host.querySelector(".drawing"));
  const chart = Plot.plot({ ...options, width: widthOf(host), style: { fontSize: "11px", overflow: "visible" } });
  // Screen readers read the text alternative; the labels that Plot gives to groups would not be read. Groups that follow
  // the pointer are drawn anew, with their labels: they are hidden where they are made.
  for (const group of chart.querySelectorAll("g[aria-label]")) group.removeAttribute("aria-label");
  chart.setAttribute("role", "img");
  chart.setAttribute("aria-label", words);
  room.replaceChildren(chart);
  return chart;
}

/**
 * Write the heading and the legend of a figure.
 * @param {HTMLElement} host
 * @param {string} heading
 * @param {[string, string][]} key class of the swatch, words
 * @param {string} [remark]
 */
export function head(host, heading, key, remark = "") {
  const caption = /** @type {HTMLElement} */ (host.querySelector("figcaption"));
  const text = `${heading}|${key.join()}|${remark}`;
  if (caption.dataset.text === text) return; // as in most steps of a drag
  caption.dataset.text = text;
  const kinds = /** @type {("svg" | "png" | "csv")[]} */ (["svg", "png", "csv"]);
  const saver = (kind) => html`<button type="button" aria-label="Save as ${kind.toUpperCase()}"
    onClick=${() => void save(host, kind)}>${kind.toUpperCase()}</button>`;
  render(
    html`<span class="heading">${heading}</span>
      ${key.map(([style, words]) => html`<span class="entry"><span class="swatch ${style}"></span>${words}</span>`)}
      ${remark && html`<span class="remark">${remark}</span>`}
      <span class="savers">${kinds.map(saver)}</span>`,
    caption,
  );
}

/** A line through points. @param {(number|null)[]} x @param {(number|null)[]} y @param {object} options */
function line(x, y, options) {
  return Plot.line(x, { x, y, strokeWidth: 1.6, ...options });
}

/**
 * The readout at the pointer: a hairline and a text box.
 * @param {(number|null)[]} x
 * @param {(number|null)[]} y
 * @param {(position: number) => string} words
 */
export function reading(x, y, words) {
  const near = { maxRadius: 60, ariaHidden: true };
  const at = Plot.pointerX({ x, y, ...near });
  return [
    Plot.ruleX(x, Plot.pointerX({ x, ...near, stroke: FAINT, strokeWidth: 0.7 })),
    Plot.tip(x, { ...at, title: (_, position) => words(position), fill: "var(--surface)", stroke: "var(--rule)" }),
  ];
}

/** The range of the finite numbers. @param {(number|null)[]} values */
export function extent(values) {
  let [low, high] = [Infinity, -Infinity];
  for (const value of values) {
    if (value === null || !Number.isFinite(value)) continue;
    if (value < low) low = value;
    if (value > high) high = value;
  }
  return /** @type {[number, number]} */ (low <= high ? [low, high] : [0, 1]);
}

/** What the pinned case is called whose lines are drawn. @param {any[]} pins */
export function pinnedAs(pins) {
  return pins.length > 1 ? "first pinned" : "pinned";
}

/** The line of a pinned case, if there is one. */
export function pinnedLine(y, values) {
  return y && values ? [line(y, values, { stroke: PINNED, strokeDasharray: "2 3", strokeWidth: 1.8, clip: true })] : [];
}
