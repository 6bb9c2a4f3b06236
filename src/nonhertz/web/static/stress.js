// The von Mises stress below the surface, in the plane under the centre line and in a cross-section.

import { INK, MARGINS, NAMED, PLAIN, axis, draw, figure, head, innerWidthOf } from "./chart.js";
import { proportions } from "./footprint.js";
import { amount, named, read } from "./units.js";

const BANDS = 10;
// Cells of the grids for contours, along and down. Fine ones take too long to paint during a drag.
const FINE = { columns: 96, rows: 40 };
const QUICK = { columns: 60, rows: 26 };
const HEIGHT = 270; // pixels of the planes
/** Of the largest stress, the same in both planes. */
const MARK = [
  { stroke: "white", strokeWidth: 3 },
  { stroke: "black", strokeWidth: 1.4 },
];

/** @typedef {import("./types.js").Answer} Answer */

/**
 * Draw both planes.
 * @param {Answer} answer with stresses
 * @param {"MPa" | "p0"} unit
 * @param {boolean} fine whether there is time for the fine grid
 */
export function drawStress(answer, unit, fine) {
  if (!answer.axial || !answer.section || !answer.stress) return;
  const scale = unit === "p0" ? 1 / (answer.key.max_pressure || 1) : read("MPa")[1];
  const label = unit === "p0" ? "von Mises stress / largest p₀" : `von Mises stress [${named("MPa")}]`;
  // One scale for both, up to the largest stress away from singular ends.
  const top = scale * Math.max(largestAlong(answer), answer.stress.von_mises.max) || 1;
  const shared = { label, scale, top, net: fine ? FINE : QUICK };
  drawAlong(answer, shared);
  drawAcross(answer, shared);
}

function drawAlong(answer, { label, scale, top, net }) {
  const host = figure("axial");
  const { y, z, von_mises: values } = answer.axial;
  const found = answer.stress.von_mises;
  const stretch = (HEIGHT * (last(y) - y[0])) / (innerWidthOf(host) * (last(z) - z[0]));
  head(host, `Along the contact, body ${answer.body}, x = 0`, [], proportions(stretch, ["z", "y"]));
  drawPlane(
    host,
    resampled(y, z, values, scale, net),
    { top, label, height: HEIGHT, along: "y", place: [found.y, found.z] },
    `Von Mises stress along the contact in body ${answer.body}: largest ${amount(found.max, "MPa")} at y = ${amount(found.y, "mm")}, ${amount(found.z, "mm")} deep.`,
  );
}

function drawAcross(answer, { label, scale, top, net }) {
  const host = figure("section");
  const { x, y, z, von_mises: values } = answer.section;
  const found = answer.stress.von_mises;
  const natural = (innerWidthOf(host) * (last(z) - z[0])) / (last(x) - x[0]);
  const height = Math.min(natural, HEIGHT);
  head(host, `Across, body ${answer.body}, y = ${amount(y, "mm", 3)}`, [], proportions(height / natural, ["z", "x"]));
  drawPlane(
    host,
    resampled(x, z, values, scale, net),
    { top, label, height, along: "x", place: [found.x, found.z] },
    `Von Mises stress across the contact in body ${answer.body} at y = ${amount(y, "mm")}: largest ${amount(found.max, "MPa")}, ${amount(found.z, "mm")} deep.`,
  );
}

/** The largest stress on the grid along the contact, more than a half-width away from ends where it has no limit. */
function largestAlong({ axial, singular, key }) {
  const counted = axial.y.map((y) => singular.every((end) => Math.abs(y - end.y) > key.max_half_width));
  return Math.max(...axial.von_mises.flatMap((line) => line.filter((_, column) => counted[column])));
}

function last(values) {
  return values[values.length - 1];
}

function drawPlane(host, plane, { top, label, height, along, place }, words) {
  draw(
    host,
    {
      ...MARGINS,
      marginBottom: NAMED,
      height: height + MARGINS.marginTop + NAMED,
      x: axis(along, "mm", [plane.x1, plane.x2]),
      y: { ...axis("depth z", "mm", [plane.y2, plane.y1]), ticks: 4 },
      color: {
        type: "linear",
        domain: [0, top],
        clamp: true,
        interpolate: d3.interpolateCividis,
        label,
        legend: true,
        width: 220,
        height: 52,
        ticks: 4,
        marginLeft: 8,
        tickFormat: PLAIN,
      },
      marks: [
        Plot.contour(plane.values, {
          width: plane.columns,
          height: plane.rows,
          x1: plane.x1,
          x2: plane.x2,
          y1: plane.y1,
          y2: plane.y2,
          fill: (value) => value,
          stroke: "#ffffff66",
          strokeWidth: 0.5,
          thresholds: d3.range(0, top, top / BANDS),
        }),
        ...(place[1] <= plane.y2 ? MARK.map((style) => Plot.dot([place], { symbol: "plus", r: 5, ...style })) : []),
        Plot.ruleY([plane.y1], { stroke: INK }),
      ],
    },
    words,
  );
}

/**
 * Values on a uniform grid, as contours need them, from a grid with uneven spacing; rows go down.
 * @param {number[]} along
 * @param {number[]} depths
 * @param {(number | null)[][]} values one row for each depth
 * @param {number} scale
 * @param {{columns: number, rows: number}} net
 */
export function resampled(along, depths, values, scale, net) {
  const columns = shares(along, net.columns);
  const rows = shares(depths, net.rows);
  const even = new Float64Array(net.columns * net.rows);
  for (const [row, [upper, down]] of rows.entries()) {
    for (const [column, [left, right]] of columns.entries()) {
      const at = (j, i) => values[j][i] ?? NaN; // no material: left blank
      const above = at(upper, left) * (1 - right) + at(upper, left + 1) * right;
      const below = at(upper + 1, left) * (1 - right) + at(upper + 1, left + 1) * right;
      even[row * net.columns + column] = scale * (above * (1 - down) + below * down);
    }
  }
  return { ...net, values: even, x1: along[0], x2: last(along), y1: depths[0], y2: last(depths) };
}

/** For the centre of each uniform cell: the interval of the places that contains it, and the fraction into it. */
function shares(places, count) {
  const length = last(places) - places[0];
  return d3.range(count).map((cell) => {
    const place = places[0] + (length * (cell + 0.5)) / count;
    const left = Math.max(0, Math.min(places.length - 2, d3.bisectRight(places, place) - 1));
    return /** @type {[number, number]} */ ([left, (place - places[left]) / (places[left + 1] - places[left])]);
  });
}
