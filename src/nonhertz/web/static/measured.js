// Measured profiles: a file is uploaded, the steps that turn it into a profile are shown, and each can be switched off.
//
// The bytes are kept here. Every switch sends them again with other options, so every step can be undone.

import { byId } from "./elements.js";
import { AWAY, send } from "./live.js";
import { drawPanels } from "./panel.js";
import { html, render, useRef } from "./preact.js";
import { bodyNamed } from "./profiles.js";
import { unitsCode } from "./units.js";

/** @typedef {{name: string, bytes: ArrayBuffer, options: Record<string, string>, answer: any, units?: string}} Upload */

/** Steps: name, the option that switches it, and what it does. */
const STEPS = [
  ["level", "level", "remove the tilt"],
  ["align", "align", "move the middle to y = 0"],
  ["trim", "trim", "cut off all but land and corners"],
  ["outliers", "outliers", "remove outliers"],
  ["smooth", "smooth", "smooth, which removes roughness"],
  ["thin", "points", "thin to fewer points"],
];
const AS_SAID = ["", "as in the file"];
/** @type {[string, string, string[][]][]} the option, its words, and its values with theirs */
const CHOICES = [
  ["height_unit", "heights in", [AS_SAID, ["um", "µm"], ["mm", "mm"], ["nm", "nm"], ["m", "m"], ["in", "in"]]],
  ["position_unit", "positions in", [AS_SAID, ["mm", "mm"], ["um", "µm"], ["m", "m"], ["in", "in"]]],
  ["corner", "corners", [["", "keep"], ["cut", "cut off"]]],
  ["sense", "positive is", [["", "material (height)"], ["drop", "material removed (drop)"]]],
  ["cutoff", "cutoff", [["", "0.8 mm"], ["0.25", "0.25 mm"], ["2.5", "2.5 mm"], ["8", "8 mm"]]],
];
/** What is typed: the option, its words, and what an empty field shows. */
const TYPED = [
  ["step", "point spacing", "such as 0.5 um"],
  ["position_column", "column of positions", "number or name"],
  ["height_column", "column of heights", "number or name"],
];

export class Measured {
  /** @param {{most: number, use: (body: string, table: object) => void}} page */
  constructor({ most, use }) {
    this.most = most;
    this.use = use;
    /** @type {Record<string, Upload>} */
    this.uploads = {};
    this.body = "";
    this.count = 0; // of all requests
    this.dialog = /** @type {HTMLDialogElement} */ (byId("measured"));
    this.dialog.addEventListener("dragover", (event) => event.preventDefault());
    this.dialog.addEventListener("drop", (event) => this.dropped(event, this.body));
  }

  /** Show the dialog for a body, with what was uploaded for it before. @param {string} body */
  open(body) {
    this.body = body;
    if (!this.dialog.open) this.dialog.showModal();
    this.draw();
    const upload = this.uploads[body];
    if (upload?.units && upload.units !== unitsCode()) void this.send(upload);
  }

  /** @param {DragEvent} event @param {string} body */
  dropped(event, body) {
    const file = event.dataTransfer?.files[0];
    if (!file) return;
    event.preventDefault();
    this.open(body);
    void this.take(file);
  }

  /** @param {File} file */
  async take(file) {
    const fits = file.size <= this.most;
    const sentence = `${file.name} must be a file of at most ${Math.floor(this.most / 1048576)} MB: prepare it with nonhertz profile.`;
    const upload = {
      name: file.name,
      bytes: fits ? await file.arrayBuffer() : new ArrayBuffer(0),
      options: {},
      answer: fits ? null : { ok: false, mistakes: [{ sentence }] },
    };
    this.uploads[this.body] = upload;
    this.draw();
    if (fits) await this.send(upload);
  }

  /** @param {Upload} upload */
  async send(upload) {
    const number = (this.count += 1);
    upload.units = unitsCode();
    this.draw(true);
    const query = new URLSearchParams({ name: upload.name, ...upload.options });
    let answer;
    try {
      answer = await (await send(`upload?${query}`, "application/octet-stream", upload.bytes)).json();
    } catch {
      answer = { ok: false, mistakes: [{ sentence: AWAY }] };
    }
    if (number !== this.count) return; // superseded by a later request
    upload.answer = answer;
    this.draw();
  }

  /** @param {Upload} upload @param {string} option @param {string} value empty to leave it out */
  set(upload, option, value) {
    if (value === "") delete upload.options[option];
    else upload.options[option] = value;
    void this.send(upload);
  }

  /** @param {boolean} [stale] whether the answer is to other options */
  draw(stale = false) {
    render(html`<${Content} key=${this.body} measured=${this} upload=${this.uploads[this.body]} stale=${stale} />`, this.dialog);
    const steps = this.uploads[this.body]?.answer?.steps;
    if (steps && !stale) drawPanels(steps, undefined);
  }

  /** @param {Upload} upload */
  useIt(upload) {
    this.use(this.body, upload.answer.table);
    this.dialog.close();
  }
}

/** @param {{measured: Measured, upload: Upload | undefined, stale: boolean}} props */
function Content({ measured, upload, stale }) {
  const body = bodyNamed(measured.body);
  const input = useRef(/** @type {any} */ (null));
  return html`
    <div class="dialog-head">
      <h2 id="measured-title">Measured profile for ${body}</h2>
      <button type="button" onClick=${() => measured.dialog.close()}>Close</button></div>
    <div class="dialog-body ${stale ? "stale" : ""}">
      <div class="picker">
        <button type="button" onClick=${() => input.current.click()}>Choose ${upload ? "another" : "a"} file…</button>
        <input type="file" id="measured-file" hidden aria-label="measured profile" ref=${input}
          onChange=${({ target }) => target.files[0] && void measured.take(target.files[0])} />
        ${upload && html`<b>${upload.name}</b>`}
        <span class="hint">${
          upload
            ? "or drop one here"
            : "with positions and heights, or drop it here. It goes to the program on this machine and nowhere else."
        }</span></div>
      ${upload && html`<${Options} ...${{ measured, upload }} /><${Outcome} ...${{ measured, upload, body }} />`}</div>`;
}

/** The switches of the steps, and how to read the file. */
function Options({ measured, upload }) {
  const of = (option) => upload.options[option] ?? "";
  const take = (option) => ({ target }) => measured.set(upload, option, target.value.trim());
  const turn = (option) => ({ target }) => measured.set(upload, option, target.checked ? "" : "false");
  const switches = STEPS.map(
    ([name, option, words]) => html`<label class="check">
      <input type="checkbox" id="step-${name}" checked=${of(option) !== "false"} onChange=${turn(option)} /> ${words}</label>`,
  );
  const choices = CHOICES.map(
    ([option, words, values]) => html`<label class="choice">${words}
      <select value=${of(option)} onChange=${take(option)}>
        ${values.map(([value, text]) => html`<option value=${value}>${text}</option>`)}</select></label>`,
  );
  const typed = TYPED.map(
    ([option, words, placeholder]) => html`<label class="choice">${words}
      <input type="text" value=${of(option)} placeholder=${placeholder} onChange=${take(option)} /></label>`,
  );
  return html`<div class="options">
    <fieldset><legend>Steps</legend>${switches}</fieldset>
    <fieldset><legend>Reading</legend>${choices}${typed}</fieldset></div>`;
}

/** The result of preparing the file. */
function Outcome({ measured, upload, body }) {
  const { answer } = upload;
  const list = (sentences) => sentences.map((words) => html`<li>${words}</li>`);
  if (!answer) return html`<p class="hint" role="status">reading …</p>`;
  if (!answer.ok)
    return html`<ul class="mistakes-plain" role="alert">${list(answer.mistakes.map(({ sentence }) => sentence))}</ul>`;
  return html`
    ${answer.notes.map((words) => html`<p class="hint">${words}</p>`)}
    ${answer.warnings.length > 0 && html`<ul class="warnings">${list(answer.warnings)}</ul>`}
    <div class="figures steps">${answer.steps.panels.map(
      ({ name }) => html`<figure key=${name} data-figure=${name}><figcaption></figcaption><div class="drawing"></div></figure>`,
    )}</div>
    <details class="roughness"><summary>Roughness removed by smoothing</summary>
      <table>${answer.roughness.map(
        ([name, ...cells]) => html`<tr><th>${name}</th>${cells.map((cell) => html`<td>${cell}</td>`)}</tr>`,
      )}</table></details>
    <p class="dialog-foot">
      <button type="button" class="primary" id="measured-use" onClick=${() => measured.useIt(upload)}>
        Use as profile of ${body}</button>
      <span class="hint">${answer.table.y.length} points, replacing the profiles of ${body}</span></p>`;
}
