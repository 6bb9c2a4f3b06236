// The figures along the contact.

import { drawPanels } from "./panel.js";

/** @typedef {import("./types.js").Answer} Answer */

/**
 * Draw all of them.
 * @param {Answer} answer
 * @param {Answer | null} pinned
 * @param {import("./tilt.js").Tilt} tilt the handles in the last
 */
export function drawFigures(answer, pinned, tilt) {
  drawPanels(answer.figures.pressure, pinned?.figures.pressure);
  drawPanels(answer.figures.footprint, undefined);
  const [axes] = drawPanels(answer.figures.distance, pinned?.figures.distance, { limits: tilt.limits, last: "gap" });
  tilt.place(undeformed(answer), answer.key.tilt, axes);
}

/** The distance of the surfaces before loading. @param {Answer} answer */
function undeformed({ figures }) {
  return /** @type {any} */ (figures.distance.panels[0].marks.find(({ name }) => name === "undeformed"));
}
