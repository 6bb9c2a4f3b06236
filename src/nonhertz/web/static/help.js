// The meaning of keys: the help text of the current field, in one place. Below every field it would make the form four
// times as long; shown there on demand, it would move what the pointer is about to press.

import { byId } from "./elements.js";

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
