// The form of a document, drawn from the JSON schema of its file.
// Only the document is stored: an edit makes another document, from which the form is drawn again, and the library
// changes only what differs on the page, so that focus and folds stay. The ranges of sliders follow from the geometry
// and are requested when the slider rests.

import { byId } from "./elements.js";
import { choicesOf, legible, nameOf, placeOf, rangeFor, toValue, shownIn } from "./fields.js";
import { slid, textAt, textOf, valueIn, writtenIn } from "./fields.js";
import { marked, whenMarked } from "./mistakes.js";
import { columns, split } from "./numbers.js";
import { outer, pathOf, valueAt, withValue } from "./paths.js";
import { html, render, useRef, useState } from "./preact.js";
import { bodyNamed } from "./profiles.js";
import { Schema } from "./schema.js";
import { unitsCode } from "./units.js";
import { FIRST, FOLDS, SECTIONS, labelOf } from "./words.js";

/** @typedef {[string, any][]} Edits paths and their values, undefined for a key that is left out */
/** @typedef {{label: string, edits: Edits}} Option */
/** @typedef {(string | number)[]} Place keys and positions from 1 */

const REST = 300; // ms without an edit after which sliders get the ranges of another geometry
const NO_GEOMETRY = /^(title|load|solver|life|report)\b/;
const NUMERIC = ["quantity", "integer-or-word"];
const MOSTLY_NUMBERS = ["bore"]; // a number in the form, unless a file has a table in its place
const RINGS = ["inner", "outer"]; // whose diameter is that of a raceway, one number
const OPEN = ["fit", "life", "pair", "lubrication", "spectrum"]; // unfolded at first where a file has them
const LONG = { numbers: 24, letters: 1000, tables: 40 }; // beyond which they are not shown

export class Form {
  /**
   * @param {object} document
   * @param {{schema: any, lists: any, state: any}} start
   * @param {{
   *   bodies: Record<string, string>,
   *   edited: (document: object, since: number) => void,
   *   stateOf: (document: object) => Promise<any>,
   *   drawn: () => void,
   *   measured: (body: string) => void,
   * }} page
   * The paths of its bodies by name; what follows an edit; what asks the program for the ranges of a document; what
   * follows when fields come or go; what opens the dialog for a measured profile.
   */
  constructor(document, start, page) {
    this.document = document;
    this.page = page;
    this.schema = new Schema(start.schema, start.lists);
    this.state = start.state;
    /** @type {import("./types.js").Estimates | null} */
    this.estimates = null;
    this.rest = 0;
    /** @type {Set<string>} paths of tables that are left out where all of their keys are */
    this.optional = new Set();
    this.host = /** @type {HTMLFormElement} */ (byId("case"));
    this.host.addEventListener("submit", (event) => event.preventDefault());
    this.host.addEventListener("paste", (event) => this.paste(event));
    whenMarked(() => this.draw());
    this.draw();
    this.page.drawn();
  }

  draw() {
    // Fields remember the unit that was chosen in them: not beyond a change of all units.
    render(html`<${Whole} key=${unitsCode()} form=${this} document=${this.document} />`, this.host);
  }

  /** Show another document. @param {object} document @param {number} [since] */
  async open(document, since = performance.now()) {
    this.put(document, since);
    await this.refresh();
    return true;
  }

  /** @param {object} document @param {number} since */
  put(document, since) {
    this.document = document;
    this.draw();
    this.page.drawn();
    this.page.edited(document, since);
  }

  /** Make edits that change which fields there are. @param {Edits} edits @param {number} since */
  restructure(edits, since) {
    this.put(this.changed(edits), since);
    this.refreshSoon();
  }

  /** Change a value. @param {string} path @param {any} value @param {number} since */
  edit(path, value, since) {
    this.document = this.changed([[path, value]]);
    this.draw();
    this.page.edited(this.document, since);
    if (!NO_GEOMETRY.test(path)) this.refreshSoon();
  }

  /** The document after edits, without tables that may be left out and hold nothing any more. @param {Edits} edits */
  changed(edits) {
    let document = this.document;
    for (const [path, value] of edits) {
      document = withValue(document, path, value);
      if (value !== undefined) continue;
      for (let within = outer(path); this.optional.has(within); within = outer(within)) {
        if (Object.keys(valueAt(document, within) ?? {}).length) break;
        document = withValue(document, within, undefined);
      }
    }
    return document;
  }

  refreshSoon() {
    window.clearTimeout(this.rest);
    this.rest = window.setTimeout(() => void (byId("mistakes").hidden ? this.refresh() : this.refreshSoon()), REST);
  }

  /** Ask what sliders span now. */
  async refresh() {
    const document = this.document;
    const state = await this.page.stateOf(document);
    if (!state || document !== this.document) return;
    this.state = state;
    this.draw();
    this.page.drawn();
  }

  /** Whether the value at a path is still the one that was estimated. @param {string} path */
  isEstimate(path) {
    const { [path]: value } = this.estimates?.values ?? {};
    return value !== undefined && JSON.stringify(value) === JSON.stringify(valueAt(this.document, path));
  }

  /** The range of the slider at a place, if there is one. @param {Place} place */
  range(place) {
    const body = Object.keys(this.state.bodies).find((path) => pathOf(place).startsWith(`${path}.`));
    const of = { ...this.state.ranges, ...(body && this.state.bodies[body].ranges) };
    const [within, last] = ["", ...place].slice(-2);
    return of[`${within}.${last}`] ?? (`${within}.${last}` in of ? null : of[last]);
  }

  /** What finds the ranges of keys that are to come into a table. @param {Place} place */
  rangesIn(place) {
    return (at) => this.range([...place, ...at.filter(Boolean)]);
  }

  /**
   * A column that is pasted into a list is one entry a row; two columns pasted into points are places and reliefs.
   * @param {ClipboardEvent} event
   */
  paste(event) {
    const target = /** @type {HTMLInputElement} */ (event.target);
    const table = target.dataset.kind === "list" && columns(event.clipboardData?.getData("text/plain") ?? "");
    if (!table) return; // a single row goes in as it is
    event.preventDefault();
    const within = outer(target.name);
    if (table.length === 2 && this.isTable(within)) this.tabulate(within, table, event.timeStamp);
    else if (table.length === 1) this.restructure([[target.name, table[0]]], event.timeStamp);
  }

  /** Whether there is a profile of points at a path. @param {string} path */
  isTable(path) {
    return valueAt(this.document, path)?.kind === "tabulated";
  }

  /** Replace the points of a profile. @param {string} path @param {number[][]} table places and reliefs */
  tabulate(path, [y, relief], since = performance.now()) {
    this.restructure(
      [
        [`${path}.y`, y],
        [`${path}.relief`, relief],
      ],
      since,
    );
  }

  /** Remove an entry; the focus goes to the button in its place. @param {string} path @param {number} since */
  remove(path, since) {
    this.restructure([[path, undefined]], since);
    const button = (what, at) => this.host.querySelector(`[data-action="${what}"][data-path="${CSS.escape(at)}"]`);
    const next = button("remove", path) ?? button("add", outer(path));
    if (next instanceof HTMLElement) next.focus({ preventScroll: true });
  }
}

/** @param {{form: Form, document: any}} props */
function Whole({ form, document }) {
  return html`<${Estimates} form=${form} /><${Members} ...${{ form, table: form.schema.whole, value: document, place: [] }} />`;
}

/** What was estimated, as long as any of it is in the document. @param {{form: Form}} props */
function Estimates({ form }) {
  const { values, sentences } = form.estimates ?? { values: {}, sentences: [] };
  if (!Object.keys(values).some((path) => form.isEstimate(path))) return null;
  return html`<details class="estimates" open><summary>Estimated from catalogue data</summary>
    <p>Fields with a dashed frame are estimates: replace what you know. Load and speed are examples.</p>
    <ul>${sentences.map((sentence) => html`<li>${sentence}</li>`)}</ul></details>`;
}

/** A table as it was drawn before, if neither it nor geometry or mistakes are others: a drag changes one value. */
function Members(props) {
  const before = useRef(/** @type {any} */ ({}));
  const { value, table, form } = props;
  const of = [value, table, form.state, form.document.bearing?.kind, marked];
  if (of.some((dependency, at) => dependency !== before.current.of?.[at])) before.current = { of, shown: members(props) };
  return before.current.shown;
}

/**
 * A table: its kind, its keys, those that most files leave out below headings, and what is unknown as JSON.
 * @param {{form: Form, table: any, value: any, place: Place, others?: any[]}} props `others` may stand in its place
 */
function members({ form, table, value, place, others = [] }) {
  const { schema } = form;
  const keys = schema.keys(table, value);
  const hidden = hiddenBeside(form, table, value, place);
  const order = [...FIRST, ...keys];
  const names = schema.shown(table, value, keys).filter((name) => name in value || !hidden.includes(name));
  names.sort((one, other) => order.indexOf(one) - order.indexOf(other));
  const always = [...schema.needed(table), ...(table["x-pairs"] ?? []).flat()];
  const folds = FOLDS.map(([heading, all, only]) => {
    const here = !only || only === lastOf(place) ? all : [];
    const some = names.filter((name) => here.includes(name) && !always.includes(name));
    const folded = some.length < 2 && all.length > 1 ? [] : some; // a heading for a single key would hide it for nothing
    const few = 2 * folded.length < all.length;
    return { folded, heading: few ? folded.map((name) => labelOf([...place, name])).join(", ") : heading };
  });
  const unfolded = names.filter((name) => !folds.some(({ folded }) => folded.includes(name)));
  const known = [...keys, ...(table.properties.kind || !place.length ? ["kind", "format"] : [])];
  const stray = Object.keys(value).filter((name) => !known.includes(name));
  const entry = (name) => ({ form, place: [...place, name], value: value[name] });
  const member = (name) => html`<${Member} key=${name} ...${{ ...entry(name), table, within: value }} />`;
  return html`
    ${table.properties.kind && html`<${Kind} ...${{ form, table, value, place, others }} />`} ${unfolded.map(member)}
    ${stray.map((name) => html`<${Stray} key=${`?${name}`} ...${entry(name)} />`)}
    ${folds.map(({ heading, folded }, number) => {
      const open = folded.some((name) => OPEN.includes(name) && name in value);
      const props = { heading, open, section: !place.length, name: [...place, folded[0]].join("/") };
      return folded.length > 0 && html`<${Fold} key=${`/${number}`} ...${props}>${folded.map(member)}<//>`;
    })}`;
}

/** The keys that have no meaning beside others, unless they are given. @returns {string[]} */
function hiddenBeside(form, table, value, place) {
  // Washers are flat, without seats that would press on a raceway.
  const flat = form.document.bearing?.kind === "thrust" && (!place.length || RINGS.includes(String(place[0])));
  // Only whole rollers are hollow; of a body with mistakes it is not known what it is.
  const whole = (value.depth ?? (form.state.bodies[pathOf(place)]?.depth || "finite")) === "finite";
  return [...(flat ? ["fit", "diameter"] : []), ...("profile" in table.properties && !whole ? ["bore"] : [])];
}

/** Fields below a heading. */
function Fold({ heading, name, section, open, children }) {
  const opened = useRef(open).current; // at first: whether it is folded is for the reader to choose
  return html`<details class=${section ? "section" : "more"} open=${opened} data-details=${name}>
    <summary>${heading}</summary>${children}</details>`;
}

/** @param {{value: string, options: [string, string, object?][], [attribute: string]: any}} props */
function Select({ value, options, ...attributes }) {
  const shown = options.map(([word, label, more]) => html`<option value=${word} ...${more}>${label}</option>`);
  return html`<select ...${attributes} value=${value}>${shown}</select>`;
}

/** A choice between edits. @param {{form: Form, options: Option[], [attribute: string]: any}} props */
function Choice({ form, options, words, ...attributes }) {
  const take = ({ target, timeStamp }) =>
    form.restructure(options.find(({ label }) => label === target.value)?.edits ?? [], timeStamp);
  const shown = [...(words ?? []), ...options.map(({ label }) => [label, label])];
  return html`<${Select} ...${attributes} options=${shown} onInput=${take} />`;
}

/** The choice of the kind of a table, on which its other keys depend. */
function Kind({ form, table, value, place, others }) {
  const { schema } = form;
  const [path, range, at] = [pathOf(place), form.rangesIn(place), [...place, "kind"]];
  const kinds = Object.keys(table["x-kinds"] ?? {});
  const options = kinds.length
    ? kinds.map((kind) => ({ label: kind, edits: schema.ofKind(table, value, kind, path, range) }))
    : schema.ofNumbers(others).map((other) => ({
        label: other.properties.kind.const,
        edits: [[path, schema.fresh(other, range, "", value)]],
      }));
  const { kind } = value;
  const help = table.properties.kind.description ?? "kind of profile";
  if (kind !== undefined && textOf("choice", kind) === null)
    return html`<${Text} ...${{ form, place: at, kind: "json", value: kind, help }} />`;
  const missing = "diameter" in table.properties ? "by its dimensions" : "not given";
  const known = options.some(({ label }) => label === kind);
  const words = kind === undefined ? [["", missing]] : known ? [] : [[kind, kind]];
  const props = { ...control(at), form, options, words, value: kind ?? "" };
  return html`<${Row} place=${at} help=${help}><${Choice} ...${props} data-kind="choice" /><//>`;
}

/** One key of a table, whatever it holds. */
function Member({ form, table, within, place, value }) {
  const { schema } = form;
  const name = String(lastOf(place));
  const all = schema.key(table.properties[name]);
  const holds = { ...all, words: table["x-kinds"]?.[within.kind]?.words[name] ?? all.words };
  const usual = name === "depth" ? form.state.bodies[outer(pathOf(place))]?.depth : holds.usual;
  const props = { form, place, holds, value, usual, within, swap: alternatives(form, table, place) };
  if (holds.names) return html`<${OneOrTwo} ...${props} />`;
  if (holds.entries) return html`<${List} ...${props} />`;
  if (holds.kind === "table" || (holds.tables.length && MOSTLY_NUMBERS.includes(name) && isTable(value)))
    return html`<${Part} ...${props} optional=${!schema.needed(table).includes(name)} />`;
  const alone = MOSTLY_NUMBERS.includes(name) || (name === "diameter" && RINGS.includes(String(place[0])));
  if (holds.tables.length && (!alone || isTable(value))) return html`<${ValueOrTable} ...${props} />`;
  return html`<${Value} ...${props} />`;
}

/** Of a key that is given in place of another, both, with the one that is shown first. @returns {Option[]} */
function alternatives(form, table, place) {
  const [name, around] = [lastOf(place), place.slice(0, -1)];
  const pair = (table["x-pairs"] ?? []).find((keys) => keys.includes(name)) ?? [];
  const sizes = (pair.includes("drop") && form.state.bodies[pathOf(around.slice(0, -2))]?.sizes) || {};
  const start = (key) => sizes[key] ?? form.schema.start(key, table.properties[key], form.rangesIn(around));
  const without = (key) =>
    pair.filter((other) => other !== key).map((other) => [pathOf([...around, other]), undefined]);
  return [...pair]
    .sort((one, other) => Number(other === name) - Number(one === name))
    .map((key) => {
      const at = [...around, key];
      return { label: labelOf(at), edits: [...without(key), [pathOf(at), start(key)]] };
    });
}

/** A table; one that needs some of its keys is given as a whole, or left out by a choice. */
function Part({ form, place, holds, value, optional }) {
  const [path, table] = [pathOf(place), holds.tables[0]];
  if (value !== undefined && !isTable(value)) return html`<${Stray} ...${{ form, place, value, help: holds.help }} />`;
  const needs = optional && form.schema.needed(table).length > 0;
  if (optional) form.optional.add(path);
  const made = needs && form.schema.fresh(table, form.rangesIn(place.slice(0, -1)), String(lastOf(place)));
  const options = [
    ["none", undefined],
    ["given", made],
  ].map(([label, edit]) => ({ label, edits: [[path, edit]] }));
  const choice = { form, options, id: idOf(path), value: value ? "given" : "none", "data-structure": true };
  const row = needs && html`<${Row} place=${place} help=${holds.help} style="switch"><${Choice} ...${choice} /><//>`;
  if (needs && value === undefined) return row;
  return html`<${Group} place=${place} help=${holds.help} quiet=${needs || SECTIONS.includes(path)}>
    ${row}<${Members} ...${{ form, table, value: value ?? {}, place }} /><//>`;
}

/** A key with one value, or a table of several. */
function ValueOrTable({ form, place, holds, value, ...more }) {
  const [name, path, table, label] = [String(lastOf(place)), pathOf(place), holds.tables[0], labelOf(place)];
  const needed = form.schema.needed(table);
  const start = (key) => form.schema.start(key, table.properties[key], form.rangesIn(place));
  const several = Object.fromEntries(needed.map((key) => [key, start(key)]));
  const inner = isTable(value) ? value[name] : undefined;
  const usual = NUMERIC.includes(holds.kind) ? (form.range(place)?.start ?? 1) : holds.words[0];
  const simple = Array.isArray(inner) && inner.length ? inner[inner.length >> 1] : usual;
  if (!isTable(value) && value !== undefined && name in several) several[name] = several[name].map(() => value);
  const shapes = [
    { label, edits: [[path, simple]] },
    { label: `${label} by ${needed.map((key) => labelOf([key])).join(" and ")}`, edits: [[path, several]] },
  ];
  if (!isTable(value)) return html`<${Value} ...${{ ...more, form, place, holds, value, swap: shapes }} />`;
  return html`<${Group} place=${place} help=${holds.help} quiet>
    <${Shape} ...${{ form, place, options: shapes.reverse() }} />
    <${Members} ...${{ form, table, value, place }} /><//>`;
}

/** A key with one value, or one for each of two. */
function OneOrTwo({ form, place, holds, value, within, swap, usual }) {
  const [path, label] = [pathOf(place), labelOf(place)];
  const isPair = Array.isArray(value) && value.length === 2;
  const first = isPair ? value[holds.single ?? 0] : (value ?? usual ?? 0);
  const both = holds.names.map((_, number) => (holds.single === null || holds.single === number ? first : 0));
  const shapes = [
    { label, edits: [[path, first]] },
    {
      label: `${label}, ${holds.single === null ? "each end" : holds.names.join(" and ")}`,
      edits: [[path, isPair ? value : both]],
    },
  ];
  const alone = lastOf(place) === "side_faces" && !("length" in within);
  const options = [...(isPair ? shapes.reverse() : shapes), ...swap.slice(1)];
  if (!isPair) return html`<${Value} ...${{ form, place, holds, value, usual, swap: alone ? [] : options }} />`;
  const range = form.range(place);
  const one = { form, holds, range: range && { ...range, low: -range.high } };
  const entry = (item, at) =>
    html`<${Value} key=${at} ...${{ ...one, place: [...place, at + 1], value: item, label: holds.names[at] }} />`;
  return html`<${Group} place=${place} help=${holds.help} quiet>
    <${Shape} ...${{ form, place, options }} />${value.map(entry)}<//>`;
}

/** A choice that is no key of the document. @param {{form: Form, options: Option[], place: Place}} props */
function Shape({ form, options, place }) {
  const id = `${idOf(pathOf(place))}-shape`;
  return html`<div class="field switch"><label class="unseen" for=${id}>${labelOf(place)}, as</label>
    <${Swap} ...${{ form, options, id }} /></div>`;
}

/** A label that is a choice. @param {{form: Form, options: Option[], [attribute: string]: any}} props */
function Swap({ form, options, ...attributes }) {
  const sorted = [...options].sort((one, other) => (one.label < other.label ? -1 : 1));
  const props = { ...attributes, form, options: sorted, value: options[0].label, "data-structure": true };
  return html`<${Choice} class="swap" ...${props} />`;
}

/** A list of tables, or a single table in place of a list of one. */
function List({ form, place, holds, value }) {
  const [path, tables] = [pathOf(place), holds.entries];
  const entry = (item, at) => html`<${Entry} key=${lastOf(at)} ...${{ form, tables, value: item, place: at }} />`;
  if (isTable(value)) return entry(value, place);
  if (value !== undefined && !Array.isArray(value))
    return html`<${Stray} ...${{ form, place, value, help: holds.help }} />`;
  if (value?.length > LONG.tables) return html`<${Hidden} ...${{ place, value, what: "entries" }} />`;
  const body = Object.entries(form.page.bodies).find(([, of]) => path === `${of}.profile`)?.[0];
  const figure = html`<figure data-figure="profile-${body}" class="profile-figure">
    <figcaption></figcaption><div class="drawing"></div></figure>`;
  return html`<${Group} place=${place} help=${holds.help}>${body && figure}
    ${(value ?? []).map((item, number) => entry(item, [...place, number + 1]))}
    <${Add} ...${{ form, place, tables: form.schema.ofNumbers(tables), value, body }} /><//>`;
}

/** What can be added to a list. */
function Add({ form, place, tables, value = [], body }) {
  const [path, label, chosen] = [pathOf(place), labelOf(place), useRef(0)];
  const titles = tables.map(({ properties, title }) => properties.kind?.const ?? labelOf([title.toLowerCase()]));
  const choose = ({ target }) => (chosen.current = target.selectedIndex);
  const kinds = { options: titles.map((title) => [title, title]), onInput: choose, "data-additions": path };
  const fresh = () => form.schema.fresh(tables[chosen.current], form.rangesIn(place));
  const add = ({ timeStamp }) => form.restructure([[path, [...value, fresh()]]], timeStamp);
  const measured = () => form.page.measured(body);
  return html`<div class="add">
    ${tables.length > 1 && html`<${Select} ...${kinds} aria-label="kind of ${label} to add" />`}
    <button type="button" data-action="add" data-path=${path} onClick=${add}>
      Add ${tables.length > 1 ? label : "row"}</button>
    ${body && html`<button type="button" data-measured=${body} onClick=${measured}>Measured…</button>`}
  </div>`;
}

/** An entry of a list. */
function Entry({ form, tables, value, place }) {
  if (!isTable(value)) return html`<${Stray} ...${{ form, place, value }} />`;
  const isKinded = tables[0].properties.kind;
  const overlap = ({ properties }) => Object.keys(value).filter((name) => name in properties).length;
  // Of an unknown kind the keys are unknown, too.
  const table = isKinded
    ? (tables.find(({ properties }) => properties.kind.const === value.kind) ?? { properties: { kind: {} } })
    : tables.reduce((best, table) => (overlap(table) > overlap(best) ? table : best));
  const label = `${labelOf(place)}${isKinded && typeof value.kind === "string" ? `: ${value.kind}` : ""}`;
  const removal = typeof lastOf(place) === "number" && html`<${Remove} ...${{ form, place, label }} />`;
  return html`<${Group} ...${{ place, label, help: table.description, before: removal }}>
    <${Members} ...${{ form, table, value, place, others: tables }} /><//>`;
}

/** A button that removes an entry of a list, or an unknown key. */
function Remove({ form, place, label }) {
  const path = pathOf(place);
  return html`<button type="button" data-action="remove" data-path=${path} aria-label="remove ${label}"
    onClick=${({ timeStamp }) => form.remove(path, timeStamp)}>Remove</button>`;
}

/** Fields that belong together. */
function Group({ place, label = labelOf(place), help, before, quiet, children }) {
  const path = pathOf(place);
  return html`<fieldset data-group=${path}>
    <legend class=${quiet ? "unseen" : ""}>${label}</legend>${before}
    ${help && html`<p class="help">${help}</p>`}
    <${Sentence} of="${path}/" />${children}</fieldset>`;
}

/** The row of a field: its label, which may be a choice between keys or shapes, and what is in it. */
function Row({ form, place, label = labelOf(place), swap = [], help = "", removable, style = "", children }) {
  const [path, id] = [pathOf(place), idOf(pathOf(place))];
  const words = `choice: ${swap.map((option) => option.label).join("; ")}`;
  const estimated = form?.isEstimate(path);
  const state = marked.has(path) ? "wrong" : estimated ? "estimated" : "";
  return html`<div class="field ${style} ${state}" data-path=${path}>
    ${swap.length > 0 && html`<${Swap} ...${{ form, options: swap }} aria-label=${words} />`}
    <label class=${swap.length ? "unseen" : ""} for=${id}>${label}</label>${children}
    ${removable && html`<${Remove} ...${{ form, place, label: path }} />`}
    <p class="help" id="${id}-help">${estimated && "Estimated from catalogue data: "}${help}</p><${Sentence} of=${path} id="${id}-mistake" /></div>`;
}

/** What is wrong with a field, or with a group as a whole. */
function Sentence({ of, id }) {
  return html`<p class="mistake" id=${id} role="alert" hidden=${!marked.has(of)}>${marked.get(of)}</p>`;
}

/** The attributes of the control of a field. @param {Place} place */
function control(place) {
  const [path, id] = [pathOf(place), idOf(pathOf(place))];
  const wrong = marked.has(path) ? "true" : undefined;
  return { id, name: path, "aria-invalid": wrong, "aria-describedby": `${id}-help ${id}-mistake` };
}

/** What does not fit its place, such as an unknown key: it can be edited or removed. */
function Stray({ place, ...more }) {
  return html`<${Text} ...${{ ...more, place, kind: "json", label: String(lastOf(place)) }} removable />`;
}

/** A value other than a table. */
function Value({ form, place, holds, value, usual, label, swap, range = form.range(place) }) {
  const { kind, unit, words, help } = holds;
  const [text, shared] = [textOf(kind, value), { form, place, label, swap, help }];
  const what = Array.isArray(value) && kind === "list" ? "numbers" : typeof value === "string" ? "letters" : "";
  if (what && value.length > LONG[what]) return html`<${Hidden} ...${{ ...shared, value, what }} />`;
  if (text === null) return html`<${Text} ...${{ ...shared, value, kind: "json" }} />`;
  if (kind !== "choice" && kind !== "boolean")
    return html`<${Text} ...${{ ...shared, kind, base: unit, words, value, usual, range }} />`;
  const named = kind === "boolean" ? { true: "yes", false: "no" } : {};
  const options = [...new Set([...(kind === "boolean" ? ["true", "false"] : words), ...(text ? [text] : [])])];
  const left = usual === undefined || usual === "" ? "not given" : `${named[usual] ?? usual} (default)`;
  const take = ({ target, timeStamp }) => form.edit(pathOf(place), toValue(kind, target.value), timeStamp);
  const shown = [["", left], ...options.map((word) => [word, named[word] ?? word])];
  const props = { ...control(place), value: text, options: shown };
  return html`<${Row} ...${shared}><${Select} ...${props} data-kind=${kind} onInput=${take} /><//>`;
}

/** What is too long to be shown. */
function Hidden({ value, what, ...shared }) {
  return html`<${Row} ...${shared}><span class="points">${value.length} ${what}</span><//>`;
}

/** A number with its unit and its slider, a text, a list, or JSON. */
function Text({ form, place, kind, value, base = "", words = [], usual, range, label = labelOf(place), ...more }) {
  /** @type {{current: {text: string, value: any} | null}} what is being written, until the field is left */
  const draft = useRef(null);
  const chosen = useRef(undefined); // unit
  const last = useRef(0); // position of the slider
  const [, redraw] = useState(0);
  const [path, id] = [pathOf(place), idOf(pathOf(place))];
  const name = String(place.findLast((part) => typeof part === "string"));
  const numeric = NUMERIC.includes(kind);
  const sizes = numeric ? choicesOf(base) : {};
  const units = Object.keys(sizes);
  const shown = numeric ? shownIn(value, base, name, chosen.current) : { text: textOf(kind, value) ?? "", word: "" };
  if (JSON.stringify(draft.current?.value) !== JSON.stringify(value)) draft.current = null;
  const { text, word } = { ...shown, ...(draft.current && { text: draft.current.text }) };
  const number = value === undefined ? NaN : valueIn(value, base);
  const take = (written, since, byHand = false) => {
    const next = toValue(kind, written, word, base);
    draft.current = byHand ? { text: written, value: next } : null;
    chosen.current = word;
    form.edit(path, next, since);
  };
  const leave = () => {
    draft.current = null;
    const unit = numeric && typeof value === "string" && split(value)?.unit;
    if (unit && unit in sizes) chosen.current = unit; // that was written with the number
    redraw((count) => count + 1);
  };
  const convert = ({ target, timeStamp }) => {
    draft.current = null;
    chosen.current = target.value;
    if (Number.isFinite(number)) form.edit(path, writtenIn(number, target.value, base), timeStamp);
    redraw((count) => count + 1);
  };
  const isWord = kind === "integer-or-word" && typeof value === "string" && Number.isNaN(number);
  const span = numeric && range && !isWord ? rangeFor(range, base, number) : null;
  if (span && (value === undefined || Number.isFinite(number)))
    last.current = placeOf(span, value === undefined ? span.start : number);
  const [unit, factor] = [legible(word || base), sizes[word] ?? 1];
  const note = (slider) =>
    slider && slid.set(slider, { path, value: number, span, unit, factor, label: () => nameOf(byId(id)) });
  const suggestions = words.map((word) => html`<option value=${word} />`);
  const converted = typeof usual === "number" && usual && units.length;
  const placeholder = converted ? shownIn(usual, base, name, word).text : (usual ?? "");
  const chooser = {
    ...{ class: "unit", "aria-label": `unit of ${label}`, value: word, onInput: convert },
    options: units.map((unit) => [unit, legible(unit), { "data-factor": sizes[unit] }]),
  };
  return html`<${Row} ...${{ ...more, form, place, label }}>
    <input type="text" ...${control(place)} data-kind=${kind} data-unit=${base || undefined} value=${text}
      placeholder=${placeholder} list=${words.length ? `${id}-words` : undefined} autocomplete="off" spellcheck=${false}
      onInput=${({ target, timeStamp }) => take(target.value, timeStamp, true)} onChange=${leave} />
    ${words.length > 0 && html`<datalist id="${id}-words">${suggestions}</datalist>`}
    ${units.length > 1 && html`<${Select} ...${chooser} />`}
    ${units.length < 2 && base && html`<span class="unit">${legible(base)}</span>`}
    ${
      span &&
      html`<input type="range" class="slider" ref=${note} min="0" max="1000" step="1" aria-label="${label}, slider"
      value=${last.current}
      aria-valuetext=${text ? `${text} ${split(text) ? "" : legible(word)}`.trim() : "not given"}
      onInput=${({ target, timeStamp }) => take(textAt(span, Number(target.value), sizes[word] ?? 1), timeStamp)} />`
    }<//>`;
}

/** @param {any} value */
function isTable(value) {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

/** @param {Place} place */
function lastOf(place) {
  return place[place.length - 1];
}

/** An identifier, the same every time a field is drawn. @param {string} path */
function idOf(path) {
  return `field-${path.replace(/[^A-Za-z0-9]/gu, (letter) => `-${letter.codePointAt(0)?.toString(16)}`)}`;
}
