// The units of results: those of the program or US units, chosen once for both pages. Numbers arrive in the program's
// units and are converted here; sentences arrive in the chosen units.

import { byId } from "./elements.js";
import { digits } from "./numbers.js";

const KEPT = "nonhertz-units";
const [SI, US] = ["si", "us"];
const LEAST_KSI = 1; // below which a pressure is in psi
const LEAST_KN = 1e3; // N, from which on a force is in kN
/** @type {Record<string, string>} */
const SPELLED = { "µm": "micrometres", "µin": "microinches" };

/** @type {Record<string, [string, number]>} by unit of the program: the one in its place, and how many make one of that */
const table = JSON.parse(byId("us").textContent);
let chosen = storedUnits();

/** @returns {string} */
function storedUnits() {
  try {
    return localStorage.getItem(KEPT) === US ? US : SI;
  } catch {
    return SI; // storage is denied
  }
}

/** The code of the units that are chosen, as requests have it. */
export function unitsCode() {
  return chosen;
}

/**
 * Name the units on the page, and change them with the button.
 * @param {() => void} changed
 */
export function watchUnits(changed) {
  const button = byId("units");
  const show = () => {
    button.textContent = chosen === US ? "SI units" : "US units";
    button.title = `Read results in ${chosen === US ? "mm, N and MPa" : "in, lbf and ksi"}`;
    const names = /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll("[data-read]"));
    for (const element of names) element.textContent = named(element.dataset.read ?? "");
  };
  button.addEventListener("click", () => {
    chosen = chosen === US ? SI : US;
    try {
      localStorage.setItem(KEPT, chosen);
    } catch {
      // Storage is denied: the choice lasts only as long as the page.
    }
    show();
    changed();
  });
  show();
}

/**
 * The unit in which one of the program's is read, and how many of it make one of that.
 * @param {string} unit
 * @returns {[string, number]}
 */
export function read(unit) {
  return (chosen === US && table[unit]) || [unit, 1];
}

/** @param {string} unit */
export function named(unit) {
  return read(unit)[0];
}

/**
 * A number in a unit of the program, as it is read: apart from its unit.
 * @param {number | null | undefined} value
 * @param {string} unit
 * @param {number} [significant]
 */
export function parts(value, unit, significant = 4) {
  if (value === null || value === undefined) return { value: digits(value), unit: named(unit) };
  const [word, factor] = read(unit);
  const number = factor * value;
  if (word === "ksi" && Math.abs(number) < LEAST_KSI) return { value: digits(1e3 * number, significant), unit: "psi" };
  return { value: digits(number, significant), unit: word };
}

/** The same with its unit. @param {number | null | undefined} number @param {string} unit @param {number} [significant] */
export function amount(number, unit, significant = 4) {
  const { value, unit: word } = parts(number, unit, significant);
  return `${value} ${word}`.trimEnd();
}

/** The same for screen readers. @param {number} number @param {string} unit @param {number} [significant] */
export function spelled(number, unit, significant = 4) {
  const { value, unit: word } = parts(number, unit, significant);
  return `${value} ${inFull(word)}`;
}

/** A unit as screen readers can say it. @param {string} word */
export function inFull(word) {
  return SPELLED[word] ?? word;
}

/** A force, by its size. @param {number} newtons */
export function force(newtons) {
  return chosen === SI && Math.abs(newtons) >= LEAST_KN ? parts(newtons / LEAST_KN, "kN") : parts(newtons, "N");
}
