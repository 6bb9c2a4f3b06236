// Mistakes: each sentence below its field, and all of them in a list at the top.

import { byId } from "./elements.js";
import { nameOf } from "./fields.js";
import { outer } from "./paths.js";
import { html, render } from "./preact.js";

/** @typedef {import("./types.js").Mistake} Mistake */

/** The sentences by the path of the field below which they stand, or of the group and a slash; anew at each change. */
export let marked = /** @type {Map<string, string>} */ (new Map());
let redraw = () => {};

/** Set what draws the fields anew. @param {() => void} draw */
export function whenMarked(draw) {
  redraw = draw;
}

/**
 * Show these mistakes in place of the previous ones.
 * @param {Mistake[]} mistakes
 */
export function showMistakes(mistakes) {
  if (!mistakes.length && !marked.size && byId("mistakes").hidden) return;
  const placed = mistakes.map((mistake) => ({ ...mistake, host: hostOf(mistake.path) }));
  marked = new Map();
  for (const { sentence, host } of placed) {
    const place = host?.dataset.path ?? `${host?.dataset.group}/`;
    marked.set(place, [marked.get(place), sentence].filter(Boolean).join(" "));
  }
  redraw();
  byId("mistakes").hidden = !mistakes.length;
  const title = mistakes.length === 1 ? "1 mistake" : `${mistakes.length} mistakes`;
  render(
    html`<h2 id="mistakes-title">${title}</h2>
      <ul id="mistakes-list">${placed.map((mistake) => html`<li><${Entry} ...${mistake} /></li>`)}</ul>`,
    byId("mistakes"),
  );
}

/** A sentence, with a link to its field. @param {Mistake & {host: HTMLElement | null}} mistake */
function Entry({ path, sentence, host }) {
  const control = /** @type {HTMLElement | null} */ (
    host?.querySelector("[name]") ?? host?.querySelector("select, button") ?? null
  );
  if (!host || !control) return sentence;
  const go = (event) => {
    event.preventDefault(); // the fragment of the address holds the case
    for (let fold = host.closest("details"); fold; fold = fold.parentElement?.closest("details") ?? null) fold.open = true;
    control.focus();
    host.scrollIntoView({ block: "nearest" });
  };
  // Words in place of the path with which a sentence begins.
  const begins = host.dataset.path === path && sentence.startsWith(path);
  const name = begins ? nameOf(/** @type {any} */ (control)) : host.querySelector("legend, label")?.textContent?.trim();
  return html`<a href="#${control.id}" onClick=${go}>${name || path}</a>${begins ? sentence.slice(path.length) : `: ${sentence}`}`;
}

/** The field of a mistake, or the innermost group that would contain it; null if there is neither. */
function hostOf(path) {
  for (let place = path; place; place = outer(place)) {
    const name = CSS.escape(place);
    const host =
      document.querySelector(`#case .field[data-path="${name}"]`) ??
      document.querySelector(`#case fieldset[data-group="${name}"]`);
    if (host) return /** @type {HTMLElement} */ (host);
  }
  return null;
}
