// Notices at the top of the page: one per reason, for as long as it applies.

import { byId } from "./elements.js";

/** @type {Map<string, string>} */
const notices = new Map();

/** Set the notice for a reason; an empty sentence clears it. @param {string} reason @param {string} sentence */
export function notice(reason, sentence) {
  notices.set(reason, sentence);
  const text = [...notices.values()].filter(Boolean).join(" ");
  byId("notice").textContent = text;
  byId("notice").hidden = !text;
}
