// Files dropped on the page of a contact: a case anywhere, points on a tabulated profile, a measured profile on a body.

import { isOwnFile } from "./files.js";
import { columns } from "./numbers.js";

const ANYWHERE = "a case file, .toml: drop a table of points or a measured profile on a body.";
const ON_A_TABLE = "text with two columns of numbers, y and relief: save it as .csv or .txt, or drop a case file, .toml.";

/** @typedef {import("./types.js").Mistake} Mistake */
/** @typedef {{group: HTMLElement, path: string, body: "a" | "b"}} Place a body of the form, or one of its profiles */
/**
 * @typedef {{
 *   isTable: (path: string) => boolean,
 *   open: (file: File) => void,
 *   table: (path: string, table: number[][]) => void,
 *   measured: (event: DragEvent, body: "a" | "b") => void,
 *   refuse: (mistake: Mistake) => void,
 * }} Taker
 */

/** Watch for files. @param {Taker} taker */
export function watchDrops(taker) {
  document.addEventListener("dragover", (event) => {
    event.preventDefault();
    if (event.dataTransfer?.types.includes("Files")) light(placeOf(event, taker)?.group ?? document.body);
  });
  document.addEventListener("dragleave", (event) => {
    if (!event.relatedTarget) light(null); // the pointer has left the window
  });
  document.addEventListener("drop", (event) => {
    light(null);
    if (!event.defaultPrevented) void dropped(event, taker);
  });
}

/** @param {DragEvent} event @param {Taker} taker */
async function dropped(event, taker) {
  event.preventDefault(); // a browser would leave the page for the file
  const file = event.dataTransfer?.files[0];
  const place = placeOf(event, taker);
  if (!file) return;
  if (isOwnFile(file)) taker.open(file);
  else if (!place) taker.refuse({ path: "", sentence: `${file.name} must be ${ANYWHERE}` });
  else if (!taker.isTable(place.path)) taker.measured(event, place.body);
  else {
    const table = columns(await file.text());
    if (table?.length === 2) taker.table(place.path, table);
    else taker.refuse({ path: place.path, sentence: `${file.name} must be ${ON_A_TABLE}` });
  }
}

/** Where a file would be taken as part of a body; null elsewhere. @param {DragEvent} event @param {Taker} taker */
function placeOf(event, taker) {
  const at = /** @type {HTMLElement} */ (event.target);
  const group = /** @type {HTMLElement | null} */ (at.closest?.("[data-group^='body.']") ?? null);
  const path = group?.dataset.group ?? "";
  const body = path[5];
  if (!group || (body !== "a" && body !== "b")) return null;
  if (taker.isTable(path)) return /** @type {Place} */ ({ group, path, body });
  const whole = /** @type {HTMLElement} */ (group.closest(`[data-group="body.${body}"]`) ?? group);
  return /** @type {Place} */ ({ group: whole, path: whole.dataset.group, body });
}

/** Show where a file would go. @param {HTMLElement | null} target */
function light(target) {
  for (const each of document.querySelectorAll(".drop-target")) if (each !== target) each.classList.remove("drop-target");
  target?.classList.add("drop-target");
}
