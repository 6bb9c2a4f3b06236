// Both bodies at scale, across the contact and along it, with their dimensions; the body that is changed is marked.
// Profiles and tilt are so small that they are enlarged.

import { byId } from "./elements.js";
import { digits } from "./numbers.js";
import { html, render } from "./preact.js";
import { amount } from "./units.js";

const [WIDTH, HEIGHT, ACROSS] = [330, 150, 120]; // pixels, the last of the view across the contact
const WIDE = 140; // pixels, above which a length stands within its dimension
const [TOP, RELIEF, TILT] = [20, 7, 2.5]; // pixels above for the dimension, and of the deepest relief; degrees of a tilt
const [ABOVE, BELOW] = [1.12, 0.5]; // of the smaller diameter, that are seen of body a and of body b
const FAR = 1e5; // pixels, beyond any view

/**
 * @typedef {{curvature: number, interval: [number | null, number | null]}} Seen [1/mm], [mm]
 */

export class Sketch {
  /** @param {HTMLElement} form */
  constructor(form) {
    this.host = byId("sketch");
    this.changed = "";
    form.addEventListener("input", ({ target }) => {
      this.changed = /** @type {HTMLElement} */ (target).closest("[data-path]")?.dataset.path ?? "";
    });
  }

  /** Another case is begun. */
  clear() {
    this.changed = "";
    render(null, this.host);
  }

  /** @param {import("./types.js").Answer} answer */
  draw(answer) {
    render(html`<${Picture} answer=${answer} changed=${this.changed} />`, this.host);
  }
}

/** @param {{answer: import("./types.js").Answer, changed: string}} props with the path of what was changed last */
function Picture({ answer: { bodies, profiles, key }, changed }) {
  const pairs = /** @type {["a" | "b", Seen][]} */ (Object.entries(bodies));
  const sizes = pairs.filter(([, { curvature }]) => curvature).map(([, { curvature }]) => 2 / Math.abs(curvature));
  const lengths = pairs.map(([, { interval: [low, high] }]) => (low === null || high === null ? Infinity : high - low));
  const size = Math.min(...sizes, 1e4);
  const length = Math.min(...lengths, 1e4);
  const room = HEIGHT - TOP - 4;
  const scale = Math.min(room / ((ABOVE + BELOW) * size), (WIDTH - ACROSS - 28) / length);
  const ground = TOP + Math.max(ABOVE * size * scale, room - BELOW * size * scale); // pixels down to the contact
  const middle = (WIDTH - ACROSS) / 2;
  const tip = ground - Math.min(sizeOf(bodies.a, size) * scale, ground - 18) - 2;
  const marked = (path) => (changed.startsWith(path) ? "changed" : "");
  const body = ([name, seen]) => html`<g class="body ${name} ${marked(`body.${name}`)}">
    <svg width=${ACROSS} height=${HEIGHT}>
      <path fill-rule="evenodd" d=${across(name, seen, scale)} transform="translate(${ACROSS / 2} ${ground})" /></svg>
    <svg x=${ACROSS} width=${2 * middle} height=${HEIGHT}>
      <path d=${alongside(name, seen, profiles[name], scale)} transform="translate(${middle} ${ground}) rotate(${
        name === "a" ? Math.sign(key.tilt) * TILT : 0
      })" /></svg>
    <text x=${ACROSS - 2} y=${name === "a" ? ground - 8 : ground + 14}>${name}</text></g>`;
  return html`<svg viewBox="0 0 ${WIDTH} ${HEIGHT}" role="img" aria-label=${words(pairs)}>
    ${pairs.map(body)}<${Dimensions} ...${{ seen: bodies.a, scale, ground }} />
    <path class="load ${marked("load")}" d="M${ACROSS + middle} ${Math.max(0, tip - 16)}V${tip}m-4 -6l4 6l4 -6" />
    ${key.tilt !== 0 && html`<text x=${WIDTH - 4} y=${HEIGHT - 6}>tilt ${digits(1e3 * key.tilt, 3)} mrad, enlarged</text>`}</svg>`;
}

/** How high a body is seen [mm]: all of a convex one. @param {Seen} body @param {number} size */
function sizeOf({ curvature }, size) {
  return curvature > 0 ? 2 / curvature : 0.3 * size;
}

/** The path of a body in the plane across the contact, whose point is the origin. @param {"a" | "b"} name @param {Seen} body */
function across(name, { curvature }, scale) {
  const up = name === "a" ? -1 : 1; // pixels go down
  if (!curvature) return `M${-FAR} 0H${FAR}V${up * FAR}H${-FAR}Z`;
  const radius = scale / Math.abs(curvature);
  const side = curvature > 0 ? up : -up;
  const circle = `M0 0A${radius} ${radius} 0 0 1 0 ${side * 2 * radius}A${radius} ${radius} 0 0 1 0 0Z`;
  // Around a hollow there is material everywhere else on this side.
  return `${curvature > 0 ? "" : `M${-FAR} ${-up * FAR}H${FAR}V${up * FAR}H${-FAR}Z`}${circle}`;
}

/**
 * The same from the side, with its profile.
 * @param {"a" | "b"} name
 * @param {Seen} body
 * @param {import("./panel.js").Figure | undefined} profile
 * @param {number} scale
 */
function alongside(name, { curvature, interval }, profile, scale) {
  const [low, high] = interval.map((end, place) => (end === null ? (place ? FAR : -FAR) : end * scale));
  const up = name === "a" ? -1 : 1;
  const depth = up * (curvature > 0 ? (2 * scale) / curvature : FAR);
  const [panel] = profile?.panels ?? [];
  const line = panel?.marks.find(({ kind }) => kind === "line") ?? { x: [], y: [] };
  const deepest = panel ? panel.upright.range[0] : 1;
  const surface = line.x.map((y, place) => {
    const relief = Math.min(line.y[place] ?? Infinity, 2 * deepest);
    return `L${(y * scale).toFixed(1)} ${((up * RELIEF * relief) / deepest).toFixed(1)}`;
  });
  const flat = interval.includes(null) || !line.y.some((relief) => relief !== 0);
  return `M${low} ${depth}V0${flat ? `H${high}` : surface.join("")}L${high} ${depth}Z`;
}

/** The diameter in the round view and the length over the other, of body a; the other's in words. */
function Dimensions({ seen: { curvature, interval: [low, high] }, scale, ground }) {
  const [from, to] = [low, high].map((end) => (WIDTH + ACROSS) / 2 + end * scale);
  const wide = to - from > WIDE;
  const length = low !== null && high !== null && html`
    <path class="dimension" d="M${from} 9H${to}M${from} 5V13M${to} 5V13" />
    <text class="size ${wide ? "halo" : "beside"}" x=${wide ? from + 0.22 * (to - from) : to + 6} y="9">${short(high - low)}</text>`;
  const round = curvature > 0 && html`<text class="size" x=${ACROSS / 2} y=${ground - scale / curvature}>⌀ ${short(2 / curvature)}</text>`;
  return html`<g class="a">${round}${length}</g>`;
}

/** A length as on a drawing. @param {number} length mm */
function short(length) {
  return amount(length, "mm", 4).replace(/\.?0+(?= )/, "");
}

/** @param {["a" | "b", Seen][]} pairs */
function words(pairs) {
  const bodies = pairs.map(([name, { curvature, interval: [low, high] }]) => {
    const round = curvature ? `${curvature < 0 ? "hollow, " : ""}diameter ${amount(Math.abs(2 / curvature), "mm")}` : "flat";
    return `body ${name}, ${round}${low === null || high === null ? "" : `, ${amount(high - low, "mm")} long`}`;
  });
  return `At scale: ${bodies.join(" pressed on ")}.`;
}
