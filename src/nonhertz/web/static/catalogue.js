// The dialog that starts a bearing from the data in a catalogue.

import { byId } from "./elements.js";
import { legible } from "./fields.js";
import { split } from "./numbers.js";
import { html, render, useState } from "./preact.js";

/** @typedef {[symbol: string, meaning: string, unit: string]} Datum with the unit of a plain number */
/** @typedef {{needed: Datum[], kinds: Record<string, {others: Datum[], hint: string}>, clearance: Datum}} Fields */

/**
 * Open the dialog with the button.
 * @param {Fields} fields
 * @param {(data: Record<string, string>) => Promise<string>} start starts from data by symbols; returns a mistake or ""
 */
export function watchCatalogue(fields, start) {
  const dialog = /** @type {HTMLDialogElement} */ (byId("catalogue"));
  const close = () => dialog.close();
  render(html`<${Content} ...${{ fields, start, close }} />`, dialog);
  byId("from-catalogue").addEventListener("click", () => dialog.showModal());
}

function Content({ fields, start, close }) {
  const [kind, choose] = useState("cylindrical");
  const [mistake, say] = useState("");
  const [busy, wait] = useState(false);
  const { others, hint } = fields.kinds[kind];
  const submit = async (event) => {
    event.preventDefault();
    const form = /** @type {HTMLFormElement} */ (event.target);
    const inputs = /** @type {HTMLInputElement[]} */ ([...form.querySelectorAll("input")]);
    const data = inputs.filter(({ value }) => value.trim()).map(({ name, value, dataset }) => [name, inUnit(value, dataset.unit)]);
    wait(true);
    const wrong = await start({ kind, ...Object.fromEntries(data) });
    wait(false);
    say(wrong);
    if (!wrong) close();
  };
  const input = ([symbol, meaning, unit], required = false) => html`<label class="choice" key=${symbol}>
    ${meaning} ${unit && `[${legible(unit)}]`}
    <input type="text" name=${symbol} data-unit=${unit} required=${required} autocomplete="off" spellcheck=${false} /></label>`;
  return html`<form autocomplete="off" onSubmit=${submit}>
    <div class="dialog-head"><h2 id="catalogue-title">Start from catalogue data</h2>
      <button type="button" onClick=${close}>Close</button></div>
    <div class="dialog-body">
      <p class="hint">The number and size of the rollers are estimated from boundary dimensions and load ratings. Any unit
        may be typed with a number: 44000 N.</p>
      <div class="options">
        <fieldset><legend>Bearing</legend>
          <label class="choice">type of bearing
            <select value=${kind} onInput=${({ target }) => choose(target.value)}>
              ${Object.keys(fields.kinds).map((word) => html`<option value=${word}>${word}</option>`)}</select></label>
          ${fields.needed.map((datum) => input(datum, true))}</fieldset>
        <fieldset><legend>If known</legend>
          <p class="hint">${hint}</p>${others.map((datum) => input(datum))}
          <p class="hint">by default the mean of group CN; 0 for tapered bearings</p>${input(fields.clearance)}</fieldset></div>
      ${mistake && html`<p class="mistake" role="alert">${mistake}</p>`}
      <p class="dialog-foot"><button class="primary" disabled=${busy}>${busy ? "Estimating …" : "Start"}</button>
        <span class="hint">This replaces the bearing in the form; Undo brings it back.</span></p></div></form>`;
}

/** What is typed, with the unit of a plain number. @param {string} text @param {string} [unit] */
function inUnit(text, unit) {
  const written = split(text);
  return written ? `${written.number} ${written.unit}` : `${text.trim()} ${unit ?? ""}`.trim();
}
