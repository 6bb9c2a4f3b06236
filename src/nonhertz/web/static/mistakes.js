// Mistakes: each sentence below its field, and all of them in a list at the top.

import { byId, element } from "./elements.js";
import { outer } from "./paths.js";

/** @typedef {import("./types.js").Mistake} Mistake */

/**
 * Show these mistakes in place of the previous ones.
 * @param {Mistake[]} mistakes
 */
export function showMistakes(mistakes) {
  for (const field of document.querySelectorAll("#case .wrong")) clear(field);
  const unplaced = mistakes.map((mistake) => ({ mistake, field: fieldOf(mistake.path) }));
  for (const { mistake, field } of unplaced) if (field) mark(field, mistake.sentence);
  const list = byId("mistakes");
  list.hidden = mistakes.length === 0;
  byId("mistakes-title").textContent = mistakes.length === 1 ? "1 mistake" : `${mistakes.length} mistakes`;
  byId("mistakes-list").replaceChildren(
    ...unplaced.map(({ mistake, field }) => element("li", {}, entry(mistake, field))),
  );
}

function entry(mistake, field) {
  const control = field && controlOf(field);
  if (!control) return [mistake.sentence];
  const name = field.querySelector("legend, label")?.textContent?.trim() || mistake.path;
  const go = (event) => {
    event.preventDefault(); // the fragment of the address holds the case
    for (let fold = field.closest("details"); fold; fold = fold.parentElement?.closest("details") ?? null)
      fold.open = true;
    control.focus();
    field.scrollIntoView({ block: "nearest" });
  };
  return [element("a", { href: `#${control.id}`, click: go }, [name]), ": ", mistake.sentence];
}

/** The field of a mistake, or the innermost group that would contain it; null if there is neither. */
function fieldOf(path) {
  for (let place = path; place; place = outer(place)) {
    const name = CSS.escape(place);
    const found =
      document.querySelector(`#case .field[data-path="${name}"]`) ??
      document.querySelector(`#case fieldset[data-group="${name}"]`);
    if (found) return found;
  }
  return null;
}

/** The element for the sentence of a field, or of a group itself and not of a field in it. */
function wordsOf(field) {
  return field.querySelector(field.matches("fieldset") ? ":scope > .mistake" : ".mistake");
}

function controlOf(field) {
  return /** @type {HTMLElement | null} */ (
    field.querySelector("[name]") ?? field.querySelector("select, button")
  );
}

function mark(field, sentence) {
  const words = wordsOf(field);
  field.classList.add("wrong");
  if (field.matches(".field")) controlOf(field)?.setAttribute("aria-invalid", "true");
  if (words) {
    words.textContent = words.hidden ? sentence : `${words.textContent} ${sentence}`;
    words.hidden = false;
  }
}

function clear(field) {
  field.classList.remove("wrong");
  controlOf(field)?.removeAttribute("aria-invalid");
  const words = wordsOf(field);
  if (words) {
    words.textContent = "";
    words.hidden = true;
  }
}
