// One field of the form: its value in the unit that is chosen, and the slider beside it.

import { list, quantity, rounded, split } from "./numbers.js";

const STEPS = 1000; // positions of a slider
const SLOPE = "um/mm"; // a unit to which the angle is not proportional

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
    default: // a quantity, or an integer or word: numbers are in the unit beside them, all else is text
      return inUnit(quantity(text), control);
  }
}

/** A number with the unit beside its field, as the case file has it. */
function inUnit(value, control) {
  const unit = unitsOf(control)?.value;
  return typeof value === "number" && unit && unit !== control.dataset.unit ? `${value} ${unit}` : value;
}

/** The units to choose from beside a field, if there are any. @param {Control} control */
export function unitsOf(control) {
  const near = control.closest(".field")?.querySelector("select[data-unit-of]");
  return near instanceof HTMLSelectElement && near.dataset.unitOf === control.id ? near : null;
}

/**
 * A number that was written with its unit goes on as the number, with the unit chosen beside it.
 * @param {Control} control
 */
export function settle(control) {
  const [units, written] = [unitsOf(control), split(control.value)];
  if (!units || !written) return;
  if (![...units.options].some(({ value }) => value === written.unit)) return; // it stays as it is written
  control.value = written.number;
  units.value = written.unit;
  units.dataset.before = written.unit;
}

/**
 * Another unit has been chosen: the number goes with it.
 * @param {HTMLSelectElement} units
 * @param {Control} control
 */
export function convert(units, control) {
  const [before, after] = [units.dataset.before ?? "", units.value].map(
    (word) => [...units.options].find(({ value }) => value === word) ?? null,
  );
  units.dataset.before = units.value;
  const number = quantity(control.value);
  if (!before || !after || typeof number !== "number") return;
  const value = exact(control, units) ?? inBase(number, before);
  control.value = String(Number(outOf(value, after).toPrecision(12)));
}

/**
 * What the case says, in the base unit, where a field shows it rounded; null once it has been edited.
 * @param {Control} control
 * @param {HTMLSelectElement} units
 */
function exact(control, units) {
  const stands = control.dataset.standsFor;
  if (!stands || !(control instanceof HTMLInputElement) || control.value !== control.defaultValue) return null;
  const said = JSON.parse(stands);
  if (typeof said === "number") return said;
  const written = split(String(said));
  const unit = written && [...units.options].find(({ value }) => value === written.unit);
  return written && unit ? inBase(Number(written.number), unit) : null;
}

/** A number in the base unit; of a slope, the angle. @param {number} number @param {HTMLOptionElement} unit */
function inBase(number, unit) {
  return unit.value === SLOPE ? Math.atan(number * Number(unit.dataset.factor)) : number * Number(unit.dataset.factor);
}

function outOf(value, unit) {
  return unit.value === SLOPE ? Math.tan(value) / Number(unit.dataset.factor) : value / Number(unit.dataset.factor);
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
 * The text of a field for its slider's position: no more digits than the slider resolves, in the unit that is chosen.
 * @param {HTMLInputElement} slider
 * @param {Control} control
 */
export function slid(slider, control) {
  const [low, high] = ends(slider);
  const share = Number(slider.value) / STEPS;
  const factor = factorOf(control);
  if (isLogarithmic(slider)) {
    const value = low * (high / low) ** share;
    return rounded(value / factor, (value * Math.log(high / low)) / STEPS / factor);
  }
  return rounded((low + (high - low) * share) / factor, (high - low) / STEPS / factor);
}

/**
 * Move a slider to the value of its field, if that is a number.
 * @param {HTMLInputElement} slider
 * @param {Control} control
 */
export function follow(slider, control) {
  const unit = split(control.value) ? "" : unitOf(control);
  slider.setAttribute("aria-valuetext", control.value ? `${control.value} ${unit}`.trim() : "left out");
  const value = valueOf(slider, control);
  if (Number.isFinite(value)) place(slider, value);
}

/** Move a slider to a value; one beyond the range leaves it at an end. @param {HTMLInputElement} slider @param {number} value */
export function place(slider, value) {
  const [low, high] = ends(slider);
  const share = isLogarithmic(slider)
    ? Math.log(Math.max(value / low, 1)) / Math.log(high / low)
    : (value - low) / (high - low);
  slider.value = String(Math.round(STEPS * Math.min(1, Math.max(0, share))));
}

/**
 * The value of a field in the unit of its slider, NaN if it is no number in a unit of the field.
 * @param {HTMLInputElement} slider
 * @param {Control} control
 */
export function valueOf(slider, control) {
  const written = split(control.value);
  const text = written ? written.number : control.value.trim();
  const options = [...(unitsOf(control)?.options ?? [])];
  const size = written ? options.find(({ value }) => value === written.unit)?.dataset.factor : factorOf(control);
  return text === "" || !size ? NaN : Number(text) * Number(size);
}

/** The unit that a field is in. @param {Control} control */
export function unitOf(control) {
  return unitsOf(control)?.selectedOptions[0]?.textContent ?? control.dataset.unit ?? "";
}

/**
 * The size of that unit in units of the slider. Where a number in it says nothing, such as in a slope of a steep angle,
 * the field goes over to the unit of the slider.
 * @param {Control} control
 */
export function factorOf(control) {
  const units = unitsOf(control);
  if (!units) return 1;
  const factor = Number(units.selectedOptions[0]?.dataset.factor);
  if (factor) return factor;
  units.value = control.dataset.unit ?? "";
  return 1;
}

/** The ends of a slider, which the program gives in the unit of the quantity. @param {HTMLInputElement} slider */
export function ends(slider) {
  return [Number(slider.dataset.min), Number(slider.dataset.max)];
}

/** Whether a slider's steps are ratios. @param {HTMLInputElement} slider */
export function isLogarithmic(slider) {
  return slider.dataset.sliderScale === "log";
}
