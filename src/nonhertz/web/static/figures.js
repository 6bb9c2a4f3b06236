// The figures along the contact. Pressure and half-width are drawn here.

import {
  FIRST,
  INK,
  MARGINS,
  SECOND,
  alongAxis,
  draw,
  ends,
  figure,
  fromZero,
  head,
  line,
  ofPressure,
  pinnedKey,
  pinnedLine,
  reading,
  uprightAxis,
} from "./chart.js";
import { drawFootprint } from "./footprint.js";
import { drawGap } from "./gap.js";
import { digits } from "./numbers.js";
import { amount, strength } from "./units.js";

/** @typedef {import("./types.js").Answer} Answer */

/**
 * Draw all of them.
 * @param {Answer} answer
 * @param {Answer | null} pinned
 * @param {import("./tilt.js").Tilt} tilt the handles in the last
 */
export function drawFigures(answer, pinned, tilt) {
  const { span } = answer;
  drawPressure(answer, pinned, span);
  drawHalfWidth(answer, pinned, span);
  drawFootprint(answer, span);
  tilt.place(answer, drawGap(answer, pinned, span, tilt.limits));
}

function drawPressure(answer, pinned, span) {
  const { y, pressure } = answer.line;
  const before = pinned?.line;
  const host = figure("pressure");
  const cut = answer.singular.length > 0;
  const { top, clamped, remark } = ofPressure(answer.key.max_pressure, cut, [pressure, before?.pressure ?? []]);
  head(host, "Pressure on the centre line", [["first", "p₀"], ...pinnedKey(pinned)], remark);
  draw(
    host,
    {
      ...MARGINS,
      height: 236,
      x: alongAxis(span, false),
      y: uprightAxis(top, "p₀", "MPa", { clamp: false }),
      marks: [
        Plot.ruleY([0], { stroke: INK, strokeWidth: 0.8 }),
        ends(answer),
        Plot.areaY(y, { x: y, y: clamped(pressure), fill: FIRST, fillOpacity: 0.12, clip: true }),
        ...pinnedLine(before?.y, before && clamped(before.pressure)),
        line(y, clamped(pressure), { stroke: FIRST, clip: true }),
        ...largestMark(answer, top[1]),
        ...singularMarks(answer, top[1], span),
        ...landEndMarks(answer),
        ...reading(y, clamped(pressure), (place) => `y  ${amount(y[place], "mm")}\np₀ ${amount(pressure[place], "MPa")}`),
      ],
    },
    pressureWords(answer),
  );
}

function largestMark(answer, top) {
  const place = [[answer.key.max_pressure_y, answer.key.max_pressure]];
  return [
    Plot.dot(place, { r: 3, fill: FIRST }),
    Plot.text(place, {
      text: [amount(place[0][1], "MPa")],
      dy: -10,
      fontWeight: 600,
      fill: INK,
      stroke: "var(--surface)",
      strokeWidth: 4,
    }),
  ];
}

/** Where the pressure rises again where the land of a body ends; the largest has its number already. */
function landEndMarks({ land_ends, key, span }) {
  const middle = (span[0] + span[1]) / 2;
  return land_ends.map(({ y, pressure }) =>
    Plot.text([[y, pressure]], {
      text: [pressure < 0.999 * key.max_pressure ? `land end, ${amount(pressure, "MPa")}` : "land end"],
      dy: pressure < 0.999 * key.max_pressure ? -8 : 10,
      dx: y < middle ? 8 : -8,
      textAnchor: y < middle ? "start" : "end",
      fill: INK,
      stroke: "var(--surface)",
      strokeWidth: 4,
    }),
  );
}

function singularMarks(answer, top, span) {
  const middle = (span[0] + span[1]) / 2;
  return answer.singular.map((end) =>
    Plot.text([end], {
      x: "y",
      y: () => top,
      dy: 12,
      dx: end.y < middle ? 12 : -12,
      textAnchor: end.y < middle ? "start" : "end",
      text: () =>
        [
          end.corner ? "no limit at a corner" : `no limit, as 1/s^${digits(end.exponent, 2)}`,
          ...(end.strength === null ? [] : [`K = ${strength(end.strength, end.exponent)}`]),
        ].join("\n"),
      fill: INK,
      stroke: "var(--surface)",
      strokeWidth: 4,
      lineAnchor: "top",
    }),
  );
}

function drawHalfWidth(answer, pinned, span) {
  const { y, half_width: halfWidth } = answer.line;
  const before = pinned?.line;
  const host = figure("half-width");
  head(host, "Half-width", [["second", "b"], ...pinnedKey(pinned)]);
  draw(
    host,
    {
      ...MARGINS,
      height: 112,
      x: alongAxis(span, false),
      y: uprightAxis(fromZero([halfWidth, before?.half_width ?? []]), "b", "mm", { ticks: 3 }),
      marks: [
        Plot.ruleY([0], { stroke: INK, strokeWidth: 0.8 }),
        ends(answer),
        ...pinnedLine(before?.y, before?.half_width),
        line(y, halfWidth, { stroke: SECOND }),
        ...reading(y, halfWidth, (place) => `y ${amount(y[place], "mm")}\nb ${amount(halfWidth[place], "mm")}`),
      ],
    },
    `Half-width along y: at most ${amount(Math.max(...halfWidth.map((value) => value ?? 0)), "mm", 3)}.`,
  );
}

function pressureWords(answer) {
  const { key } = answer;
  return `Pressure on the centre line along y: largest ${amount(key.max_pressure, "MPa")} ${key.largest}.`;
}
