// Tilting a body by the ends of its undeformed surface, in the picture of the distance of the surfaces.
//
// A handle moves the slider of the tilt, so that a drag is rounded, solved and undone as one of the slider. While it is
// held the vertical axis stays as it was: otherwise the end would run away from the pointer.

import { element } from "./elements.js";
import { ends, valueOf } from "./fields.js";
import { spelled } from "./units.js";

const PATH = "load.tilt";
const MICROMETRES = 1e3; // in a mm
const LEARNING = 2e-5; // rad, beyond which the response of an end is not lost in the steps of the slider
const UNLIKE = 3; // times the distance from the middle: a lever beyond is of a contact that has changed its nature
/** @type {Record<string, number>} positions of the slider by which a key raises the end */
const KEYS = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1, PageUp: 10, PageDown: -10 };

/** @typedef {{x: (y: number) => number, y: (distance: number) => number, height: number, limits: [number, number]}} Axes */
/** @typedef {{slider: HTMLInputElement, control: HTMLInputElement}} Field */
/** @typedef {{handle: HTMLElement, place: number, at: number, distance: number, tilt: number, lever: number,
 *   limits: [number, number], scale: number}} Held */

export class Tilt {
  /** @param {HTMLElement} host the figure @param {() => void} redraw */
  constructor(host, redraw) {
    this.redraw = redraw;
    /** @type {Axes | null} */
    this.axes = null;
    this.middle = 0;
    /** @type {Held | null} */
    this.held = null;
    this.handles = ["left", "right"].map((side) => this.handle(side));
    host.append(element("div", { class: "handles" }, this.handles));
  }

  /** The vertical axis while a handle is held. @returns {[number, number] | null} */
  get limits() {
    return this.held?.limits ?? null;
  }

  /** @param {string} side */
  handle(side) {
    const handle = element("span", {
      role: "slider",
      tabindex: "0",
      class: "handle",
      "aria-label": `Tilt, by the ${side} end of the undeformed surface`,
      "aria-orientation": "vertical",
      title: "Drag up or down to tilt",
      hidden: true,
      pointerdown: (event) => this.hold(event, handle),
      pointermove: (event) => this.drag(event),
      pointerup: () => this.release(),
      lostpointercapture: () => this.release(),
      keydown: (event) => this.press(event, Number(handle.dataset.place)),
    });
    return handle;
  }

  /**
   * Place the handles at the outermost points of the undeformed surface that are drawn.
   * @param {{x: number[], y: (number | null)[]}} surface its distance from the other one [mm]
   * @param {number} tilt
   * @param {Axes} axes
   */
  place({ x: y, y: before }, tilt, axes) {
    this.axes = axes;
    this.learn(before[d3.bisectCenter(y, this.held?.place ?? 0)], tilt);
    const drawn = y.filter((_, place) => isWithin(before[place], axes.limits));
    const field = fieldOf();
    this.middle = 0.5 * (y[0] + y[y.length - 1]);
    const found = [drawn[0], drawn[drawn.length - 1]];
    for (const [number, handle] of this.handles.entries()) {
      // The one that is held stays at its place along y.
      const at = this.held?.handle === handle ? this.held.place : found[number];
      const hides = !field || at === undefined || at === this.middle;
      if (handle.hidden !== hides) handle.hidden = hides;
      if (hides) continue;
      const [low, high] = axes.limits;
      const value = Math.min(high, Math.max(low, before[d3.bisectCenter(y, at)] ?? high));
      handle.dataset.place = String(at);
      handle.style.left = `${axes.x(at).toFixed(1)}px`;
      handle.style.bottom = `${(axes.height - axes.y(value)).toFixed(1)}px`;
      handle.dataset.distance = String(value);
      handle.dataset.tilt = String(tilt);
      this.describe(handle, at, field);
    }
  }

  /**
   * Under a given load the approach changes with the tilt, and the body does not turn about its middle: how far the end
   * that is held has moved for the tilt so far says how far it will.
   * @param {number | null} distance
   * @param {number} tilt
   */
  learn(distance, tilt) {
    if (!this.held || distance === null) return;
    const { place, distance: first, tilt: began } = this.held;
    const turned = tilt - began;
    const lever = (first - distance) / turned / (place - this.middle);
    if (Math.abs(turned) >= LEARNING && lever > 1 / UNLIKE && lever < UNLIKE) this.held.lever = lever;
  }

  /** Say how far the end is raised by the tilt. @param {HTMLElement} handle @param {number} at @param {Field} field */
  describe(handle, at, { slider, control }) {
    const rise = (tilt) => -MICROMETRES * (at - this.middle) * tilt;
    const now = rise(valueOf(slider, control) || 0);
    const range = ends(slider).map(rise);
    for (const [name, value] of /** @type {[string, number][]} */ ([
      ["now", now],
      ["min", Math.min(...range)],
      ["max", Math.max(...range)],
    ]))
      handle.setAttribute(`aria-value${name}`, String(Number(value.toPrecision(4))));
    const up = `${spelled(Math.abs(now), "µm", 3)} ${now < 0 ? "down" : "up"}`;
    handle.setAttribute("aria-valuetext", `tilt ${slider.getAttribute("aria-valuetext")}, ${up}`);
  }

  /** @param {PointerEvent} event @param {HTMLElement} handle */
  hold(event, handle) {
    const field = fieldOf();
    if (!field || !this.axes || event.button !== 0) return;
    handle.setPointerCapture(event.pointerId);
    const { limits, y } = this.axes;
    const [distance, tilt] = [Number(handle.dataset.distance), Number(handle.dataset.tilt)];
    const scale = (limits[1] - limits[0]) / (y(limits[0]) - y(limits[1])); // mm of a pixel
    this.held = { handle, place: Number(handle.dataset.place), at: event.clientY, distance, tilt, lever: 1, limits, scale };
  }

  /** @param {PointerEvent} event */
  drag(event) {
    if (!this.held) return;
    const { place, at, tilt: began, lever, scale } = this.held;
    const risen = scale * (at - event.clientY);
    const field = fieldOf();
    if (!field) return;
    const [low, high] = ends(field.slider);
    const tilt = began - risen / (place - this.middle) / lever;
    move(field, (Number(field.slider.max) * (tilt - low)) / (high - low));
  }

  release() {
    if (!this.held) return;
    this.held = null;
    this.redraw();
  }

  /** @param {KeyboardEvent} event @param {number} place */
  press(event, place) {
    const field = fieldOf();
    const most = Number(field?.slider.max);
    const raises = place > this.middle ? -1 : 1; // positions of the slider that raise this end
    const extreme = { Home: -1, End: 1 }[event.key];
    if (!field || (KEYS[event.key] === undefined && extreme === undefined)) return;
    event.preventDefault();
    if (extreme === undefined) move(field, Number(field.slider.value) + raises * KEYS[event.key]);
    else move(field, extreme === raises ? most : 0);
  }
}

/** Move the slider of the tilt as if by hand. @param {Field} field @param {number} position */
function move({ slider }, position) {
  const before = slider.value;
  slider.value = String(Math.round(position)); // within its range
  if (slider.value !== before) slider.dispatchEvent(new Event("input", { bubbles: true }));
}

/** The field of the tilt with its slider, null where the tilt is a result. @returns {Field | null} */
function fieldOf() {
  const field = document.querySelector(`#case .field[data-path="${PATH}"]`);
  const slider = /** @type {HTMLInputElement | null} */ (field?.querySelector('input[type="range"]') ?? null);
  const control = /** @type {HTMLInputElement | null} */ (field?.querySelector(`[name="${PATH}"]`) ?? null);
  if (!slider || !control) return null;
  return control.value.trim() === "" || Number.isFinite(valueOf(slider, control)) ? { slider, control } : null;
}

/** @param {number | null} value @param {[number, number]} limits */
function isWithin(value, [low, high]) {
  return value !== null && low <= value && value <= high;
}
