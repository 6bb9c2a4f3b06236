// Both bodies at scale, across the contact and along it, so that one sees what is pressed on what; what is changed is
// marked.

import { byId, drawn } from "./elements.js";
import { text } from "./polar.js";
import { amount } from "./units.js";

const [WIDTH, HEIGHT, ACROSS] = [330, 132, 120]; // pixels, the last of the view across the contact
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
    this.host.replaceChildren();
  }

  /** @param {Record<string, Seen>} bodies */
  draw(bodies) {
    const pairs = /** @type {["a" | "b", Seen][]} */ (Object.entries(bodies));
    const sizes = pairs.filter(([, { curvature }]) => curvature).map(([, { curvature }]) => 2 / Math.abs(curvature));
    const lengths = pairs.map(([, { interval: [low, high] }]) => (low === null || high === null ? Infinity : high - low));
    const size = Math.min(...sizes, 1e4);
    const length = Math.min(...lengths, 1e4);
    const scale = Math.min((HEIGHT - 8) / ((ABOVE + BELOW) * size), (WIDTH - ACROSS - 28) / length);
    const ground = 4 + Math.max(ABOVE * size * scale, HEIGHT - 8 - BELOW * size * scale); // pixels down to the contact
    const svg = drawn("svg", { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: "img", "aria-label": words(pairs) });
    const middle = [ACROSS / 2, (ACROSS + WIDTH) / 2];
    for (const [name, body] of pairs) {
      const shapes = [across(name, body, scale), alongside(name, body, scale)].map((shape, view) => {
        const window = drawn("svg", { x: view ? ACROSS : 0, y: 0, width: view ? WIDTH - ACROSS : ACROSS, height: HEIGHT });
        shape.setAttribute("transform", `translate(${middle[view] - (view ? ACROSS : 0)} ${ground})`);
        window.append(shape);
        return window;
      });
      const label = text(ACROSS - 2, name === "a" ? ground - 8 : ground + 14, name, "name");
      const group = drawn("g", { class: this.changed.startsWith(`body.${name}`) ? `body ${name} changed` : `body ${name}` });
      group.append(...shapes, label);
      svg.append(group);
    }
    const tip = ground - Math.min(sizeOf(bodies.a, size) * scale, ground - 18) - 2;
    const arrow = `M${middle[1]} ${Math.max(0, tip - 16)}V${tip}m-4 -6l4 6l4 -6`;
    svg.append(drawn("path", { d: arrow, class: this.changed.startsWith("load") ? "load changed" : "load" }));
    this.host.replaceChildren(svg);
  }
}

/** How high a body is seen [mm]: all of a convex one. @param {Seen} body @param {number} size */
function sizeOf({ curvature }, size) {
  return curvature > 0 ? 2 / curvature : 0.3 * size;
}

/** A body in the plane across the contact, whose point is the origin. @param {"a" | "b"} name @param {Seen} body */
function across(name, { curvature }, scale) {
  const up = name === "a" ? -1 : 1; // pixels go down
  if (!curvature) return drawn("path", { d: `M${-FAR} 0H${FAR}V${up * FAR}H${-FAR}Z` });
  const radius = scale / Math.abs(curvature);
  const side = curvature > 0 ? up : -up;
  const circle = `M0 0A${radius} ${radius} 0 0 1 0 ${side * 2 * radius}A${radius} ${radius} 0 0 1 0 0Z`;
  // Around a hollow there is material everywhere else on this side.
  const around = curvature > 0 ? "" : `M${-FAR} ${-up * FAR}H${FAR}V${up * FAR}H${-FAR}Z`;
  return drawn("path", { d: around + circle, "fill-rule": "evenodd" });
}

/** The same from the side. @param {"a" | "b"} name @param {Seen} body */
function alongside(name, { curvature, interval }, scale) {
  const [low, high] = interval.map((end, place) => (end === null ? (place ? FAR : -FAR) : end * scale));
  const depth = (name === "a" ? -1 : 1) * (curvature > 0 ? (2 * scale) / curvature : FAR);
  return drawn("path", { d: `M${low} 0H${high}V${depth}H${low}Z` });
}

/** @param {["a" | "b", Seen][]} pairs */
function words(pairs) {
  const told = pairs.map(([name, { curvature, interval: [low, high] }]) => {
    const round = curvature ? `${curvature < 0 ? "hollow, " : ""}diameter ${amount(Math.abs(2 / curvature), "mm")}` : "flat";
    return `body ${name}, ${round}${low === null || high === null ? "" : `, ${amount(high - low, "mm")} long`}`;
  });
  return `At scale: ${told.join(" pressed on ")}.`;
}
