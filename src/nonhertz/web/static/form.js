// The form of a document, drawn from the JSON schema of its file.
//
// The document is all that is kept: an edit makes another document, of which the form is drawn anew, and the library
// changes what differs on the page, so that focus and folds stay. What sliders span follows from the geometry, which the
// program works out when the hand rests.

import { byId } from "./elements.js";
import { choicesOf, legible, placeOf, rangeFor, said, shownIn, textAt, textOf, valueIn, writtenIn } from "./fields.js";
import { columns, split } from "./numbers.js";
import { outer, pathOf, valueAt, withValue } from "./paths.js";
import { html, render, useRef } from "./preact.js";
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
const OPEN = ["fit", "life", "pair", "viscosity", "cleanliness", "spectrum"]; // headings that are unfolded where a file has what is below them
const LONG = { list: 24, text: 1000, tables: 40 }; // entries, letters and tables beyond which something is not shown

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
    this.rest = 0;
    /** @type {Set<string>} paths of tables that are left out where all of their keys are */
    this.optional = new Set();
    this.host = /** @type {HTMLFormElement} */ (byId("case"));
    this.host.addEventListener("submit", (event) => event.preventDefault());
    this.host.addEventListener("paste", (event) => this.paste(event));
    this.draw();
    this.page.drawn();
  }

  draw() {
    // Fields remember the unit that was chosen in them: not beyond a change of all units.
    render(html`<${Document} key=${unitsCode()} form=${this} document=${this.document} />`, this.host);
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

  /** Remove an entry of a list; the focus goes to the button in its place. @param {string} path @param {number} since */
  remove(path, since) {
    this.restructure([[path, undefined]], since);
    const button = (what, at) => this.host.querySelector(`[data-action="${what}"][data-path="${CSS.escape(at)}"]`);
    const next = button("remove", path) ?? button("add", outer(path));
    if (next instanceof HTMLElement) next.focus({ preventScroll: true });
  }
}

/** @param {{form: Form, document: any}} props */
function Document({ form, document }) {
  form.optional.clear();
  return html`<${Members} form=${form} table=${form.schema.whole} value=${document} place=${[]} />`;
}

/**
 * The keys of a table: its kind, its fields, those that most files leave out below headings, and what is unknown as JSON.
 * @param {{form: Form, table: any, value: any, place: Place, others?: any[]}} props `others` may stand in its place
 */
function Members({ form, table, value, place, others = [] }) {
  const { schema } = form;
  const keys = schema.keys(table, value);
  const needed = schema.needed(table);
  const pairs = table["x-pairs"] ?? [];
  let names = schema.shown(table, value, keys);
  // Washers are flat, without seats that would press on a raceway.
  if (form.document.bearing?.kind === "thrust" && (!place.length || RINGS.includes(String(place[0]))))
    names = names.filter((name) => name in value || !["fit", "diameter"].includes(name));
  if ("profile" in table.properties && !isWhole(form, place, value))
    names = names.filter((name) => name in value || name !== "bore");
  const order = [...FIRST, ...keys];
  names.sort((one, other) => order.indexOf(one) - order.indexOf(other));
  const folds = FOLDS.map(([heading, all, only]) => {
    const here = !only || only === place[place.length - 1] ? all : [];
    const folded = names.filter(
      (name) => here.includes(name) && !needed.includes(name) && !pairs.some((pair) => pair.includes(name)),
    );
    return {
      heading: 2 * folded.length < all.length ? folded.map((name) => labelOf([...place, name])).join(", ") : heading,
      folded,
    };
  });
  const member = (name) =>
    html`<${Member} key=${name} ...${{ form, table, within: value, place: [...place, name], value: value[name] }} />`;
  const known = [...keys, ...(table.properties.kind || !place.length ? ["kind", "format"] : [])];
  return html` ${table.properties.kind && html`<${Kind} key="kind" ...${{ form, table, value, place, others }} />`}
  ${names.filter((name) => !folds.some(({ folded }) => folded.includes(name))).map(member)}
  ${Object.keys(value)
    .filter((name) => !known.includes(name))
    .map((name) => html`<${Stray} key=${`?${name}`} form=${form} place=${[...place, name]} value=${value[name]} />`)}
  ${folds.map(({ heading, folded }, number) => folded.length > 0 && html`<${Fold} key=${`/${number}`} heading=${heading} name=${[...place, folded[0]].join("/")} section=${!place.length} open=${folded.some((name) => OPEN.includes(name) && name in value)}>${folded.map(member)}<//>`)}`;
}

/** Only whole rollers are hollow; of a body with mistakes it is not known what it is. */
function isWhole(form, place, value) {
  return (value.depth ?? (form.state.bodies[pathOf(place)]?.depth || "finite")) === "finite";
}

/** Fields below a heading. */
function Fold({ heading, name, section, open, children }) {
  const opened = useRef(open).current; // at first: whether it is folded is for the reader to choose
  return html`<details class=${section ? "section" : "more"} open=${opened} data-details=${name}>
    <summary>${heading}</summary>
    ${children}
  </details>`;
}

/** The choice of the kind of a table, on which its other keys depend. */
function Kind({ form, table, value, place, others }) {
  const path = pathOf(place);
  const range = form.rangesIn(place);
  const options = table["x-kinds"]
    ? Object.keys(table["x-kinds"]).map((kind) => ({
        label: kind,
        edits: form.schema.ofKind(table, value, kind, path, range),
      }))
    : form.schema
        .ofNumbers(others)
        .map((other) => ({
          label: other.properties.kind.const,
          edits: [[path, form.schema.fresh(other, range, "", value)]],
        }));
  const at = [...place, "kind"];
  const help = table.properties.kind.description ?? "kind of profile";
  if (value.kind !== undefined && textOf("choice", value.kind) === null)
    return html`<${Text} form=${form} place=${at} kind="json" value=${value.kind} help=${help} />`;
  const known = options.some(({ label }) => label === value.kind);
  const take = (event) =>
    form.restructure(options.find(({ label }) => label === event.target.value)?.edits ?? [], event.timeStamp);
  return html`<${Row} place=${at} help=${help}>
    <select ...${control(at)} data-kind="choice" value=${value.kind ?? ""} onInput=${take}>
      ${value.kind === undefined && html`<option value="">${"diameter" in table.properties ? "by its dimensions" : "not given"}</option>`}
      ${options.map(({ label }) => html`<option value=${label}>${label}</option>`)}
      ${value.kind !== undefined && !known && html`<option value=${value.kind}>${value.kind}</option>`}
    </select><//
  >`;
}

/** One key of a table, whatever it holds. */
function Member({ form, table, within, place, value }) {
  const { schema } = form;
  const name = String(place[place.length - 1]);
  const part = table.properties[name];
  const holds = schema.key(part);
  const props = { form, place, holds, value, within, swap: alternatives(form, table, within, place) };
  if (holds.names) return html`<${OneOrTwo} ...${props} />`;
  if (holds.entries) return html`<${List} ...${props} />`;
  const isTable = typeof value === "object" && value !== null && !Array.isArray(value);
  if (holds.kind === "table" || (holds.tables.length && MOSTLY_NUMBERS.includes(name) && isTable))
    return html`<${Part} ...${props} optional=${!schema.needed(table).includes(name)} />`;
  const alone = MOSTLY_NUMBERS.includes(name) || (name === "diameter" && RINGS.includes(String(place[0])) && !isTable);
  if (holds.tables.length && !alone) return html`<${ValueOrTable} ...${props} />`;
  return html`<${Value}
    ...${props}
    usual=${name === "depth" ? form.state.bodies[outer(pathOf(place))]?.depth : holds.usual}
  />`;
}

/** Of a key that is given in place of another, both: the one that is shown first. @returns {Option[] | undefined} */
function alternatives(form, table, within, place) {
  const [name, path] = [String(place[place.length - 1]), pathOf(place.slice(0, -1))];
  const pair = (table["x-pairs"] ?? []).find((each) => each.includes(name));
  if (!pair) return undefined;
  const sizes = pair.includes("drop") ? (form.state.bodies[outer(outer(path))]?.sizes ?? {}) : {};
  const at = (each) => (path ? `${path}.${each}` : each);
  const range = form.rangesIn(place.slice(0, -1));
  const options = pair.map((each) => ({
    label: labelOf([...place.slice(0, -1), each]),
    edits: [
      ...pair.filter((other) => other !== each).map((other) => [at(other), undefined]),
      [at(each), sizes[each] ?? form.schema.start(each, table.properties[each], range)],
    ],
  }));
  return [options[pair.indexOf(name)], ...options.filter((_, number) => pair[number] !== name)];
}

/** The options of a label, of which the first is what is shown. @param {Option[] | undefined} swap @param {Option[]} shapes */
function withShapes(swap, shapes) {
  return [...shapes, ...(swap ?? []).slice(1)];
}

/** A table; one that needs some of its keys is given as a whole, or left out by a choice. */
function Part({ form, place, holds, value, optional, within }) {
  const [path, label, table] = [pathOf(place), labelOf(place), holds.tables[0]];
  const given = value !== undefined;
  if (given && (typeof value !== "object" || value === null || Array.isArray(value)))
    return html`<${Stray} form=${form} place=${place} value=${value} help=${holds.help} />`;
  const needs = optional && form.schema.needed(table).length > 0;
  if (optional) form.optional.add(path);
  const made = () => form.schema.fresh(table, form.rangesIn(place.slice(0, -1)), String(place[place.length - 1]));
  const choice =
    needs &&
    html`<${Row} place=${place} help=${holds.help} switched>
      <select
        id=${idOf(path)}
        data-structure
        value=${given ? "given" : "none"}
        onInput=${(event) => form.restructure([[path, event.target.value === "given" ? made() : undefined]], event.timeStamp)}
      >
        <option value="none">none</option>
        <option value="given">given</option>
      </select><//
    >`;
  if (needs && !given) return choice;
  return html`<${Group} place=${place} help=${holds.help} quiet=${needs || SECTIONS.includes(path)}>
    ${choice}<${Members} form=${form} table=${table} value=${value ?? {}} place=${place}
  /><//>`;
}

/** A key with one value, or a table of several. */
function ValueOrTable({ form, place, holds, value, within }) {
  const [name, path, table] = [String(place[place.length - 1]), pathOf(place), holds.tables[0]];
  const tabular = typeof value === "object" && value !== null && !Array.isArray(value);
  const range = form.rangesIn(place);
  const needed = form.schema.needed(table);
  const several = Object.fromEntries(
    needed.map((each) => [each, form.schema.start(each, table.properties[each], range)]),
  );
  const middle = tabular && Array.isArray(value[name]) ? value[name][value[name].length >> 1] : undefined;
  const simple = middle ?? (NUMERIC.includes(holds.kind) ? (form.range(place)?.start ?? 1) : holds.words[0]);
  if (!tabular && value !== undefined && name in several) several[name] = several[name].map(() => value);
  const label = labelOf(place);
  const shapes = [
    { label, edits: [[path, simple]] },
    { label: `${label} by ${needed.map((each) => labelOf([each])).join(" and ")}`, edits: [[path, several]] },
  ];
  if (!tabular) return html`<${Value} ...${{ form, place, holds, value, within, usual: holds.usual, swap: shapes }} />`;
  return html`<${Group} place=${place} help=${holds.help} quiet>
    <${Shape} form=${form} options=${[shapes[1], shapes[0]]} label=${label} place=${place} />
    <${Members} form=${form} table=${table} value=${value} place=${place}
  /><//>`;
}

/** A key with one value, or one for each of two. */
function OneOrTwo({ form, place, holds, value, within, swap }) {
  const [path, label] = [pathOf(place), labelOf(place)];
  const isPair = Array.isArray(value) && value.length === 2;
  const one = { ...holds, names: null };
  if (!isPair && place[place.length - 1] === "side_faces" && !("length" in within))
    return html`<${Value} ...${{ form, place, holds: one, value, within, usual: holds.usual }} />`;
  const first = isPair ? value[holds.single ?? 0] : (value ?? holds.usual ?? 0);
  const both = holds.names.map((_, number) => (holds.single === null || holds.single === number ? first : 0));
  const shapes = [
    { label, edits: [[path, first]] },
    {
      label: `${label}, ${holds.single === null ? "each end" : holds.names.join(" and ")}`,
      edits: [[path, isPair ? value : both]],
    },
  ];
  if (!isPair)
    return html`<${Value}
      ...${{ form, place, holds: one, value, within, usual: holds.usual, swap: withShapes(swap, shapes) }}
    />`;
  const range = form.range(place);
  const wide = range && { ...range, low: -range.high };
  return html`<${Group} place=${place} help=${holds.help} quiet>
    <${Shape} form=${form} options=${withShapes(swap, [shapes[1], shapes[0]])} label=${label} place=${place} />
    ${value.map((entry, number) => html`<${Value} key=${number} ...${{ form, place: [...place, number + 1], holds: one, value: entry, within, label: holds.names[number], range: wide }} />`)}<//
  >`;
}

/** A choice that is no key of the document. @param {{form: Form, options: Option[], label: string, place: Place}} props */
function Shape({ form, options, label, place }) {
  const id = `${idOf(pathOf(place))}-shape`;
  return html`<div class="field switch">
    <label class="unseen" for=${id}>${label}, as</label> <${Swap} form=${form} options=${options} id=${id} />
  </div>`;
}

/** @param {{form: Form, options: Option[], id?: string, label?: string}} props the first option is what is shown */
function Swap({ form, options, id, label }) {
  const take = (event) =>
    form.restructure(options.find((each) => each.label === event.target.value)?.edits ?? [], event.timeStamp);
  const ordered = [...options].sort((one, other) => (one.label < other.label ? -1 : 1));
  return html`<select
    class="swap"
    id=${id}
    aria-label=${label}
    data-structure
    value=${options[0].label}
    onInput=${take}
  >
    ${ordered.map((each) => html`<option value=${each.label}>${each.label}</option>`)}
  </select>`;
}

/** A list of tables, or a single table in place of a list of one. */
function List({ form, place, holds, value }) {
  const [path, tables] = [pathOf(place), holds.entries];
  if (value !== undefined && (typeof value !== "object" || value === null))
    return html`<${Stray} form=${form} place=${place} value=${value} help=${holds.help} />`;
  const entry = (each, at) =>
    html`<${Entry} key=${at[at.length - 1]} form=${form} tables=${tables} value=${each} place=${at} />`;
  if (value !== undefined && !Array.isArray(value)) return entry(value, place);
  if (value?.length > LONG.tables)
    return html`<${Row} place=${place}><span class="points">${value.length} entries</span><//>`;
  const body = Object.entries(form.page.bodies).find(([, of]) => path === `${of}.profile`)?.[0];
  return html`<${Group} place=${place} help=${holds.help}>
    ${
      body &&
      html`<figure data-figure="profile-${body}" class="profile-figure">
        <figcaption class="unseen">Profile of ${bodyNamed(body)}</figcaption>
        <div class="drawing"></div>
      </figure>`
    }
    ${(value ?? []).map((each, number) => entry(each, [...place, number + 1]))}
    <${Add}
      form=${form}
      place=${place}
      label=${labelOf(place)}
      tables=${form.schema.ofNumbers(tables)}
      value=${value}
      body=${body}
  /><//>`;
}

/** What can be added to a list. */
function Add({ form, place, label, tables, value, body }) {
  const path = pathOf(place);
  const chosen = useRef(0);
  const kinds = tables.map((table) => table.properties.kind?.const ?? "");
  const titles = tables.map(
    (table, number) => kinds[number] || (tables.length > 1 ? labelOf([table.title.toLowerCase()]) : "row"),
  );
  const add = (event) =>
    form.restructure(
      [[path, [...(value ?? []), form.schema.fresh(tables[chosen.current], form.rangesIn(place))]]],
      event.timeStamp,
    );
  return html`<div class="add">
    ${
      tables.length > 1 &&
      html`<select
        aria-label="kind of ${label} to add"
        data-additions=${path}
        onInput=${(event) => (chosen.current = event.target.selectedIndex)}
      >
        ${titles.map((title) => html`<option value=${title}>${title}</option>`)}
      </select>`
    }
    <button type="button" data-action="add" data-path=${path} onClick=${add}>
      Add ${tables.length > 1 ? label : titles[0]}
    </button>
    ${body && html`<button type="button" class="measured" data-measured=${body} onClick=${() => form.page.measured(body)}>Measured…</button>`}
  </div>`;
}

/** An entry of a list. */
function Entry({ form, tables, value, place }) {
  if (typeof value !== "object" || value === null || Array.isArray(value))
    return html`<${Stray} form=${form} place=${place} value=${value} />`;
  const isKinded = tables[0].properties.kind;
  const overlap = (table) => Object.keys(value).filter((name) => name in table.properties).length;
  const unknown = { properties: { kind: { description: "kind of profile" } }, required: [] }; // of which the keys are unknown, too
  const table = isKinded
    ? (tables.find((each) => each.properties.kind.const === value.kind) ?? unknown)
    : tables.reduce((best, each) => (overlap(each) > overlap(best) ? each : best));
  const label = `${labelOf(place)}${isKinded && typeof value.kind === "string" ? `: ${value.kind}` : ""}`;
  const path = pathOf(place);
  const removable = typeof place[place.length - 1] === "number";
  return html`<${Group}
    place=${place}
    label=${label}
    help=${table.description}
    before=${removable && html`<button type="button" data-action="remove" data-path=${path} aria-label="remove ${label}" onClick=${(event) => form.remove(path, event.timeStamp)}>Remove</button>`}
  >
    <${Members} form=${form} table=${table} value=${value} place=${place} others=${tables}
  /><//>`;
}

/** Fields that belong together. */
function Group({ place, label = labelOf(place), help, before, quiet, children }) {
  const path = pathOf(place);
  return html`<fieldset data-group=${path}>
    <legend class=${quiet ? "unseen" : ""}>${label}</legend>
    ${before} ${help && html`<p class="help">${help}</p>`}
    <p class="mistake" data-mistake-for=${path} role="alert" hidden></p>
    ${children}
  </fieldset>`;
}

/** The row of a field: its label, which may be a choice between keys or shapes, and what is in it. */
function Row({ form, place, label = labelOf(place), swap, help = "", removable, switched, children }) {
  const path = pathOf(place);
  const id = idOf(path);
  return html`<div class=${switched ? "field switch" : "field"} data-path=${path}>
    ${swap && html`<${Swap} form=${form} options=${swap} label=${`which of: ${swap.map((each) => each.label).join("; ")}`} />`}
    <label class=${swap ? "unseen" : ""} for=${id}>${label}</label>${children}
    ${removable && html`<button type="button" data-action="remove" data-path=${path} aria-label="remove ${path}" onClick=${(event) => form.remove(path, event.timeStamp)}>Remove</button>`}
    <p class="help" id="${id}-help">${help}</p>
    <p class="mistake" id="${id}-mistake" role="alert" hidden></p>
  </div>`;
}

/** The attributes of the control of a field. @param {Place} place */
function control(place) {
  const path = pathOf(place);
  return { id: idOf(path), name: path, "aria-describedby": `${idOf(path)}-help ${idOf(path)}-mistake` };
}

/** An unknown key, which can be edited or removed. */
function Stray({ form, place, value, help }) {
  return html`<${Text}
    form=${form}
    place=${place}
    kind="json"
    value=${value}
    removable
    label=${String(place[place.length - 1])}
    help=${help}
  />`;
}

/** A value other than a table. */
function Value({ form, place, holds, value, usual, label, swap, range = form.range(place) }) {
  const text = textOf(holds.kind, value);
  const shared = { form, place, label, swap, help: holds.help };
  const length =
    Array.isArray(value) && holds.kind === "list" ? value.length : typeof value === "string" ? value.length : 0;
  if (length > (Array.isArray(value) ? LONG.list : LONG.text))
    return html`<${Row} ...${shared}
      ><span class="points" id=${idOf(pathOf(place))}
        >${length} ${Array.isArray(value) ? "numbers" : "letters"}</span
      ><//
    >`;
  if (text === null) return html`<${Text} ...${shared} kind="json" value=${value} />`;
  if (holds.kind === "choice" || holds.kind === "boolean")
    return html`<${Choice} ...${shared} ...${{ holds, text, usual }} />`;
  return html`<${Text}
    ...${shared}
    ...${{ kind: holds.kind, base: holds.unit, words: holds.words, value, usual, range }}
  />`;
}

/** A word of a few. */
function Choice({ form, place, label, swap, help, holds, text, usual }) {
  const words =
    holds.kind === "boolean"
      ? { true: "yes", false: "no" }
      : Object.fromEntries([...holds.words, text].filter(Boolean).map((word) => [word, word]));
  const left = usual === undefined || usual === "" ? "not given" : `${words[String(usual)] ?? usual} (usual)`;
  const path = pathOf(place);
  return html`<${Row} ...${{ form, place, label, swap, help }}>
    <select
      ...${control(place)}
      data-kind=${holds.kind}
      value=${text}
      onInput=${(event) => form.edit(path, said(holds.kind, event.target.value), event.timeStamp)}
    >
      <option value="">${left}</option>
      ${Object.entries(words).map(([word, shown]) => html`<option value=${word}>${shown}</option>`)}
    </select><//
  >`;
}

/** A number with its unit and its slider, a text, a list, or JSON. */
function Text({ form, place, label, swap, help, kind, base = "", words = [], value, usual, range, removable }) {
  /** @type {{current: {text: string, value: any} | null}} what is being written, until the field is left */
  const draft = useRef(null);
  /** @type {{current: string | undefined}} the unit that was chosen */
  const chosen = useRef(undefined);
  const last = useRef(0); // position of the slider
  const [path, id] = [pathOf(place), idOf(pathOf(place))];
  const name = String(place.findLast((each) => typeof each === "string"));
  const numeric = NUMERIC.includes(kind);
  const sizes = numeric ? choicesOf(base) : {};
  const units = Object.keys(sizes);
  const shown = numeric ? shownIn(value, base, name, chosen.current) : { text: textOf(kind, value) ?? "", word: "" };
  const isDraft = draft.current && JSON.stringify(draft.current.value) === JSON.stringify(value);
  if (!isDraft) draft.current = null;
  const text = draft.current?.text ?? shown.text;
  const word = isDraft && chosen.current ? chosen.current : shown.word;
  const take = (written, since, byHand) => {
    const next = said(kind, written, word, base);
    draft.current = byHand ? { text: written, value: next } : null;
    chosen.current = word;
    form.edit(path, next, since);
  };
  const leave = () => {
    const unit = numeric && typeof value === "string" && split(value)?.unit;
    draft.current = null;
    if (unit && unit in sizes) chosen.current = unit;
    form.draw();
  };
  const change = (event) => {
    const number = valueIn(value, base);
    chosen.current = event.target.value;
    draft.current = null;
    if (Number.isFinite(number)) form.edit(path, writtenIn(number, event.target.value, base), event.timeStamp);
    else form.draw();
  };
  const number = value === undefined ? NaN : valueIn(value, base);
  const span =
    numeric && range && !(kind === "integer-or-word" && typeof value === "string" && !Number.isFinite(number))
      ? rangeFor(range, base, number)
      : null;
  if (span)
    last.current =
      Number.isFinite(number) || value === undefined
        ? placeOf(span, Number.isFinite(number) ? number : span.start)
        : last.current;
  const placeholder =
    typeof usual === "number" && usual && units.length ? `${shownIn(usual, base, name, word).text}` : (usual ?? "");
  return html`<${Row} ...${{ form, place, label, swap, help, removable }}>
    <input
      type="text"
      ...${control(place)}
      data-kind=${kind}
      data-unit=${base || undefined}
      value=${text}
      placeholder=${placeholder}
      list=${words.length ? `${id}-words` : undefined}
      autocomplete="off"
      spellcheck=${false}
      onInput=${(event) => take(event.target.value, event.timeStamp, true)}
      onChange=${leave}
    />
    ${words.length > 0 && html`<datalist id="${id}-words">${words.map((each) => html`<option value=${each}></option>`)}</datalist>`}
    ${
      units.length > 1 &&
      html`<select
        class="unit"
        data-unit-of=${id}
        aria-label="unit of ${label ?? labelOf(place)}"
        value=${word}
        onInput=${change}
      >
        ${units.map((each) => html`<option value=${each} data-factor=${sizes[each]}>${legible(each)}</option>`)}
      </select>`
    }
    ${units.length < 2 && base && html`<span class="unit">${legible(base)}</span>`}
    ${
      span &&
      html`<input
        type="range"
        class="slider"
        data-for=${id}
        min="0"
        max="1000"
        step="1"
        data-min=${span.low}
        data-max=${span.high}
        data-slider-scale=${span.scale}
        aria-label="${label ?? labelOf(place)}, slider"
        aria-valuetext=${text ? `${text} ${split(text) ? "" : legible(word)}`.trim() : "not given"}
        value=${last.current}
        onInput=${(event) => take(textAt(span, Number(event.target.value), sizes[word] ?? 1), event.timeStamp, false)}
      />`
    }<//
  >`;
}

/** An identifier, the same every time a field is drawn. @param {string} path */
function idOf(path) {
  return `field-${[...path].map((letter) => (/[A-Za-z0-9]/.test(letter) ? letter : `-${letter.codePointAt(0)?.toString(16)}`)).join("")}`;
}
