// The small drawing of each body's profile, above the list of profiles in the form.

import { FIRST, INK, PINNED, axis, draw, extent, figure, line, reading, widthOf } from "./chart.js";
import { amount, named, spelled, unitsCode } from "./units.js";

/** @typedef {import("./types.js").Profiles} Profiles */

/** @type {WeakMap<Element, string>} what a drawing shows */
const drawn = new WeakMap();

/** What a body is called: those of a single contact have letters. @param {string} body */
export function bodyNamed(body) {
  return body.length === 1 ? `body ${body}` : body === "roller" ? body : `${body} ring`;
}

/**
 * Draw the available profiles; relief points down, as removed material.
 * @param {string[]} bodies
 * @param {Profiles | undefined} profiles
 * @param {Profiles | undefined} pinned
 * @param {string} pinnedAs what that is called
 */
export function drawProfiles(bodies, profiles, pinned, pinnedAs) {
  for (const body of bodies) {
    const host = figure(`profile-${body}`);
    if (!host) continue;
    const profile = profiles?.[body];
    host.classList.toggle("outdated", !profile); // the last drawing of an invalid body stays, dimmed
    if (!profile) continue;
    // Redrawn only if it changed: dragging the load, for example, changes no profile.
    const numbers = `${unitsCode()} ${widthOf(host)} ${profile.y} ${profile.relief_um} ${pinned?.[body]?.relief_um} ${pinnedAs}`;
    if (drawn.get(host) !== numbers) drawProfile(host, body, profile, pinned?.[body], pinnedAs);
    drawn.set(host, numbers);
  }
}

function drawProfile(host, body, { y, relief_um: relief, range_um: range }, pinned, pinnedAs) {
  const [low, high] = d3.extent([...range, ...(pinned?.range_um ?? [])]);
  const cut = relief.map((value) => (value === null ? null : Math.min(value, 2 * high)));
  draw(
    host,
    {
      height: 96,
      marginLeft: 44,
      marginRight: 10,
      marginTop: 10,
      marginBottom: 22,
      x: { ...axis("", "mm", extent(y)), label: null, ticks: 5 },
      y: { ...axis("", "µm", [high, low]), label: null, ticks: 3, grid: true },
      marks: [
        Plot.areaY(y, { x: y, y1: cut, y2: () => 2 * high, fill: INK, fillOpacity: 0.07, clip: true }),
        ...(pinned ? [line(pinned.y, pinned.relief_um, { stroke: PINNED, strokeDasharray: "2 3", clip: true })] : []),
        line(y, cut, { stroke: FIRST, clip: true }),
        Plot.text([[low, high]], {
          frameAnchor: "bottom",
          text: [`relief [${named("µm")}] along y [${named("mm")}]${pinned ? `, dotted: ${pinnedAs}` : ""}`],
          dy: -4,
          fill: INK,
          fillOpacity: 0.7,
          fontSize: 10,
        }),
        ...reading(y, cut, (place) => `y ${amount(y[place], "mm")}\n${amount(relief[place], "µm")}`),
      ],
    },
    `Profile of ${bodyNamed(body)}: relief up to ${spelled(extent(relief)[1], "µm", 3)}.`,
  );
}
