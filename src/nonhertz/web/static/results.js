// Key numbers, warnings and the summary: the text beside the figures.

import { byId, element } from "./elements.js";
import { difference, digits } from "./numbers.js";
import { amount, force, parts, spelled } from "./units.js";

/** @typedef {import("./types.js").Answer} Answer */
/**
 * @typedef {{name: string, value: string, unit: string, where: string, number: number | null, under?: number, stale?: boolean}} KeyNumber
 *   `under` is the load without which a number does not compare, a `stale` one is that before the last change
 */

let speaking = 0;

/** The approach beyond first touch where it differs from the approach, in words. @param {Answer["key"]} key */
function penetration(key) {
  const noticeable = Math.abs(key.approach - key.penetration) > 0.05 * Math.abs(key.penetration);
  return noticeable ? `, ${amount(1e3 * key.penetration, "µm")} after first touch` : "";
}

/**
 * The numbers at the top.
 * @param {Answer} answer
 * @param {Answer["stress"]} stress the largest where the pressure is largest, or of the whole body; missing if stresses
 *   are not shown
 * @returns {KeyNumber[]}
 */
export function keyNumbers(answer, stress) {
  const { key } = answer;
  return [
    {
      name: "Largest pressure",
      ...parts(key.max_pressure, "MPa"),
      where: key.largest,
      number: key.max_pressure,
    },
    {
      name: "Approach",
      ...parts(1e3 * key.approach, "µm"),
      where: `tilt ${digits(1e3 * key.tilt, 3)} mrad${penetration(key)}`,
      number: key.approach,
    },
    { name: "Load", ...force(key.load), where: `moment ${amount(key.moment / 1e3, "N m", 3)}`, number: key.load },
    {
      name: "Half-width",
      ...parts(key.max_half_width, "mm"),
      where: answer.singular.length ? "largest, away from singular ends" : "largest",
      number: key.max_half_width,
    },
    stress
      ? {
          name: "von Mises stress",
          ...parts(stress.von_mises.max, "MPa"),
          where: `body ${stress.body}, ${place(stress)}`,
          number: stress.von_mises.max,
        }
      : { name: "von Mises stress", value: "–", unit: "", where: "not shown", number: null },
    ...(answer.life ? [life(answer.life, key.load)] : []),
  ];
}

/** Where the largest von Mises stress is; while a slider moves, only the plane of the largest pressure is looked at. */
function place({ von_mises: { y, z, at_bore }, searched }) {
  return searched ? `${at_bore ? "at the bore, " : ""}y = ${amount(y, "mm", 3)}, ${amount(z, "mm", 3)} deep` : "below the largest pressure";
}

/**
 * The life by laminae: in revolutions where there is a rating, else over that of an even pressure under the same load,
 * which rises where the load does and so compares under the same load alone. There is none but of a rolling bearing.
 */
function life(found, load) {
  if (found.relative_life === null) return { name: "Life", value: "–", unit: "", where: "not known", number: null };
  const model = `ISO/TS 16281, body ${found.body}${found.ends_counted ? "" : ", sharp ends not counted"}`;
  if (found.million_revolutions === null)
    return { name: "Life", value: digits(found.relative_life, 3), unit: "× ideal profile", where: model, number: found.relative_life, under: load };
  const number = found.million_revolutions;
  return { name: "Life", value: digits(number, 4), unit: "10⁶ rev.", where: `L₁₀, ${model}`, number };
}

/**
 * Write the key numbers, with those of the pinned case.
 * @param {KeyNumber[]} numbers
 * @param {KeyNumber[] | null} pinned
 */
export function writeKeyNumbers(numbers, pinned) {
  byId("key-numbers").replaceChildren(
    ...numbers.map((each) => {
      const before = pinned?.find(({ name }) => name === each.name);
      return element("div", { class: `key-number${each.stale ? " stale" : ""}`, "data-key": each.name, "data-number": String(each.number) }, [
        element("dt", {}, [each.name]),
        element("dd", {}, [
          element("span", { class: "value" }, [each.value]),
          element("span", { class: "unit" }, [each.unit]),
          element("span", { class: "where" }, [each.stale ? `before the change, ${each.where}` : each.where]),
          ...(before ? [pinnedNumber(each, before)] : []),
        ]),
      ]);
    }),
  );
}

function pinnedNumber(each, before) {
  const comparable = each.under === before.under || difference(each.under, before.under) === "same";
  return element("span", { class: "pinned-number" }, [
    `pinned ${before.value} ${before.unit} `,
    element("b", {}, [comparable ? difference(each.number, before.number) : "under another load"]),
  ]);
}

/**
 * Write warnings and the summary, and announce the result to screen readers.
 * @param {Answer} answer
 */
export function writeWords(answer) {
  writeVerdict(answer.verdict);
  writeRows(answer.summary, [...(answer.complaint ? [answer.complaint] : []), ...answer.warnings]);
  sayLater(spoken(answer));
}

/** Write whether limits are met: a coloured tile. @param {Answer["verdict"]} verdict @param {boolean} [stale] */
export function writeVerdict(verdict, stale = false) {
  const tile = byId("verdict");
  tile.hidden = !verdict;
  tile.classList.toggle("stale", stale);
  tile.dataset.level = verdict?.level ?? "";
  const words = stale ? `Before the change: ${verdict?.words}` : verdict?.words;
  const parts = verdict ? [element("strong", {}, [words]), ` ${verdict.sentence}`] : [];
  tile.replaceChildren(...parts);
}

/**
 * Write warnings and the summary.
 * @param {[string, string, string][]} summary
 * @param {string[]} warnings
 */
export function writeRows(summary, warnings) {
  byId("warnings").hidden = warnings.length === 0;
  byId("warnings").replaceChildren(...warnings.map((sentence) => element("li", {}, [sentence])));
  const rows = summary.map(([name, value, remark]) =>
    element("tr", {}, [
      name ? element("th", { scope: "row" }, [name]) : element("td", {}),
      element("td", {}, [value]),
      element("td", {}, [remark]),
    ]),
  );
  /** @type {HTMLElement} */ (byId("summary").querySelector("tbody")).replaceChildren(...rows);
}

function spoken({ key, warnings }) {
  const pressure = `largest pressure ${amount(key.max_pressure, "MPa")}`;
  const warned = warnings.length ? `, ${warnings.length} warning${warnings.length > 1 ? "s" : ""}` : "";
  return `${pressure}, approach ${spelled(1e3 * key.approach, "µm")}, half-width ${amount(key.max_half_width, "mm")}${warned}`;
}

/**
 * Dim the last good result, which is not that of what is edited.
 * @param {boolean} known whether there is one
 * @param {string} [why]
 */
export function outdate(known, why = "") {
  byId("results").classList.add("outdated");
  byId("state").textContent = known ? "last good result" : "no result yet";
  byId("round-trip").textContent = why;
}

/** Announce mistakes. @param {import("./types.js").Mistake[]} mistakes */
export function sayMistakes(mistakes) {
  sayLater(`${mistakes.length} mistake${mistakes.length === 1 ? "" : "s"}: ${mistakes[0]?.sentence ?? ""}`);
}

/** Write what the page shows into its head and the title of the window. @param {string} title */
export function entitle(title) {
  byId("case-title").textContent = byId("case-title").title = title;
  document.title = title ? `${title} – nonhertz` : "nonhertz";
}

/** Announce something to screen readers once editing pauses: not every answer of a drag. @param {string} words */
export function sayLater(words) {
  window.clearTimeout(speaking);
  speaking = window.setTimeout(() => {
    byId("spoken").textContent = words;
  }, 700);
}
