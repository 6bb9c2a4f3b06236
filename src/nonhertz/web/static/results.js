// Key numbers, warnings and the summary: the text beside the figures.

import { byId } from "./elements.js";
import { difference, digits } from "./numbers.js";
import { html, render } from "./preact.js";
import { amount, force, parts, spelled } from "./units.js";

/** @typedef {import("./types.js").Answer} Answer */
/** @typedef {import("./types.js").Pin} Pin */
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
      where: answer.singular ? "largest, away from singular ends" : "largest",
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
 * Write the key numbers, with their differences from those of the first pinned case, and the table of pinned cases.
 * @param {KeyNumber[]} numbers
 * @param {(Pin & {numbers: KeyNumber[]})[]} pins
 */
export function writeKeyNumbers(numbers, pins) {
  const [first] = pins;
  const number = (each) => html`<${Tile} key=${each.name} now=${each} before=${first && numberOf(first, each)} />`;
  render(numbers.map(number), byId("key-numbers"));
  byId("pins").hidden = !first;
  render(first && html`<${Pins} pins=${pins} numbers=${numbers} />`, byId("pins"));
}

/** @param {{now: KeyNumber, before?: KeyNumber}} props */
function Tile({ now, before }) {
  return html`<div class="key-number ${now.stale ? "stale" : ""}" data-key=${now.name} data-number=${String(now.number)}>
    <dt>${now.name}</dt>
    <dd><span class="value">${now.value}</span><span class="unit">${now.unit}</span>
      <span class="where">${now.stale ? "before the change, " : ""}${now.where}</span>
      ${
        before &&
        html`<span class="pinned-number"><span class="swatch pinned"></span> <b>${change(now, before)}</b>
          <span class="unseen"> from the pinned one</span></span>`
      }</dd></div>`;
}

/** A row for each pinned case and one for that in the form, with differences from the first. */
function Pins({ pins, numbers }) {
  const cell = (each, row) => {
    const number = numberOf(row, each);
    const before = row !== pins[0] && numberOf(pins[0], each);
    return html`<td key=${each.name}>${number ? `${number.value} ${number.unit}` : "–"}
      ${number && before && html`<small>${change(number, before)}</small>`}</td>`;
  };
  const line = (row) => numbers.map((each) => cell(each, row));
  const pinned = (pin) => html`<tr key=${pin.id}>
    <th scope="row"><input type="text" value=${pin.name} aria-label="name of a pinned case" title=${pin.name}
      autocomplete="off" spellcheck=${false} onInput=${({ target }) => pin.rename(target.value)} />
      <button type="button" aria-label="go back to ${pin.name}" onClick=${pin.open}>Go back</button>
      <button type="button" aria-label="unpin ${pin.name}" onClick=${pin.remove}>Unpin</button></th>${line(pin)}</tr>`;
  return html`<h2 id="pins-title"><span class="swatch pinned"></span> Pinned, with differences from the first</h2>
    <div class="table" tabindex="0" role="group" aria-labelledby="pins-title"><table>
      <thead><tr><th scope="col">Name</th>${numbers.map(({ name }) => html`<th scope="col">${name}</th>`)}</tr></thead>
      <tbody>${pins.map(pinned)}
        <tr key="now" class="now"><th scope="row">In the form</th>${line({ numbers })}</tr></tbody></table></div>`;
}

/** @param {{numbers: KeyNumber[]}} row @param {KeyNumber} like */
function numberOf({ numbers }, like) {
  return numbers.find(({ name }) => name === like.name);
}

/** @param {KeyNumber} now @param {KeyNumber} before */
function change(now, before) {
  const comparable = now.under === before.under || difference(now.under, before.under) === "same";
  return comparable ? difference(now.number, before.number) : "under another load";
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
  render(verdict && html`<strong>${words}</strong> ${verdict.sentence}`, tile);
}

/**
 * Write warnings and the summary.
 * @param {[string, string, string][]} summary
 * @param {string[]} warnings
 */
export function writeRows(summary, warnings) {
  byId("warnings").hidden = warnings.length === 0;
  render(warnings.map((sentence) => html`<li>${sentence}</li>`), byId("warnings"));
  const row = ([name, value, remark]) =>
    html`<tr>${name ? html`<th scope="row">${name}</th>` : html`<td></td>`}<td>${value}</td><td>${remark}</td></tr>`;
  render(summary.map(row), byId("summary"));
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
