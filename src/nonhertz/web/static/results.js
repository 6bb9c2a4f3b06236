// Key numbers, warnings and the summary: the text beside the figures.

import { byId } from "./elements.js";
import { nameOf } from "./fields.js";
import { showMistakes } from "./mistakes.js";
import { difference } from "./numbers.js";
import { html, render } from "./preact.js";
import { sayState } from "./status.js";
import { inFull } from "./units.js";

/** @typedef {import("./types.js").Answer} Answer */
/** @typedef {import("./types.js").Pin} Pin */
/**
 * @typedef {{name: string, value: string, unit: string, where: string, number: number | null, under: number | null, stale?: boolean}} KeyNumber
 *   as the program writes it; `under` is the load without which it does not compare, a `stale` one is that before the last
 *   change
 */

const SPOKEN = 4;
let speaking = 0;

/**
 * The numbers at the top.
 * @param {Answer} answer
 * @param {KeyNumber | undefined} stress the largest where the pressure is largest, or of the whole body; missing if
 *   stresses are not shown
 * @returns {KeyNumber[]}
 */
export function keyNumbers({ numbers }, stress) {
  return [...numbers, stress ?? { name: "von Mises stress", value: "–", unit: "", where: "not shown", number: null, under: null }];
}

/**
 * Write the key numbers, with their differences from those of the first pinned case, and the table of pinned cases.
 * @param {KeyNumber[]} numbers
 * @param {(Pin & {numbers: KeyNumber[]})[]} pins
 */
export function writeKeyNumbers(numbers, pins) {
  const [first] = pins;
  const tile = (number) => html`<${Tile} key=${number.name} now=${number} before=${first && numberOf(first, number)} />`;
  render(numbers.map(tile), byId("key-numbers"));
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
  const cell = (column, row) => {
    const number = numberOf(row, column);
    const before = row !== pins[0] && numberOf(pins[0], column);
    return html`<td key=${column.name}>${number ? `${number.value} ${number.unit}` : "–"}
      ${number && before && html`<small>${change(number, before)}</small>`}</td>`;
  };
  const line = (row) => numbers.map((column) => cell(column, row));
  const pinned = (pin) => html`<tr key=${pin.id}>
    <th scope="row"><input type="text" value=${pin.name} aria-label="name of a pinned case" title=${pin.name}
      autocomplete="off" spellcheck=${false} onInput=${({ target }) => pin.rename(target.value)} />
      <button type="button" aria-label="go back to ${pin.name}" onClick=${pin.open}>Go back</button>
      <button type="button" aria-label="unpin ${pin.name}" onClick=${pin.remove}>Unpin</button></th>${line(pin)}</tr>`;
  return html`<h2 id="pins-title"><span class="swatch pinned"></span> Pinned, with differences from the first</h2>
    <div class="table" tabindex="0" role="group" aria-labelledby="pins-title"><table>
      <${Columns} heads=${["Name", ...numbers.map(({ name }) => name)]}>${pins.map(pinned)}
        <tr key="now" class="now"><th scope="row">In the form</th>${line({ numbers })}</tr><//></table></div>`;
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
 * Write title, verdict, warnings and summary, and announce the result to screen readers.
 * @param {any} answer
 * @param {any} [before] the answer before the last change, where the verdict is that of it
 */
export function writeWords(answer, before = null) {
  byId("results").classList.remove("outdated", "empty");
  entitle(answer.title);
  writeVerdict((before ?? answer).verdict, Boolean(before));
  const warnings = [...(answer.complaint ? [answer.complaint] : []), ...answer.warnings];
  byId("warnings").hidden = !warnings.length;
  render(warnings.map((sentence) => html`<li>${sentence}</li>`), byId("warnings"));
  const row = ([name, value, remark]) =>
    html`<tr>${name ? html`<th scope="row">${name}</th>` : html`<td></td>`}<td>${value}</td><td>${named(remark)}</td></tr>`;
  render(answer.summary.map(row), byId("summary"));
  const { length } = answer.warnings;
  const by = answer.method ? `By ${answer.method}: ` : "";
  sayLater(`${by}${spoken(answer.numbers)}${length ? `, ${length} warning${length > 1 ? "s" : ""}` : ""}`);
}

/** A remark with the names of fields in place of their keys. @param {string} remark */
function named(remark) {
  const { elements } = /** @type {HTMLFormElement} */ (byId("case"));
  return remark.replace(/\b[a-z]\w*(\.\w+(\[\d+\])?)+/g, (key) => {
    const control = /** @type {any} */ (elements.namedItem(key));
    return control ? nameOf(control) : key;
  });
}

/** A table in which heads and cells are as the program words them. @param {{heads: string[], children: any}} props */
export function Columns({ heads, children }) {
  return html`<thead><tr>${heads.map((head) => html`<th scope="col">${head}</th>`)}</tr></thead>
    <tbody>${children}</tbody>`;
}

/** @param {string[]} row */
export function cells(row) {
  return row.map((text) => html`<td>${text}</td>`);
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

/** The first numbers in words. @param {KeyNumber[]} numbers */
function spoken(numbers) {
  return numbers.slice(0, SPOKEN).map(({ name, value, unit }) => `${name.toLowerCase()} ${value} ${inFull(unit)}`).join(", ");
}

/**
 * Dim the last good result, which is not that of what is edited.
 * @param {boolean} known whether there is one
 * @param {string} [why]
 */
export function outdate(known, why = "") {
  byId("results").classList.add("outdated");
  sayState(known ? "last good result" : "no result yet", why);
}

/**
 * Show and announce what is wrong; the last good result stays, dimmed.
 * @param {boolean} known whether there is one
 * @param {import("./types.js").Mistake[]} mistakes
 */
export function refuse(known, mistakes) {
  showMistakes(mistakes);
  outdate(known);
  sayLater(`${mistakes.length} mistake${mistakes.length === 1 ? "" : "s"}: ${mistakes[0]?.sentence ?? ""}`);
}

/** Write what the page shows into its head and the title of the window. @param {string} title */
export function entitle(title) {
  byId("case-title").textContent = byId("case-title").title = title;
  document.title = title ? `${title} – nonhertz` : "nonhertz";
}

/** Announce something to screen readers once editing pauses: not every answer of a drag. @param {string} words */
function sayLater(words) {
  window.clearTimeout(speaking);
  speaking = window.setTimeout(() => {
    byId("spoken").textContent = words;
  }, 700);
}
