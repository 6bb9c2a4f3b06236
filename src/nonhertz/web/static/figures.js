// The figures along the contact.

import { drawFootprint } from "./footprint.js";
import { drawPanels } from "./panel.js";

/** @typedef {import("./types.js").Answer} Answer */

/**
 * Draw all of them.
 * @param {Answer} answer
 * @param {Answer | null} pinned
 * @param {import("./tilt.js").Tilt} tilt the handles in the last
 */
export function drawFigures(answer, pinned, tilt) {
  const { pressure } = answer.figures;
  drawPanels(pressure, pinned?.figures.pressure);
  const span = /** @type {[number, number]} */ (pressure.along.range);
  drawFootprint(answer, span);
  const [axes] = drawPanels(answer.figures.distance, pinned?.figures.distance, tilt.limits, "gap");
  tilt.place(undeformed(answer), answer.key.tilt, axes);
}

/** The distance of the surfaces before loading. @param {Answer} answer */
function undeformed({ figures }) {
  return /** @type {any} */ (figures.distance.panels[0].marks.find(({ name }) => name === "undeformed"));
}
