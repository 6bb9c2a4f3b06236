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
  const changed = structuredClone(document);
  const keys = parts(path);
  const last = keys.pop();
  if (last === undefined) return changed;
  let table = changed;
  for (const [position, key] of keys.entries()) {
    if (typeof table[key] !== "object" || table[key] === null) {
      if (value === undefined) return changed;
      table[key] = typeof (keys[position + 1] ?? last) === "number" ? [] : {};
    }
    table = table[key];
  }
  if (value !== undefined) table[last] = value;
  else if (Array.isArray(table)) table.splice(Number(last), 1);
  else delete table[last];
  return changed;
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
