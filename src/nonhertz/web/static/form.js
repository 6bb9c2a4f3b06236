// The form and the case it represents. The program writes the form; here its fields are read, and a new form is
// requested when an edit changes which fields there are.

import { byId } from "./elements.js";
import { convert, follow, place, said, settle, slid, sliderOf, unitsOf } from "./fields.js";
import { columns } from "./numbers.js";
import { outer, valueAt, withValue } from "./paths.js";

/** @typedef {import("./fields.js").Control} Control */

const REST = 300; // ms without an edit after which sliders get the ranges of another geometry
const NO_GEOMETRY = /^(title|load|solver|life|report)\b/;

export class Form {
  /**
   * @param {object} document
   * @param {{
   *   edited: (document: object, since: number) => void,
   *   fresh: (document: object) => Promise<string | null>,
   *   drawn: () => void,
   * }} listener
   */
  constructor(document, listener) {
    this.document = document;
    this.listener = listener;
    this.asked = 0;
    /** @type {object | null} */
    this.before = null; // the case that the form is of, while that of another is awaited
    this.rest = 0;
    this.reshaped = false; // whether sliders have the ranges of another geometry
    this.form = /** @type {HTMLFormElement} */ (byId("case"));
    this.form.addEventListener("submit", (event) => event.preventDefault());
    this.form.addEventListener("input", (event) => this.input(event));
    this.form.addEventListener("change", (event) => this.change(event));
    this.form.addEventListener("click", (event) => this.click(event));
    this.form.addEventListener("paste", (event) => this.paste(event));
    this.wire();
  }

  /** @param {Event} event */
  input(event) {
    const target = /** @type {Control} */ (event.target);
    if (target instanceof HTMLInputElement && target.type === "range") {
      const control = /** @type {Control} */ (document.getElementById(target.dataset.for ?? ""));
      control.value = slid(target, control);
      follow(target, control);
      this.take(control, event.timeStamp);
    } else if (target instanceof HTMLSelectElement && target.dataset.unitOf !== undefined) {
      const control = /** @type {Control} */ (document.getElementById(target.dataset.unitOf));
      convert(target, control);
      if (control.value.trim() !== "") this.take(control, event.timeStamp);
      this.followed(control);
    } else if (target instanceof HTMLSelectElement && target.dataset.structure !== undefined) {
      void this.open(restructured(this.document, target), event.timeStamp);
    } else if (target.dataset.kind !== undefined) {
      this.followed(target);
      this.take(target, event.timeStamp);
    }
  }

  /** A number that was written with its unit is split when its field is left. @param {Event} event */
  change(event) {
    const target = /** @type {Control} */ (event.target);
    const control = /** @type {Control} */ (document.getElementById(target.dataset.for ?? "") ?? target);
    this.reshaped ||= Boolean(control.name) && !NO_GEOMETRY.test(control.name);
    if (this.reshaped) this.refreshSoon();
    if (target.dataset.kind === undefined || !unitsOf(target)) return;
    settle(target);
    this.followed(target);
  }

  refreshSoon() {
    window.clearTimeout(this.rest);
    this.rest = window.setTimeout(() => void this.refresh(), REST);
  }

  /** Ask for the same form again, whose ranges are those of the geometry as it is now, once that has no mistakes. */
  async refresh() {
    if (!byId("mistakes").hidden) {
      this.refreshSoon();
      return;
    }
    const [document, number] = [this.document, this.asked];
    const html = await this.listener.fresh(document);
    if (html !== null && document === this.document && number === this.asked) this.put(document, html);
  }

  /** @param {Control} control */
  followed(control) {
    const slider = sliderOf(control);
    if (slider) follow(slider, control);
  }

  /** @param {Control} control @param {number} since */
  take(control, since) {
    if (this.reshaped) this.refreshSoon();
    const changed = withoutEmpty(withValue(this.document, control.name, said(control)), control);
    if (this.before) return void this.open(changed, since); // an edit goes into the case that is to come
    this.document = changed;
    this.listener.edited(changed, since);
  }

  /**
   * A column that is pasted into a list is one entry a row; two columns pasted into points are places and reliefs.
   * @param {ClipboardEvent} event
   */
  paste(event) {
    const target = /** @type {Control} */ (event.target);
    if (target.dataset.kind !== "list") return;
    const table = columns(event.clipboardData?.getData("text/plain") ?? "");
    if (!table) return; // a single row goes in as it is
    event.preventDefault();
    const within = outer(target.name);
    if (table.length === 2 && this.isTable(within)) this.tabulate(within, table, event.timeStamp);
    else if (table.length === 1) void this.open(withValue(this.document, target.name, table[0]), event.timeStamp);
  }

  /** Whether there is a profile of points at a path. @param {string} path */
  isTable(path) {
    return valueAt(this.document, path)?.kind === "tabulated";
  }

  /**
   * Replace the points of a profile.
   * @param {string} path
   * @param {number[][]} table places and reliefs
   * @param {number} [since]
   */
  tabulate(path, [y, relief], since) {
    void this.open(withValue(withValue(this.document, `${path}.y`, y), `${path}.relief`, relief), since);
  }

  /** @param {MouseEvent} event */
  click(event) {
    const button = /** @type {HTMLElement} */ (event.target).closest("button[data-action]");
    if (!(button instanceof HTMLButtonElement)) return;
    const path = button.dataset.path ?? "";
    if (button.dataset.action === "remove") void this.open(withValue(this.document, path, undefined), event.timeStamp);
    if (button.dataset.action === "add")
      void this.open(lengthened(this.document, path, addition(button)), event.timeStamp);
  }

  /** Show another case, or this one with other fields. @param {object} other */
  async open(other, since = performance.now()) {
    const number = (this.asked += 1);
    this.before ??= this.document;
    this.document = other;
    const html = await this.listener.fresh(other);
    if (number !== this.asked) return false; // a later request wins
    if (html === null) this.document = this.before;
    this.before = null;
    if (html === null) return false;
    this.put(other, html);
    this.listener.edited(this.document, since);
    return true;
  }

  /** Replace this form by another, with the same sections unfolded and the focus where it was. */
  put(document, html) {
    const [unfolded, focus, marked] = [this.unfolded(), focused(this.form), selection()];
    this.document = document;
    this.reshaped = false;
    this.form.innerHTML = html; // written by the program, which escapes whatever comes from a case
    for (const details of this.form.querySelectorAll("details"))
      details.open = unfolded.has(details.dataset.details);
    this.wire();
    const again = focus.map((selector) => this.form.querySelector(selector)).find((found) => found);
    if (again instanceof HTMLElement) again.focus({ preventScroll: true });
    if (again instanceof HTMLInputElement && again.type === "text" && marked) again.setSelectionRange(...marked);
  }

  /** The groups whose further fields are shown. */
  unfolded() {
    const open = /** @type {NodeListOf<HTMLElement>} */ (this.form.querySelectorAll("details[open]"));
    return new Set([...open].map(({ dataset }) => dataset.details));
  }

  wire() {
    const units = /** @type {NodeListOf<HTMLSelectElement>} */ (this.form.querySelectorAll("select[data-unit-of]"));
    for (const each of units) each.dataset.before = each.value;
    for (const slider of /** @type {NodeListOf<HTMLInputElement>} */ (
      this.form.querySelectorAll('input[type="range"]')
    )) {
      slider.tabIndex = 0;
      place(slider, Number(slider.dataset.start)); // where its field is empty
      const control = document.getElementById(slider.dataset.for ?? "");
      if (control) follow(slider, /** @type {Control} */ (control));
    }
    this.listener.drawn();
  }
}

/** The case without the tables around a field that may be left out and hold nothing any more. */
function withoutEmpty(document, control) {
  let found = document;
  const outwards = (group) => group?.parentElement?.closest("fieldset");
  for (let group = control.closest("fieldset"); group?.matches("[data-optional]"); group = outwards(group)) {
    const table = valueAt(found, group.dataset.group);
    if (!table || Object.keys(table).length) break;
    found = withValue(found, group.dataset.group, undefined);
  }
  return found;
}

/** The case after a choice that changes which keys there are; the option lists its edits. */
function restructured(document, select) {
  const option = select.selectedOptions[0];
  const edits = option.dataset.edits ? JSON.parse(option.dataset.edits) : [[select.name, said(select) ?? null]];
  return edits.reduce((changed, [path, value]) => withValue(changed, path, value ?? undefined), document);
}

/** The case with one more entry in a list; a single table in place of a list becomes its first entry. */
function lengthened(document, path, entry) {
  const present = valueAt(document, path);
  const list = present === undefined ? [] : Array.isArray(present) ? present : [present];
  return withValue(document, path, [...list, entry]);
}

/** What a button adds: its own value, or that of the choice beside it. */
function addition(button) {
  const choice = button.parentElement?.querySelector("select[data-additions]");
  return JSON.parse(button.dataset.value ?? choice?.selectedOptions[0].dataset.value ?? "{}");
}

/** What is marked in the field with the focus, from where to where. @returns {[number, number] | null} */
function selection() {
  const active = document.activeElement;
  const isText = active instanceof HTMLInputElement && active.type === "text";
  return isText ? [active.selectionStart ?? 0, active.selectionEnd ?? 0] : null;
}

/** Selectors, best first, that find the focused control again in a new form; none if the focus is elsewhere. */
function focused(form) {
  const active = document.activeElement;
  if (!(active instanceof HTMLElement) || !form.contains(active)) return [];
  if (active.id) return [`#${CSS.escape(active.id)}`];
  if (active.dataset.for) return [`[data-for="${CSS.escape(active.dataset.for)}"]`];
  const { action, path } = active.dataset;
  if (!action || !path) return [];
  // A removed entry is gone with its button; the button to add one in its place is the next best.
  const button = (what, place) => `[data-action="${what}"][data-path="${CSS.escape(place)}"]`;
  return [button(action, path), button("add", outer(path))];
}
