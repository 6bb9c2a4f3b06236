// Sentences above everything: one for each reason, for as long as it lasts.

import { byId } from "./elements.js";

/** @type {Map<string, string>} */
const notices = new Map();

/** Say something for a reason; an empty sentence takes back what was said for it. @param {string} reason @param {string} sentence */
export function notice(reason, sentence) {
  notices.set(reason, sentence);
  const text = [...notices.values()].filter(Boolean).join(" ");
  byId("notice").textContent = text;
  byId("notice").hidden = !text;
}
