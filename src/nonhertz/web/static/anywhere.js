// What works anywhere on the page: keyboard shortcuts, closing menus, and the meaning of the current field.

import { byId } from "./elements.js";

const WRITTEN_IN = "textarea, input:not([type=range], [type=checkbox], [type=radio])";

/**
 * Undo and redo with Ctrl+Z, Ctrl+Shift+Z and Ctrl+Y, except in text fields, which have their own undo.
 * @param {(by: -1 | 1) => void} step
 */
export function watchKeys(step) {
  const menus = /** @type {NodeListOf<HTMLDetailsElement>} */ (document.querySelectorAll("details.menu"));
  document.addEventListener("keydown", (event) => {
    if (event.key === "Escape") for (const menu of menus) menu.open = false;
    const key = event.key.toLowerCase();
    const target = /** @type {HTMLElement} */ (event.target);
    if (!(event.ctrlKey || event.metaKey) || (key !== "z" && key !== "y") || target.matches(WRITTEN_IN)) return;
    event.preventDefault();
    step(key === "y" || event.shiftKey ? 1 : -1);
  });
  document.addEventListener("click", (event) => {
    for (const menu of menus) if (!menu.contains(/** @type {Node} */ (event.target))) menu.open = false;
  });
}

// The help text stands in one place. Below every field it would make the form four times as long; shown there on
// demand, it would move what the pointer is about to press.

/** Show the meaning of the field under the pointer, or else of the one with the focus. */
export function watchHelp() {
  const strip = byId("help");
  const form = byId("case");
  const tell = (target) => {
    const words =
      target instanceof Element ? target.closest(".field")?.querySelector(".help")?.textContent?.trim() : "";
    if (words) strip.textContent = words;
  };
  form.addEventListener("focusin", (event) => tell(event.target));
  form.addEventListener("pointerover", (event) => tell(event.target));
  form.addEventListener("pointerleave", () => tell(document.activeElement));
}
