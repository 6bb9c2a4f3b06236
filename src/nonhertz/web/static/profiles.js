// The small drawing of each body's profile, above the list of profiles in the form.

import { figure } from "./chart.js";
import { drawPanels } from "./panel.js";

/** @typedef {import("./types.js").Profiles} Profiles */

/** What a body is called: those of a single contact have letters. @param {string} body */
export function bodyNamed(body) {
  return body.length === 1 ? `body ${body}` : body === "roller" ? body : `${body} ring`;
}

/**
 * Draw the available profiles.
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
    drawPanels(profile, pinned?.[body], { last: profile.panels[0].name, pinnedAs });
  }
}
