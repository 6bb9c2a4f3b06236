// Measured profiles: a file is uploaded, the steps that turn it into a profile are shown, and each can be switched off.
//
// The bytes are kept here. Every switch sends them again with other options, so every step can be undone.

import { byId } from "./elements.js";
import { AWAY, send } from "./live.js";
import { options, outcome, picker } from "./preparation.js";
import { bodyNamed } from "./profiles.js";
import { drawSteps } from "./steps.js";

/** @typedef {{name: string, bytes: ArrayBuffer, options: Record<string, string>, answer: any}} Upload */

export class Measured {
  /**
   * @param {{most: number, use: (body: string, table: object) => void}} given
   */
  constructor({ most, use }) {
    this.most = most;
    this.use = use;
    /** @type {Record<string, Upload>} */
    this.uploads = {};
    this.body = "";
    this.asked = 0;
    this.dialog = /** @type {HTMLDialogElement} */ (byId("measured"));
    this.content = byId("measured-body");
    byId("measured-close").addEventListener("click", () => this.dialog.close());
    this.dialog.addEventListener("dragover", (event) => event.preventDefault());
    this.dialog.addEventListener("drop", (event) => this.dropped(event, this.body));
  }

  /** Show the dialog for a body, with what was uploaded for it before. @param {string} body */
  open(body) {
    this.body = body;
    byId("measured-title").textContent = `Measured profile for ${bodyNamed(body)}`;
    this.show();
    if (!this.dialog.open) this.dialog.showModal();
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
    const mistake = (sentence) => ({ ok: false, mistakes: [{ path: "upload", sentence }] });
    const fits = file.size <= this.most;
    const upload = {
      name: file.name,
      bytes: fits ? await file.arrayBuffer() : new ArrayBuffer(0),
      options: {},
      answer: fits
        ? null
        : mistake(`${file.name} must be a file of at most ${Math.floor(this.most / 1048576)} MB: prepare it with nonhertz profile.`),
    };
    this.uploads[this.body] = upload;
    this.show();
    if (fits) await this.send(upload);
  }

  /** @param {Upload} upload */
  async send(upload) {
    const number = (this.asked += 1);
    this.content.classList.add("stale");
    const query = new URLSearchParams({ name: upload.name, ...upload.options });
    let answer;
    try {
      const response = await send(`upload?${query}`, "application/octet-stream", upload.bytes);
      answer = await response.json();
    } catch {
      answer = { ok: false, mistakes: [{ path: "", sentence: AWAY }] };
    }
    if (number !== this.asked) return; // superseded by a later request
    upload.answer = answer;
    this.show();
  }

  /** @param {Upload} upload @param {string} option @param {string} value empty to leave it out */
  set(upload, option, value) {
    if (value === "") delete upload.options[option];
    else upload.options[option] = value;
    void this.send(upload);
  }

  show() {
    const upload = this.uploads[this.body];
    const focus = document.activeElement?.id ?? "";
    this.content.classList.remove("stale");
    const set = (option, value) => upload && this.set(upload, option, value);
    const use = () => upload && this.useIt(upload);
    this.content.replaceChildren(
      picker(upload?.name, (file) => void this.take(file)),
      ...(upload ? [options(upload, set), ...outcome(upload, bodyNamed(this.body), use)] : []),
    );
    if (upload?.answer?.ok) drawSteps(this.content.querySelector(".steps"), upload.answer.steps);
    if (focus && this.dialog.open) document.getElementById(focus)?.focus();
  }

  /** @param {Upload} upload */
  useIt(upload) {
    this.use(this.body, upload.answer.table);
    this.dialog.close();
  }
}
