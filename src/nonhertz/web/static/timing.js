// The time from an edit to the redrawn figures: shown on the page, and recorded for measurements.

import { byId } from "./elements.js";

let answers = 0;

/**
 * Note that the answer to an edit has been drawn.
 * @param {number} since when the edit began, by performance.now()
 * @param {number} begun when the drawing of the answer began
 * @param {import("./types.js").Answer | import("./types.js").Refusal} answer
 */
export function roundTrip(since, begun, answer) {
  answers += 1;
  performance.measure("nonhertz drawing", { start: begun });
  const root = document.documentElement;
  root.dataset.answers = String(answers);
  window.requestAnimationFrame(() => {
    const end = performance.now();
    performance.measure("nonhertz round trip", { start: since, end });
    root.dataset.roundTrip = (end - since).toFixed(1);
    if (!answer.ok) return;
    byId("state").textContent = answer.complaint ? answer.status : "solved";
    byId("round-trip").textContent =
      `in ${Math.round(end - since)} ms, ${Math.round(answer.ms)} ms of it in the solver`;
  });
}
