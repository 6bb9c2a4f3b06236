// Files dropped on a page: one of its own anywhere, points on a tabulated profile, a measured profile on a body.

import { isOwnFile } from "./files.js";
import { columns } from "./numbers.js";

const ANYWHERE = "file, .toml: drop a table of points or a measured profile on a body.";
const ON_A_TABLE = "text with two columns of numbers, y and relief: save it as .csv or .txt, or drop a";

/** @typedef {import("./types.js").Mistake} Mistake */
/** @typedef {{group: HTMLElement, path: string, body: string}} Place a body of the form, or one of its profiles */
/**
 * @typedef {{
 *   what: string,
 *   bodies: Record<string, string>,
 *   isTable: (path: string) => boolean,
 *   open: (file: File) => void,
 *   table: (path: string, table: number[][]) => void,
 *   measured: (event: DragEvent, body: string) => void,
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
  else if (!place) taker.refuse({ path: "", sentence: `${file.name} must be a ${taker.what} ${ANYWHERE}` });
  else if (!taker.isTable(place.path)) taker.measured(event, place.body);
  else {
    const table = columns(await file.text());
    if (table?.length === 2) taker.table(place.path, table);
    else taker.refuse({ path: place.path, sentence: `${file.name} must be ${ON_A_TABLE} ${taker.what} file, .toml.` });
  }
}

/** Where a file would be taken as part of a body; null elsewhere. @param {DragEvent} event @param {Taker} taker */
function placeOf(event, taker) {
  const at = /** @type {HTMLElement} */ (event.target);
  const path = /** @type {HTMLElement | null} */ (at.closest?.("[data-group]") ?? null)?.dataset.group ?? "";
  const [body, within] = Object.entries(taker.bodies).find(([, prefix]) => `${path}.`.startsWith(`${prefix}.`)) ?? [];
  if (!body) return null;
  const whole = taker.isTable(path) ? path : within;
  const group = /** @type {HTMLElement} */ (at.closest(`[data-group="${whole}"]`));
  return { group, path: /** @type {string} */ (whole), body };
}

/** Show where a file would go. @param {HTMLElement | null} target */
function light(target) {
  for (const element of document.querySelectorAll(".drop-target")) if (element !== target) element.classList.remove("drop-target");
  target?.classList.add("drop-target");
}
