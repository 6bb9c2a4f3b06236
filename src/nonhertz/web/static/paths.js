// Paths in a case: "body.a.profile[1].radius", counted from 1 as in the mistakes.

const PART = /\.?([A-Za-z0-9_-]+)|\.?("(?:[^"\\]|\\.)*")|\[(\d+)\]/g;

/**
 * Return the keys and positions (from 0) that a path consists of; a key with special characters is quoted in it.
 * @param {string} path
 * @returns {(string | number)[]}
 */
export function parts(path) {
  return [...path.matchAll(PART)].map(([, bare, quoted, position]) =>
    position !== undefined ? Number(position) - 1 : (bare ?? JSON.parse(quoted)),
  );
}

/**
 * Return the value at a path, undefined if there is none.
 * @param {any} document
 * @param {string} path
 */
export function valueAt(document, path) {
  return parts(path).reduce((value, part) => value?.[part], document);
}

/**
 * Return a copy of the case with a value at a path, or without the key if the value is undefined.
 * A value in the way of a deeper path (such as a material's name) is replaced by a table.
 * @param {any} document
 * @param {string} path
 * @param {any} value
 */
export function withValue(document, path, value) {
  return changed(document, parts(path), value);
}

/** A copy of a table with a value at keys; what is not on the way is shared. @param {any} table */
function changed(table, [key, ...rest], value) {
  if (key === undefined) return table;
  const copy = Array.isArray(table) ? [...table] : { ...table };
  let inner = value;
  if (rest.length) {
    const isTable = typeof copy[key] === "object" && copy[key] !== null;
    if (!isTable && value === undefined) return table;
    inner = changed(isTable ? copy[key] : typeof rest[0] === "number" ? [] : {}, rest, value);
  }
  if (inner !== undefined) copy[key] = inner;
  else if (Array.isArray(copy)) copy.splice(Number(key), 1);
  else delete copy[key];
  return copy;
}

/**
 * Return the paths of the values that differ between two documents.
 * @param {any} one
 * @param {any} other
 * @param {(string | number)[]} [place] of both
 * @returns {string[]}
 */
export function differences(one, other, place = []) {
  if (JSON.stringify(one) === JSON.stringify(other)) return [];
  const isInner = [one, other].every((each) => typeof each === "object" && each !== null);
  if (!isInner || Array.isArray(one) !== Array.isArray(other)) return [pathOf(place)];
  const step = (key) => (Array.isArray(one) ? Number(key) + 1 : key);
  return Object.keys({ ...one, ...other }).flatMap((key) => differences(one[key], other[key], [...place, step(key)]));
}

/**
 * Return the path one step further out, empty at the top: "body.a.profile" for "body.a.profile[1]".
 * @param {string} path
 */
export function outer(path) {
  const last = [...path.matchAll(PART)].pop();
  return last ? path.slice(0, last.index) : "";
}

const BARE = /^[A-Za-z0-9_-]+$/;

/** Return the path of keys and positions (from 1). @param {(string | number)[]} place */
export function pathOf(place) {
  const quoted = (key) => (BARE.test(key) ? key : JSON.stringify(key));
  return place.reduce(
    (/** @type {string} */ path, part) =>
      typeof part === "number" ? `${path}[${part}]` : `${path}${path && "."}${quoted(part)}`,
    "",
  );
}
