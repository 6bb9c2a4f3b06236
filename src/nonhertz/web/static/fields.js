// The text of a field, from a value of the document and back into the document; and the slider beside it.

import { byId } from "./elements.js";
import { list, quantity, rounded, split } from "./numbers.js";
import { read, unitsCode } from "./units.js";

/** @typedef {HTMLInputElement | HTMLSelectElement | HTMLTextAreaElement} Control */
/** @typedef {{low: number, high: number, scale: string, start: number}} Range */

const STEPS = 1000; // positions of a slider
const SLOPE = "um/mm"; // a unit to which the angle is not proportional
const [FIGURES, FEWER] = [12, 6]; // the latter in units whose factor is no power of ten
const PLAIN = /^[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?$/;
const NUMERIC = ["quantity", "integer-or-word"];

/** @typedef {Record<string, Record<string, number>>} Choices by base unit, words and their sizes */
/** @type {{choices: Choices, shown_in: Record<string, [number, string][]>, micrometres: string[]}} */
const units = JSON.parse(byId("start").textContent).form.units;

/** The units to choose from in place of a base unit, with their sizes. @param {string} base */
export function choicesOf(base) {
  return units.choices[base] ?? {};
}

/** A unit as people read it. @param {string} word */
export function legible(word) {
  return word
    .replace("um", "µm")
    .replace("uin", "µin")
    .replace("deg", "°")
    .replace("arcmin", "′")
    .replace("^2", "²")
    .replace("^3", "³");
}

/** A number in the base unit; of a slope, the angle. */
function inBase(number, word, size) {
  return word === SLOPE ? Math.atan(number * size) : number * size;
}

function outOf(value, word, size) {
  return word === SLOPE ? Math.tan(value) / size : value / size;
}

/** Number and unit of a text, null if it has none; some units begin with a number. */
function writtenAs(value, base) {
  if (typeof value !== "string") return null;
  const unit = Object.keys(choicesOf(base)).find((word) => value.endsWith(` ${word}`));
  const number = unit && value.slice(0, -unit.length).trim();
  return number && PLAIN.test(number) ? { number, unit } : split(value);
}

/** The value of a quantity in its base unit; NaN if it is none in a unit that is known here. */
export function valueIn(value, base) {
  if (typeof value === "number") return value;
  const written = writtenAs(value, base);
  const size = written && choicesOf(base)[written.unit];
  return size ? inBase(Number(written.number), written.unit, size) : NaN;
}

/** The unit in which people read a quantity of a name and size. */
function usualUnit(base, name, size) {
  if (base === "mm") return units.micrometres.includes(name) && size < 1 ? "um" : "mm";
  return units.shown_in[base]?.findLast(([least]) => size >= least)?.[1] ?? base;
}

/** That unit as it is chosen to be read. @param {string} word */
function readIn(word) {
  return read(word)[0].replace("µ", "u");
}

/**
 * The text of a quantity, and the unit beside it: the one in which it is written, or in which people read it.
 * @param {any} value of the document
 * @param {string} base
 * @param {string} name of the key
 * @param {string} [chosen] the unit that was chosen
 * @returns {{text: string, word: string}}
 */
export function shownIn(value, base, name, chosen) {
  const known = choicesOf(base);
  const written = writtenAs(value, base);
  const number = valueIn(value, base);
  if (!Number.isFinite(number)) return { text: inWords(value) ?? "", word: chosen ?? readIn(usualUnit(base, name, 0)) };
  const isOwn =
    written &&
    (written.unit === chosen || (!chosen && (unitsCode() === "si" || read(written.unit)[0] === written.unit)));
  if (isOwn) return { text: written.number, word: written.unit };
  const usual = chosen ?? usualUnit(base, name, Math.abs(number));
  const word = chosen ?? (known[readIn(usual)] ? readIn(usual) : usual);
  const size = known[word] ?? 1;
  // Without the digits that a factor such as that of degrees adds.
  const figures = Math.abs(Math.log10(size) % 1) < 1e-9 ? FIGURES : FEWER;
  return { text: String(Number(outOf(number, word, size).toPrecision(figures))), word };
}

/** The number in a unit as the document has it. @param {number} value in the base unit */
export function writtenIn(value, word, base) {
  const number = Number(outOf(value, word, choicesOf(base)[word] ?? 1).toPrecision(FIGURES));
  return word === base ? number : `${number} ${word}`;
}

/**
 * What goes into the document of the text of a field; undefined if the key is left out.
 * @param {string} kind
 * @param {string} text
 * @param {string} [word] the unit beside it
 * @param {string} [base]
 */
export function toValue(kind, text, word, base) {
  const trimmed = text.trim();
  if (trimmed === "") return undefined;
  if (kind === "boolean") return trimmed === "true";
  if (kind === "list") return trimmed.startsWith("[") ? json(trimmed) : list(trimmed);
  if (kind === "json") return json(trimmed);
  if (!NUMERIC.includes(kind)) return trimmed;
  // Numbers are in the unit beside them, all else is text.
  const value = quantity(trimmed);
  return typeof value === "number" && word && word !== base ? `${value} ${word}` : value;
}

/** The text of a value; null if a field of this kind cannot hold it. @param {string} kind @param {any} value */
export function textOf(kind, value) {
  if (value === undefined) return "";
  if (NUMERIC.includes(kind)) return inWords(value);
  if (kind === "json") return JSON.stringify(value);
  if (kind === "boolean") return typeof value === "boolean" ? String(value) : null;
  if (kind === "list") return listed(value);
  return typeof value === "string" && isPlain(value) ? value : null;
}

/** The text of a number, or a text that cannot be mistaken for one; null for anything else. */
function inWords(value) {
  if (typeof value === "number") return String(value);
  return typeof value === "string" && isPlain(value) && !PLAIN.test(value) ? value : null;
}

function isPlain(text) {
  return text !== "" && text === text.trim() && !text.includes("\n");
}

/** Entries separated by blanks, or as JSON if they contain blanks themselves. */
function listed(value) {
  if (!Array.isArray(value)) return null;
  const texts = value.map(inWords);
  const plain = value.length && texts.every((text) => text !== null && !text.includes(" ") && !text.startsWith("["));
  return plain ? texts.join(" ") : JSON.stringify(value);
}

/** What is not (yet) JSON goes to the program as text, and the program says what is wrong. @param {string} text */
function json(text) {
  try {
    return JSON.parse(text);
  } catch {
    return text;
  }
}

/**
 * The range of a slider for a value, with ends that are round in the unit in which it is read, and of its sign.
 * @param {Range} range @param {string} base @param {number} value
 */
export function rangeFor({ low, high, scale, start }, base, value) {
  const factor = read(base)[1];
  const round = (end) => {
    const power = end ? 10 ** (Math.floor(Math.log10(Math.abs(end))) - 1) : 1;
    return (Math.trunc(Number((end / power).toPrecision(10))) * power) / factor;
  };
  const sign = scale === "log" && value < 0 && low > 0 ? -1 : 1;
  const [least, most] = factor === 1 ? [low, high] : [round(factor * low), round(factor * high)];
  return { low: sign * least, high: sign * most, scale, start: sign * start };
}

/** The position of a slider for a value, at an end for one beyond. @param {Range} range @param {number} value */
export function placeOf({ low, high, scale }, value) {
  const share =
    scale === "log" ? Math.log(Math.max(value / low, 1)) / Math.log(high / low) : (value - low) / (high - low);
  return Math.round(STEPS * Math.min(1, Math.max(0, share)));
}

/** The text of a position, in a unit of a size. @param {Range} range @param {number} place @param {number} size */
export function textAt({ low, high, scale }, place, size) {
  const share = place / STEPS;
  const value = scale === "log" ? low * (high / low) ** share : low + (high - low) * share;
  const step = (scale === "log" ? value * Math.log(high / low) : high - low) / STEPS;
  return rounded(value / size, step / size);
}

/**
 * What a slider moves: the field, its value in the base unit, NaN without one; the unit beside it and its size.
 * @typedef {{path: string, label: () => string, value: number, span: Range, unit: string, factor: number}} Slid
 */

/** @type {WeakMap<Element, Slid>} by the sliders that are drawn, for whoever draws over them */
export const slid = new WeakMap();

/** What a field is called, with what it belongs to. @param {Control} control */
export function nameOf(control) {
  const name = control.labels?.[0]?.textContent?.trim() ?? control.name;
  const groups = [];
  for (let group = control.closest("fieldset"); group; group = group.parentElement?.closest("fieldset") ?? null)
    groups.unshift(group.querySelector("legend")?.textContent?.trim() ?? "");
  // The outermost group says "body" or "load", and a profile's says "profile" again.
  const outer = groups.slice(1).filter((group, place, all) => group !== name && !all[place + 1]?.startsWith(group));
  return [...outer, name].join(", ");
}

/** The unit that a field is in. @param {Control} control */
export function unitOf(control) {
  const chooser = /** @type {HTMLSelectElement | null} */ (control.closest(".field")?.querySelector("select.unit") ?? null);
  return chooser?.selectedOptions[0]?.textContent ?? control.dataset.unit ?? "";
}
