// The sliders of a bearing, each with a field in the unit that people read.

import { element } from "./elements.js";
import { follow, slid } from "./fields.js";
import { quantity } from "./numbers.js";
import { withValue } from "./paths.js";

/**
 * @typedef {{
 *   path: string, label: string, help: string, unit: string, value: string, low: number, high: number,
 *   scale: "linear" | "log", without: string[], zero: boolean,
 * }} BearingSlider
 */

const HELD = 600; // ms after the last key, while a slider is moved by keys

export class Sliders {
  /**
   * @param {HTMLElement} host
   * @param {(change: (document: any) => any) => void} changed called with what changes a document
   */
  constructor(host, changed) {
    this.host = host;
    this.changed = changed;
    this.shape = "";
    /** @type {Map<string, {slider: BearingSlider, control: HTMLInputElement, range: HTMLInputElement}>} */
    this.fields = new Map();
    /** @type {Map<string, number>} when a field was edited last */
    this.edited = new Map();
    this.pressed = false;
    host.addEventListener("pointerdown", ({ target }) => (this.pressed = target.matches(".slider")));
    for (const end of ["pointerup", "pointercancel", "blur"])
      window.addEventListener(end, () => (this.pressed = false));
  }

  /** Whether a slider is being moved. */
  get held() {
    const last = Math.max(0, ...this.edited.values());
    return this.pressed || performance.now() - last < HELD;
  }

  /** The unit of the field of a key, empty if it has none. @param {string} path */
  unitOf(path) {
    const field = this.fields.get(path);
    return field ? shown(field.slider.unit) : "";
  }

  /**
   * Show the values of an answer, but where something newer has been entered.
   * @param {BearingSlider[]} sliders
   * @param {number} since when what was answered was edited
   */
  show(sliders, since) {
    const shape = JSON.stringify(sliders.map(({ value, without, ...rest }) => rest));
    if (shape !== this.shape) {
      this.shape = shape;
      this.build(sliders);
    }
    for (const slider of sliders) {
      const field = this.fields.get(slider.path);
      if (!field) continue;
      field.slider = slider;
      const writing = document.activeElement === field.control && (this.edited.get(slider.path) ?? 0) > 0;
      if (writing || (this.edited.get(slider.path) ?? 0) > since) continue;
      field.control.value = slider.value;
      if (!this.pressed) follow(field.range, field.control);
    }
  }

  build(sliders) {
    this.fields.clear();
    this.edited.clear();
    this.host.replaceChildren(...sliders.map((slider, place) => this.field(slider, `slider-${place}`)));
  }

  field(slider, id) {
    const control = element("input", {
      type: "text",
      id,
      name: slider.path,
      "data-kind": "quantity",
      "data-unit": shown(slider.unit),
      value: slider.value,
      autocomplete: "off",
      spellcheck: "false",
      "aria-describedby": `${id}-help ${id}-mistake`,
      input: () => this.write(slider.path),
      change: () => this.leave(slider.path),
      blur: () => this.leave(slider.path),
    });
    const range = element("input", {
      type: "range",
      class: "slider",
      "data-for": id,
      min: "0",
      max: "1000",
      step: "1",
      "data-min": String(slider.low),
      "data-max": String(slider.high),
      "data-slider-scale": slider.scale,
      "aria-label": `${slider.label}, slider`,
      input: () => {
        control.value = slid(range, control);
        follow(range, control);
        this.write(slider.path);
      },
    });
    this.fields.set(slider.path, { slider, control, range });
    follow(range, control);
    return element("div", { class: "field", "data-path": slider.path }, [
      element("label", { for: id }, [slider.label]),
      control,
      element("span", { class: "unit" }, [shown(slider.unit)]),
      range,
      element("p", { class: "help", id: `${id}-help` }, [slider.help]),
      element("p", { class: "mistake", id: `${id}-mistake`, role: "alert", hidden: true }),
    ]);
  }

  /**
   * What is in a field goes into the document: numbers with the field's unit, other text as it is.
   * @param {string} path
   */
  write(path) {
    const field = this.fields.get(path);
    if (!field) return;
    this.edited.set(path, performance.now());
    const { slider, control, range } = field;
    if (document.activeElement === control) follow(range, control);
    const given = quantity(control.value);
    const empty = slider.zero ? `0 ${slider.unit}` : undefined;
    const value = given === undefined ? empty : typeof given === "number" ? `${given} ${slider.unit}` : given;
    this.changed((document) => {
      const freed = slider.without.reduce((changed, other) => withValue(changed, other, undefined), document);
      return withValue(freed, slider.path, value);
    });
  }

  /** A field that is left is as the answer has it: a number in its unit. @param {string} path */
  leave(path) {
    this.edited.set(path, 0);
  }
}

/** @param {string} unit */
function shown(unit) {
  return unit.replace(/^u(?=m$|in$)/, "µ");
}
