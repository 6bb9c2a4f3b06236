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
import { amount, scaled, spelled } from "./units.js";

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
    beyond ? `axis cut: undeformed up to ${amount(extent(before)[1], "µm", 3)}` : "",
  );
  const chart = draw(
    host,
    {
      ...MARGINS,
      marginBottom: NAMED,
      height: HEIGHT,
      x: alongAxis(span),
      y: uprightAxis(limits, "distance", "µm"),
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
          (place) => `y ${amount(y[place], "mm")}\nundeformed ${amount(before[place], "µm")}\ndeformed ${amount(after[place], "µm")}`,
        ),
      ],
    },
    `Distance of the surfaces along y: undeformed they would overlap by up to ${spelled(Math.max(0, -extent(before)[0]), "µm", 3)}; deformed it is zero in contact.`,
  );
  const place = (name, unit) => {
    const { transform = (value) => value } = scaled(unit);
    const scale = chart.scale(name);
    return (value) => scale.apply(transform(value));
  };
  return { x: place("x", "mm"), y: place("y", "µm"), height: HEIGHT, limits };
}
