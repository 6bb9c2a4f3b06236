// The von Mises stress below the surface, in the plane under the centre line and in a cross-section.

import { FINE, QUICK } from "./contours.js";
import { drawPanels } from "./panel.js";

/** @typedef {import("./types.js").Answer} Answer */

/**
 * Draw both planes.
 * @param {Answer} answer with stresses
 * @param {"MPa" | "p0"} unit
 * @param {boolean} fine whether there is time for the fine grid
 */
export function drawStress({ planes, key }, unit, fine) {
  if (!planes) return;
  const share = { factor: 1 / (key.max_pressure || 1), unit: "", title: "von Mises stress / largest p₀" };
  for (const plane of [planes.axial, planes.section]) {
    const [panel] = plane.panels;
    const colours = unit === "p0" ? { ...panel.colours, ...share } : panel.colours;
    drawPanels({ ...plane, panels: [{ ...panel, colours }] }, undefined, { last: panel.name, net: fine ? FINE : QUICK });
  }
}
