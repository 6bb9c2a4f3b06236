// The parts that both pages share: a document with its form and its file, undo, links, pins, and dropped files.

import { pinnedAs } from "./chart.js";
import { watchDrops } from "./drops.js";
import { Edits } from "./edits.js";
import { byId } from "./elements.js";
import { nameOf, unitOf } from "./fields.js";
import { opened, saved } from "./files.js";
import { Form } from "./form.js";
import { Address, shared } from "./link.js";
import { AWAY, post } from "./live.js";
import { Measured } from "./measured.js";
import { showMistakes } from "./mistakes.js";
import { differences, withValue } from "./paths.js";
import { drawProfiles } from "./profiles.js";
import { notice } from "./status.js";
import { watchUnits } from "./units.js";

/** @typedef {import("./types.js").Pin} Pin */
/** @typedef {{document: object, answer: any}} Result a document with what was answered to it */
/** @typedef {{document: any, text: string, form: any, limits: {document_bytes: number, upload_bytes: number}}} Start */
/**
 * @typedef {{
 *   what: string,
 *   at: string,
 *   bodies: Record<string, string>,
 *   want: (document: any, since?: number) => void,
 *   latest: () => Result | null,
 *   pin: (pins: Pin[]) => void,
 *   solve: (document: object) => Promise<any>,
 *   drawn?: () => void,
 *   looked?: () => object,
 *   begun?: () => void,
 *   again: (result: Result) => void,
 *   renamed?: () => void,
 * }} Page
  * The kind of document, the address of its routes, and the paths of its bodies by name; how a document is solved, the
 * latest result, and what follows when others are pinned (`solve` answers for those in a link); what follows when a form
 * is drawn, the selection, which is no part of the document, and what follows when another document is started, when the
 * latest good result is shown in other units, or when units are changed.
 */

const WRITTEN_IN = "textarea, input:not([type=range], [type=checkbox], [type=radio])";
const MOST_PINS = 8;
const CHANGES = 3; // that the name of a pinned document has

export class Work {
  /** @param {Start} start @param {Page} page */
  constructor(start, page) {
    this.start = start;
    this.page = page;
    this.text = start.text; // of the file, for its comments
    /** @type {import("./types.js").Estimates | null} */
    this.estimates = null;
    /** @type {Pin[]} */
    this.pins = [];
    this.count = 0; // of all that were pinned
    /** @type {any} */
    this.profiles = undefined;
    this.address = new Address();
    this.measured = new Measured({
      most: start.limits.upload_bytes,
      use: (body, table) => void this.form.open(withValue(this.document, `${page.bodies[body]}.profile`, [table])),
    });
    this.form = new Form(start.document, start.form, {
      bodies: page.bodies,
      edited: (document, since) => {
        notice("link", "");
        this.edits.note({ document, text: this.text, estimates: this.estimates });
        this.keep();
        page.want(document, since);
      },
      stateOf: (document) => this.stateOf(document),
      drawn: () => {
        page.drawn?.();
        this.drawProfiles(this.profiles);
      },
      measured: (body) => this.measured.open(body),
    });
    this.edits = new Edits({ document: start.document, text: start.text, estimates: null }, () => {
      byId("undo").disabled = !this.edits.can(-1);
      byId("redo").disabled = !this.edits.can(1);
    });
    this.wire();
  }

  get document() {
    return this.form.document;
  }

  /** Begin with the document in the address, if there is one. */
  async begin() {
    if (await this.fromLink(history.state?.estimates)) {
      this.edits.restart({ document: this.document, text: this.text, estimates: this.estimates });
    } else this.page.want(this.document);
  }

  /** Keep the document in the address. */
  keep() {
    this.address.keep(this.document, this.pins, this.text, this.looked());
  }

  /** What is kept beside the document, but is no part of it. */
  looked() {
    return { ...this.page.looked?.(), estimates: this.estimates };
  }

  /** Put the document into the address now. */
  put() {
    return this.address.put(this.document, this.pins, this.text, this.looked());
  }

  /** Draw the profiles of the bodies, beside the pinned ones. @param {any} profiles */
  drawProfiles(profiles) {
    this.profiles = profiles;
    drawProfiles(Object.keys(this.page.bodies), profiles, this.pins[0]?.answer.profiles, pinnedAs(this.pins));
  }

  /** Ask what the form of a document takes from its geometry; null if there is no answer. @param {object} document */
  async stateOf(document) {
    try {
      const response = await post(`${this.page.at}form`, { document });
      return response.ok ? await response.json() : null;
    } catch {
      return null;
    }
  }

  /** Begin with another document. @param {any} beginning with the text of its file, and what in it is estimated */
  async another(beginning) {
    this.page.begun?.();
    await this.show(beginning);
  }

  /** @param {{document: object, text: string, estimates?: import("./types.js").Estimates | null}} beginning */
  async show({ document, text, estimates = null }) {
    this.text = text;
    this.estimates = this.form.estimates = estimates;
    return await this.form.open(document);
  }

  /** @param {-1 | 1} by */
  async step(by) {
    const state = this.edits.step(by);
    if (state) await this.show(state);
  }

  /** Undo and redo, except in text fields, which have their own undo. @param {KeyboardEvent} event */
  pressed(event) {
    const key = event.key.toLowerCase();
    if (!(event.ctrlKey || event.metaKey) || (key !== "z" && key !== "y")) return;
    if (/** @type {HTMLElement} */ (event.target).matches(WRITTEN_IN)) return;
    event.preventDefault();
    void this.step(key === "y" || event.shiftKey ? 1 : -1);
  }

  /** Show what is pinned. @param {Pin[]} pins */
  setPins(pins) {
    this.pins = pins;
    byId("pin").disabled = pins.length >= MOST_PINS;
    byId("pin").title = byId("pin").disabled ? `${MOST_PINS} are pinned: unpin one first` : "";
    this.page.pin(pins);
    this.drawProfiles(this.profiles);
    this.keep();
  }

  /** @param {Result} result @param {string} name @returns {Pin} */
  pinOf(result, name) {
    const pin = {
      ...result,
      ...{ id: (this.count += 1), name },
      rename: (other) => {
        pin.name = other;
        this.keep();
      },
      open: () => void this.form.open(pin.document),
      remove: () => {
        this.setPins(this.pins.filter((other) => other !== pin));
        /** @type {HTMLElement} */ (document.querySelector("#pins button") ?? byId("pin")).focus();
      },
    };
    return pin;
  }

  /** What a result is pinned as: its title, or what differs from the one that has that already. @param {Result} result */
  nameOf({ document, answer: { title } }) {
    const namesake = this.pins.find(({ answer }) => answer.title === title);
    const words = (path) => {
      const control = /** @type {any} */ (this.form.host.elements.namedItem(path));
      return control ? `${nameOf(control)} ${control.value} ${unitOf(control)}`.trim() : path;
    };
    const changes = namesake ? differences(namesake.document, document).slice(0, CHANGES).map(words) : [];
    return changes.join("; ") || title || this.page.what;
  }

  /** Solve and pin documents, in place of those among them that are pinned. @param {import("./link.js").Named[]} pinned */
  async pinAll(pinned) {
    const pins = [];
    for (const { document, name } of pinned) {
      try {
        const answer = await this.page.solve(document);
        if (answer.ok) pins.push(this.pinOf({ document, answer }, name || answer.title || this.page.what));
        else notice("link", `A pinned ${this.page.what} in the link cannot be shown: ${answer.mistakes[0]?.sentence}`);
      } catch {
        notice("link", AWAY);
      }
    }
    this.setPins([...pins, ...this.pins.filter((pin) => !pinned.includes(pin))]);
  }

  async copyLink() {
    const link = await this.put();
    const button = byId("share");
    try {
      await navigator.clipboard.writeText(link);
      button.textContent = "Copied";
    } catch {
      button.textContent = "Copy from the address bar"; // no access to the clipboard
    }
    window.setTimeout(() => (button.textContent = "Copy link"), 2000);
  }

  /** @param {string} name */
  async download(name) {
    byId("downloads").hidePopover();
    notice("download", `${name} is being written …`);
    try {
      const mistakes = await saved(`${this.page.at}download/${name}`, { document: this.document, text: this.text });
      if (mistakes.length) showMistakes(mistakes);
    } catch {
      notice("program", AWAY); // until the next answer
    }
    notice("download", "");
  }

  /** @param {File} file */
  async openFile(file) {
    try {
      const { document, text, mistakes } = await opened(file, this.start.limits.document_bytes, this.page.what);
      if (!document) showMistakes(mistakes);
      else await this.another({ document, text });
    } catch {
      notice("program", AWAY);
    }
  }

  /** Start from a template. @param {string} name */
  async startFrom(name) {
    byId("templates").hidePopover();
    try {
      await this.another(await (await fetch(`${this.page.at}template/${name}`)).json());
    } catch {
      notice("program", AWAY);
    }
  }

  /** Show everything in the units that are chosen now. */
  async reread() {
    const latest = this.page.latest();
    if (latest && !byId("mistakes").hidden) {
      const answer = await this.page.solve(latest.document).catch(() => null);
      if (answer?.ok) this.page.again({ ...latest, answer });
    }
    await this.form.open(this.document);
    this.page.renamed?.();
    if (this.pins.length) await this.pinAll(this.pins);
  }

  /** Show the document in the address, if it holds one. @param {import("./types.js").Estimates} [estimates] */
  async fromLink(estimates) {
    try {
      const link = await shared(window.location.hash);
      if (!link) return false;
      this.pins = [];
      void this.pinAll(link.pinned);
      return await this.show({ ...link, estimates });
    } catch (error) {
      notice("link", /** @type {Error} */ (error).message);
      return false;
    }
  }

  wire() {
    const pressed = (selector, act) => {
      for (const button of /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll(selector)))
        button.addEventListener("click", () => void act(button));
    };
    /** @type {HTMLElement} */ (document.querySelector(".skip")).addEventListener("click", (event) => {
      event.preventDefault(); // the fragment of the address holds the document
      byId("results").focus();
    });
    pressed("#undo", () => this.step(-1));
    pressed("#redo", () => this.step(1));
    pressed("#pin", () => {
      const latest = this.page.latest();
      if (latest) this.setPins([...this.pins, this.pinOf(latest, this.nameOf(latest))]);
    });
    pressed("#share", () => this.copyLink());
    pressed("#open", () => byId("open-file").click());
    byId("open-file").addEventListener("change", ({ target }) => {
      if (target.files[0]) void this.openFile(target.files[0]);
      target.value = ""; // the same file may be opened again
    });
    pressed("[data-download]", (button) => this.download(button.dataset.download));
    pressed("[data-template]", (button) => this.startFrom(button.dataset.template));
    document.addEventListener("keydown", (event) => this.pressed(event));
    watchUnits(() => void this.reread());
    watchDrops({
      what: this.page.what,
      bodies: this.page.bodies,
      isTable: (path) => this.form.isTable(path),
      open: (file) => void this.openFile(file),
      table: (path, table) => this.form.tabulate(path, table),
      measured: (event, body) => this.measured.dropped(event, body),
      refuse: (mistake) => showMistakes([mistake]),
    });
    window.addEventListener("hashchange", () => void this.fromLink());
    if (window.matchMedia("(max-width: 900px)").matches) byId("editor").open = false;
  }
}
