// One field of the form: its value, and the slider beside it.

import { list, quantity, rounded } from "./numbers.js";

const STEPS = 1000; // positions of a slider

/** @typedef {HTMLInputElement | HTMLSelectElement | HTMLTextAreaElement} Control */

/**
 * The value of a field as in the case file; undefined if the key is left out.
 * @param {Control} control
 */
export function said(control) {
  const text = control.value.trim();
  switch (control.dataset.kind) {
    case "boolean":
      return { true: true, false: false }[text];
    case "list":
      return text.startsWith("[") ? json(text) : list(text);
    case "json":
    case "hidden-json":
      return text === "" ? undefined : json(text);
    case "text":
    case "choice":
      return text === "" ? undefined : text;
    default: // a quantity, or an integer or word: numbers are numbers, all else is text
      return quantity(text);
  }
}

/** What is not (yet) JSON goes to the program as text, and the program says what is wrong. @param {string} text */
function json(text) {
  try {
    return JSON.parse(text);
  } catch {
    return text;
  }
}

/** The slider that belongs to a field, if it has one. @param {Control} control @returns {HTMLInputElement | null} */
export function sliderOf(control) {
  const field = control.closest(".field");
  const sliders = /** @type {HTMLInputElement[]} */ ([...(field?.querySelectorAll('input[type="range"]') ?? [])]);
  return sliders.find((slider) => slider.dataset.for === control.id) ?? null;
}

/**
 * The text of a field for its slider's position: no more digits than the slider resolves, in the unit that the field is
 * written in.
 * @param {HTMLInputElement} slider
 * @param {Control} control
 */
export function slid(slider, control) {
  const [low, high] = ends(slider);
  const share = Number(slider.value) / STEPS;
  const { factor, unit } = written(slider, control);
  if (isLogarithmic(slider)) {
    const value = low * (high / low) ** share;
    return rounded(value / factor, (value * Math.log(high / low)) / STEPS / factor) + unit;
  }
  return rounded((low + (high - low) * share) / factor, (high - low) / STEPS / factor) + unit;
}

/**
 * Move a slider to the value of its field; a value beyond the range leaves it at an end.
 * @param {HTMLInputElement} slider
 * @param {Control} control
 */
export function follow(slider, control) {
  const { factor, unit } = written(slider, control);
  const value = Number(control.value.slice(0, control.value.length - unit.length)) * factor;
  slider.setAttribute(
    "aria-valuetext",
    control.value ? `${control.value} ${unit ? "" : (control.dataset.unit ?? "")}`.trim() : "left out",
  );
  if (control.value.trim() === "" || !Number.isFinite(value)) return;
  const [low, high] = ends(slider);
  const share = isLogarithmic(slider)
    ? Math.log(Math.max(value / low, 1)) / Math.log(high / low)
    : (value - low) / (high - low);
  slider.value = String(Math.round(STEPS * Math.min(1, Math.max(0, share))));
}

/**
 * The value of a field in the unit of its slider, NaN if it is no number in the unit that the field is written in.
 * @param {HTMLInputElement} slider
 * @param {Control} control
 */
export function valueOf(slider, control) {
  const { factor, unit } = written(slider, control);
  const text = control.value.trim();
  const number = text.slice(0, text.length - unit.trim().length).trim();
  return number === "" ? NaN : Number(number) * factor;
}

/** The ends of a slider, which the program gives in the unit of the quantity. @param {HTMLInputElement} slider */
export function ends(slider) {
  return [Number(slider.dataset.min), Number(slider.dataset.max)];
}

/** Whether a slider's steps are ratios. @param {HTMLInputElement} slider */
export function isLogarithmic(slider) {
  return slider.dataset.sliderScale === "log";
}

/** The unit that the field is written in, with a leading blank, and its size in units of the slider. */
function written(slider, control) {
  const unit = slider.dataset.writtenUnit;
  const has = unit && control.value.trim().endsWith(unit);
  return has ? { factor: Number(slider.dataset.factor), unit: ` ${unit}` } : { factor: 1, unit: "" };
}
