// Keyboard shortcuts that work anywhere on the page, and closing the menu on Escape or a click elsewhere.

import { byId } from "./elements.js";

const WRITTEN_IN = "textarea, input:not([type=range], [type=checkbox], [type=radio])";

/**
 * Undo and redo with Ctrl+Z, Ctrl+Shift+Z and Ctrl+Y, except in text fields, which have their own undo.
 * @param {(by: -1 | 1) => void} step
 */
export function watchKeys(step) {
  const menu = byId("downloads");
  document.addEventListener("keydown", (event) => {
    if (event.key === "Escape") menu.open = false;
    const key = event.key.toLowerCase();
    const target = /** @type {HTMLElement} */ (event.target);
    if (!(event.ctrlKey || event.metaKey) || (key !== "z" && key !== "y") || target.matches(WRITTEN_IN)) return;
    event.preventDefault();
    step(key === "y" || event.shiftKey ? 1 : -1);
  });
  document.addEventListener("click", (event) => {
    if (!menu.contains(/** @type {Node} */ (event.target))) menu.open = false;
  });
}
