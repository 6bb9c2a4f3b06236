// Tilting a body by the ends of its undeformed surface, in the picture of the distance of the surfaces.
//
// A handle moves the slider of the tilt, so that a drag is rounded, solved and undone like one of the slider. Meanwhile
// the vertical axis does not change: otherwise the end would run away from the pointer.

import { slid } from "./fields.js";
import { html, render } from "./preact.js";
import { spelled } from "./units.js";

const PATH = "load.tilt";
const MICROMETRES = 1e3; // in a mm
const LEARNING = 2e-5; // rad, beyond which the response of an end is not lost in the steps of the slider
const UNLIKE = 3; // times the distance from the middle: a lever beyond is of a contact that has changed its nature
/** @type {Record<string, number>} positions of the slider by which a key raises the end */
const KEYS = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1, PageUp: 10, PageDown: -10 };

/** @typedef {{x: (y: number) => number, y: (distance: number) => number, height: number, limits: [number, number]}} Axes */
/** @typedef {import("./fields.js").Slid & {slider: HTMLInputElement}} Field */
/** @typedef {{y: number, distance: number, left: number, bottom: number}} End of the surface [mm], and where it is drawn */
/** @typedef {End & {side: string, at: number, tilt: number, lever: number, limits: [number, number], scale: number}} Held */

export class Tilt {
  /** @param {HTMLElement} host the figure @param {() => void} redraw */
  constructor(host, redraw) {
    this.redraw = redraw;
    /** @type {Axes | null} */
    this.axes = null;
    this.middle = 0;
    this.tilt = 0;
    /** @type {Held | null} */
    this.grip = null;
    this.handles = document.createElement("div");
    this.handles.className = "handles";
    host.append(this.handles);
  }

  /** The vertical axis while a handle is held. @returns {[number, number] | null} */
  get limits() {
    return this.grip?.limits ?? null;
  }

  /**
   * Place the handles at the outermost points of the undeformed surface that are drawn.
   * @param {{x: number[], y: (number | null)[]}} surface its distance from the other one [mm]
   * @param {number} tilt
   * @param {Axes} axes
   */
  place({ x: y, y: before }, tilt, axes) {
    [this.axes, this.tilt, this.middle] = [axes, tilt, 0.5 * (y[0] + y[y.length - 1])];
    this.learn(before[d3.bisectCenter(y, this.grip?.y ?? 0)], tilt);
    const drawn = y.filter((_, place) => isWithin(before[place], axes.limits));
    const [field, [low, high]] = [fieldOf(), axes.limits];
    const handle = (side, outermost) => {
      const at = this.grip?.side === side ? this.grip.y : outermost; // the one that is held stays at its place along y
      if (!field || at === undefined || at === this.middle) return null;
      const distance = Math.min(high, Math.max(low, before[d3.bisectCenter(y, at)] ?? high));
      const end = { y: at, distance, left: axes.x(at), bottom: axes.height - axes.y(distance) };
      return html`<${Handle} key=${side} ...${{ tilting: this, side, end, field }} />`;
    };
    render([handle("left", drawn[0]), handle("right", drawn[drawn.length - 1])], this.handles);
  }

  /**
   * Under a given load the approach changes with the tilt, and the body does not turn about its middle: how far the end
   * that is held has moved for the tilt so far says how far it will.
   * @param {number | null} distance
   * @param {number} tilt
   */
  learn(distance, tilt) {
    if (!this.grip || distance === null) return;
    const { y, distance: first, tilt: began } = this.grip;
    const turned = tilt - began;
    const lever = (first - distance) / turned / (y - this.middle);
    if (Math.abs(turned) >= LEARNING && lever > 1 / UNLIKE && lever < UNLIKE) this.grip.lever = lever;
  }

  /** @param {PointerEvent} event @param {string} side @param {End} end */
  hold(event, side, end) {
    if (!this.axes || event.button !== 0) return;
    /** @type {HTMLElement} */ (event.target).setPointerCapture(event.pointerId);
    const { limits, y } = this.axes;
    const scale = (limits[1] - limits[0]) / (y(limits[0]) - y(limits[1])); // mm of a pixel
    this.grip = { ...end, side, at: event.clientY, tilt: this.tilt, lever: 1, limits, scale };
  }

  /** @param {PointerEvent} event */
  drag(event) {
    if (!this.grip) return;
    const { y, at, tilt: began, lever, scale } = this.grip;
    const risen = scale * (at - event.clientY);
    const field = fieldOf();
    if (!field) return;
    const { low, high } = field.span;
    const tilt = began - risen / (y - this.middle) / lever;
    move(field, (Number(field.slider.max) * (tilt - low)) / (high - low));
  }

  release() {
    if (!this.grip) return;
    this.grip = null;
    this.redraw();
  }

  /** @param {KeyboardEvent} event @param {End} end */
  press(event, { y }) {
    const field = fieldOf();
    const most = Number(field?.slider.max);
    const raises = y > this.middle ? -1 : 1; // positions of the slider that raise this end
    const extreme = { Home: -1, End: 1 }[event.key];
    if (!field || (KEYS[event.key] === undefined && extreme === undefined)) return;
    event.preventDefault();
    if (extreme === undefined) move(field, Number(field.slider.value) + raises * KEYS[event.key]);
    else move(field, extreme === raises ? most : 0);
  }
}

/** A handle, which says how far the tilt raises its end. @param {{tilting: Tilt, side: string, end: End, field: Field}} props */
function Handle({ tilting, side, end, field: { slider, span, value } }) {
  const rise = (tilt) => -MICROMETRES * (end.y - tilting.middle) * tilt;
  const now = rise(value || 0);
  const [least, most] = d3.extent([rise(span.low), rise(span.high)]);
  const shown = (number) => String(Number(number.toPrecision(4)));
  const up = `${spelled(Math.abs(now), "µm", 3)} ${now < 0 ? "down" : "up"}`;
  return html`<span role="slider" tabindex="0" class="handle" title="Drag up or down to tilt"
    style=${{ left: `${end.left.toFixed(1)}px`, bottom: `${end.bottom.toFixed(1)}px` }}
    aria-label="Tilt, by the ${side} end of the undeformed surface" aria-orientation="vertical"
    aria-valuenow=${shown(now)} aria-valuemin=${shown(least)} aria-valuemax=${shown(most)}
    aria-valuetext="tilt ${slider.getAttribute("aria-valuetext")}, ${up}"
    onPointerDown=${(event) => tilting.hold(event, side, end)} onPointerMove=${(event) => tilting.drag(event)}
    onPointerUp=${() => tilting.release()} onPointerCancel=${() => tilting.release()}
    onKeyDown=${(event) => tilting.press(event, end)}></span>`;
}

/** Move the slider of the tilt as if by hand. @param {Field} field @param {number} position */
function move({ slider }, position) {
  const before = slider.value;
  slider.value = String(Math.round(position)); // within its range
  if (slider.value !== before) slider.dispatchEvent(new Event("input", { bubbles: true }));
}

/** The field of the tilt with its slider, null where the tilt is a result. @returns {Field | null} */
function fieldOf() {
  const slider = /** @type {HTMLInputElement | null} */ (document.querySelector(`#case [data-path="${PATH}"] .slider`));
  const field = slider && slid.get(slider);
  const control = slider && document.querySelector(`#case [name="${PATH}"]`);
  const hasNumber = field && (Number.isFinite(field.value) || /** @type {any} */ (control).value.trim() === "");
  return slider && field && hasNumber ? { slider, ...field } : null;
}

/** @param {number | null} value @param {[number, number]} limits */
function isWithin(value, [low, high]) {
  return value !== null && low <= value && value <= high;
}
