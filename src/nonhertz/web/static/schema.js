// The contents of a document by the JSON schema of its file: the kind of each key, and the initial value of a new one.

/** @typedef {Record<string, any>} Table the schema of a table */
/**
 * @typedef {{
 *   kind: string, unit: string, words: string[], tables: Table[], entries: Table[] | null, names: string[] | null,
 *   single: number | null, usual: any, help: string, whole: boolean, least: number,
 * }} Key
 * What a key may hold: of which kind its text is, in which unit, words, tables, lists of tables, or two values.
 */

const PROFILE = (table) => table.properties.kind?.const !== undefined; // whose lists a file may replace
const COMMON = ["shift", "scale", "flip"]; // keys that all kinds of profile have, kept when the kind is changed
const ONLY_BESIDE = { at: "drop", chamfer: "length" };
const ONE = 1; // what a number begins with that has no slider

export class Schema {
  /** @param {any} whole @param {Record<string, number[]>} lists what lists begin with */
  constructor(whole, lists) {
    this.whole = whole;
    this.lists = lists;
    /** @type {Map<any, Key>} */
    this.known = new Map();
  }

  /** The schemas of which one holds, references followed. @param {any} part @returns {any[]} */
  alternatives(part) {
    if (part.$ref) return [this.whole.$defs[part.$ref.split("/").pop()]];
    if (!part.anyOf || part.properties) return [part];
    return part.anyOf.flatMap((one) => this.alternatives({ unit: part.unit, ...one }));
  }

  /** @param {any} part of the schema @returns {Key} */
  key(part) {
    const known = this.known.get(part) ?? this.described(part);
    this.known.set(part, known);
    return known;
  }

  described(part) {
    const all = this.alternatives(part);
    const tables = all.filter((one) => one.properties);
    const list = all.find((one) => one.type === "array");
    const items = list ? this.alternatives(list.items ?? {}) : [];
    const plain = all.filter((one) => !one.properties && one.type !== "array");
    const has = (type) => plain.some((one) => one.type === type);
    const number = plain.find((one) => one.type === "number" || one.type === "integer");
    const named = part["x-words"] ?? [];
    const words = [...named, ...(plain.length ? plain : items).flatMap((one) => one.enum ?? [])];
    const unit = [part, ...all, list?.items ?? {}, ...items].find((one) => one.unit)?.unit ?? "";
    const entries = items.filter((one) => one.properties);
    const kind = kindOf({ boolean: has("boolean"), text: has("string"), number, words, list, tables, plain });
    return {
      ...{ kind, unit, tables, words: kind === "json" && has("boolean") ? ["true", "false", ...words] : words },
      ...{ entries: entries.length ? entries : null, names: part["x-names"] ?? null, single: part["x-single"] ?? null },
      ...{ usual: part.default, help: part.description ?? "", whole: number?.type === "integer" },
      least: number?.minimum ?? 0,
    };
  }

  /** The keys that must be given of a table. @param {Table} table @returns {string[]} */
  needed(table) {
    return [...(table.required ?? []), ...(table.oneOf?.[0].required ?? [])].filter((name) => name !== "kind");
  }

  /** The keys that a table may have, of its kind. @param {Table} table @param {any} value @returns {string[]} */
  keys(table, value) {
    const names = table["x-kinds"]?.[value.kind]?.keys ?? Object.keys(table.properties);
    return names.filter((name) => name !== "kind" && name !== "format");
  }

  /** Those of them that are shown: of alternatives the one that is given, and none that others rule out. */
  shown(table, value, names) {
    const has = (name) => name in value;
    const aside = new Set(has("file") ? [] : ["file"]); // files are dropped or pasted
    for (const pair of table["x-pairs"] ?? []) {
      const chosen = pair.some(has) ? pair.filter(has) : [pair[0]];
      for (const name of pair) if (!chosen.includes(name)) aside.add(name);
    }
    for (const group of table["x-apart"] ?? [])
      if (group.some(has)) for (const name of group) if (!has(name)) aside.add(name);
    for (const [name, other] of Object.entries(ONLY_BESIDE)) if (!has(name) && !has(other)) aside.add(name);
    if (has("spectrum") && !has("dent")) aside.add("dent");
    if (value.kind === "plate" && !has("diameter")) aside.add("diameter");
    return names.filter((name) => !aside.has(name));
  }

  /**
   * What a key begins with when it is added.
   * @param {string} name @param {any} part @param {(path: string[]) => {start: number} | null | undefined} range
   * @param {string} [within]
   */
  start(name, part, range, within = "") {
    const key = this.key(part);
    if (key.entries) return [this.fresh(key.entries[0], range)];
    if (key.tables.length && !["quantity", "integer-or-word"].includes(key.kind))
      return this.fresh(key.tables[0], range, name);
    if (key.kind === "list") return [...(this.lists[name] ?? this.lists.y)];
    if (key.kind === "choice") return key.words[0];
    if (key.kind === "text") return "";
    if (key.kind === "boolean") return false;
    if (key.whole) return Math.max(key.least, 1);
    return range([within, name])?.start ?? ONE;
  }

  /** A table with all that must be given, and with what all profiles may have of the one before. */
  fresh(table, range, within = "", before = {}) {
    const inner = "load" in table.properties ? "across" : within;
    const needed = this.needed(table);
    const made = PROFILE(table) ? { kind: table.properties.kind.const } : {};
    for (const [name, part] of Object.entries(table.properties))
      if (needed.includes(name) || (PROFILE(table) && this.key(part).kind === "list"))
        made[name] = this.start(name, part, range, inner);
    if (PROFILE(table)) for (const name of COMMON) if (name in before) made[name] = before[name];
    return made;
  }

  /** The tables that need no file. @param {Table[]} tables */
  ofNumbers(tables) {
    return tables.filter((table) => !table.required?.includes("file"));
  }

  /**
    * The edits that change the kind of a table: keys that it needs are added, foreign ones are removed. For a bearing
 * with other parts, where little could stay, the edits make an example.
   * @param {Table} table @param {any} value @param {string} kind @param {string} path
   * @param {(path: string[]) => any} range
   * @returns {[string, any][]}
   */
  ofKind(table, value, kind, path, range) {
    const kinds = table["x-kinds"];
    const { keys, needed } = kinds[kind];
    const now = kinds[value.kind]?.keys ?? Object.keys(table.properties).filter((name) => name !== "kind");
    const example = this.whole["x-examples"]?.[kind];
    if (path === "bearing" && example && String([...keys].sort()) !== String([...now].sort()))
      return Object.entries(example).map(([name, part]) => [name, part ?? undefined]);
    const at = (name) => `${path}.${name}`;
    const foreign = Object.keys(value).filter((name) => name !== "kind" && !keys.includes(name));
    if (kind === "plate" && "diameter" in value) foreign.push("diameter");
    return [
      [at("kind"), kind],
      .../** @type {[string, any][]} */ (foreign.map((name) => [at(name), undefined])),
      .../** @type {[string, any][]} */ (
        needed
          .filter((name) => !(name in value))
          .map((name) => [at(name), this.start(name, table.properties[name], range)])
      ),
    ];
  }
}

/** Of which kind the text of a key is, by what may stand in it. @returns {string} */
function kindOf({ boolean, text, number, words, list, tables, plain }) {
  if (boolean) return plain.length > 1 ? "json" : "boolean";
  if (number) return words.length ? "integer-or-word" : "quantity";
  if (words.length && plain.length) return "choice";
  if (list) return "list";
  return text ? "text" : tables.length ? "table" : "json";
}
