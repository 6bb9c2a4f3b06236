// The distance of the surfaces on the centre line, undeformed and deformed.

import {
  FIRST,
  INK,
  MARGINS,
  NAMED,
  SECOND,
  alongAxis,
  draw,
  ends,
  extent,
  figure,
  head,
  line,
  pinnedKey,
  pinnedLine,
  reading,
  uprightAxis,
} from "./chart.js";
import { digits } from "./numbers.js";

/** @typedef {import("./types.js").Answer} Answer */

const HEIGHT = 240;

/**
 * Draw them, and return where places are in the drawing.
 * @param {Answer} answer
 * @param {Answer | null} pinned
 * @param {[number, number]} span along the contact
 * @param {[number, number] | null} held the vertical axis, if it is to stay as it was
 * @returns {import("./tilt.js").Axes}
 */
export function drawGap(answer, pinned, span, held) {
  const { y, before, after } = answer.gap;
  const host = figure("gap");
  const limits = held ?? answer.gap.range ?? [0, 1];
  const inside = (values) =>
    values.map((value) => (value === null ? null : Math.max(-9e9, Math.min(value, 3 * limits[1] + 1))));
  const beyond = extent(before)[1] > limits[1];
  head(
    host,
    "Distance of the surfaces",
    [["second dashed", "undeformed"], ["first", "deformed"], ...pinnedKey(pinned)],
    beyond ? `axis cut: undeformed up to ${digits(extent(before)[1], 3)} µm` : "",
  );
  const chart = draw(
    host,
    {
      ...MARGINS,
      marginBottom: NAMED,
      height: HEIGHT,
      x: alongAxis(span),
      y: uprightAxis(limits, "distance [µm]"),
      marks: [
        Plot.ruleY([0], { stroke: INK, strokeWidth: 0.8 }),
        ends(answer),
        Plot.areaY(y, { x: y, y1: inside(before), y2: inside(after), fill: FIRST, fillOpacity: 0.12, clip: true }),
        ...pinnedLine(pinned?.gap.y, pinned && inside(pinned.gap.before)),
        ...pinnedLine(pinned?.gap.y, pinned && inside(pinned.gap.after)),
        line(y, inside(before), { stroke: SECOND, strokeDasharray: "6 3", clip: true }),
        line(y, inside(after), { stroke: FIRST, clip: true }),
        ...reading(
          y,
          inside(before),
          (place) => `y ${digits(y[place])} mm\nundeformed ${digits(before[place])} µm\ndeformed ${digits(after[place])} µm`,
        ),
      ],
    },
    `Distance of the surfaces along y: undeformed they would overlap by up to ${digits(Math.max(0, -extent(before)[0]), 3)} micrometres; deformed it is zero in contact.`,
  );
  return { x: chart.scale("x").apply, y: chart.scale("y").apply, height: HEIGHT, limits };
}
