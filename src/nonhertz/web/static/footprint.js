// The footprint, seen from above.

import {
  FAINT,
  INK,
  MARGINS,
  alongAxis,
  draw,
  ends,
  extent,
  figure,
  head,
  innerWidthOf,
  uprightAxis,
} from "./chart.js";
import { digits } from "./numbers.js";
import { amount } from "./units.js";

/** @typedef {import("./types.js").Answer} Answer */

// Least and greatest height of the footprint in pixels; in between, true proportions.
const [LOWEST, HIGHEST] = [74, 300];

/** @param {Answer} answer @param {[number, number]} span along the contact */
export function drawFootprint(answer, span) {
  const { y, half_width: halfWidth } = answer.footprint;
  const host = figure("footprint");
  const reach = 1.15 * Math.max(...halfWidth.map((value) => value ?? 0), 0) || 1;
  const natural = (2 * reach * innerWidthOf(host)) / (span[1] - span[0]); // pixels across in true proportions
  const across = Math.min(HIGHEST, Math.max(LOWEST, natural));
  const shape = proportions(across / natural);
  head(host, "Footprint", [["gradient", "dark to bright: p₀"]], shape);
  draw(
    host,
    {
      ...MARGINS,
      height: across + MARGINS.marginTop + MARGINS.marginBottom,
      x: alongAxis(span, false),
      y: uprightAxis([-reach, reach], "x", "mm", { ticks: 3, grid: false }),
      marks: [
        () => gradient(answer),
        Plot.ruleY([0], { stroke: FAINT, strokeWidth: 0.6, strokeDasharray: "7 2 1.5 2" }),
        ends(answer),
        Plot.areaY(y, {
          x: y,
          y1: halfWidth,
          y2: halfWidth.map((value) => (value === null ? null : -value)),
          fill: "url(#along)",
          stroke: INK,
          strokeWidth: 0.7,
        }),
      ],
    },
    `Footprint seen from above, ${shape}: from y = ${amount(extent(y)[0], "mm")} to ${amount(extent(y)[1], "mm")}, at most ${amount(2 * Math.max(...halfWidth.map((value) => value ?? 0)), "mm", 3)} wide.`,
  );
}

/** How a figure's proportions differ from the true ones, in words. @param {number} stretch of the vertical axis */
export function proportions(stretch, [upright, level] = ["x", "y"]) {
  if (stretch > 1.02) return `${upright} stretched ${digits(stretch, 2)} times`;
  return stretch < 0.98 ? `${level} stretched ${digits(1 / stretch, 2)} times` : "true proportions";
}

/** A gradient along the contact with the colours of the pressure; its stops are where the strips are. */
function gradient(answer) {
  const { y, pressure } = answer.footprint;
  const [low, high] = extent(y);
  const top = answer.key.max_pressure || 1;
  const definitions = d3.create("svg:defs");
  const stops = definitions.append("linearGradient").attr("id", "along");
  for (const [place, value] of y.entries()) {
    if (value === null) continue;
    stops
      .append("stop")
      .attr("offset", (value - low) / (high - low || 1))
      .attr("stop-color", d3.interpolateCividis(Math.min(1, (pressure[place] ?? 0) / top)));
  }
  return definitions.node();
}
