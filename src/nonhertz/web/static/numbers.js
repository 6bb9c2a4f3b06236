// Numbers as people read and write them.

const PLAIN = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i;
const WITH_UNIT = /^([+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?)\s*([^\d\s.+-].*)$/i;
/** @type {Record<string, string>} */
const UNITS = { "°": "deg", "\u2032": "arcmin", "'": "arcmin", Nm: "N m", Nmm: "N mm", '"': "in" };
const MINUS = "\u2212";

/**
 * Return the value of a text field: a number if it is one, else the text itself ("20 kN").
 * Empty means that the key is left out.
 * @param {string} text
 * @returns {number | string | undefined}
 */
export function quantity(text) {
  const trimmed = text.trim();
  if (trimmed === "") return undefined;
  return PLAIN.test(trimmed) && Number.isFinite(Number(trimmed)) ? Number(trimmed) : trimmed;
}

/**
 * Return number and unit of text such as "4.2 kN", with the unit as files have it; null if it is nothing of the kind.
 * @param {string} text
 * @returns {{number: string, unit: string} | null}
 */
export function split(text) {
  const match = PLAIN.test(text.trim()) ? null : WITH_UNIT.exec(text.trim());
  return match ? { number: match[1], unit: UNITS[match[2]] ?? match[2].replace(/[\u00b5\u03bc]/g, "u") } : null;
}

/**
 * Return a list: items separated by blanks, or by commas or semicolons if they contain blanks ("8 mm, 9 mm").
 * @param {string} text
 * @returns {(number | string)[] | undefined}
 */
export function list(text) {
  const items = text.split(/[,;]/.test(text) ? /\s*[,;]\s*/ : /\s+/);
  const values = items.map(quantity).filter((value) => value !== undefined);
  return values.length ? values : undefined;
}

/**
 * Return the columns of a table of numbers, as spreadsheets and files have them; null if it is no table, or a single row.
 * Columns are divided by tabs or semicolons, else by blanks, else by commas; where commas do not divide, they are decimal
 * commas. A head of words is left out.
 * @param {string} text
 * @returns {number[][] | null}
 */
export function columns(text) {
  const rows = text.trim().split(/\r?\n/);
  const divider = /[\t;]/.test(text) ? /\s*[\t;]\s*/ : /\S[ ,]*[ ]+\S/.test(rows[rows.length - 1]) ? /,?\s+/ : ",";
  const table = rows.map((row) => row.trim().split(divider).map((cell) => Number(cell.trim().replace(",", ".") || NaN)));
  if (table[0].every(Number.isNaN)) table.shift();
  const count = table[0]?.length ?? 0;
  if (rows.length < 2 || table.some((row) => row.length !== count || !row.every(Number.isFinite))) return null;
  return table[0].map((_, place) => table.map((row) => row[place]));
}

/**
 * Return a number with a given number of significant digits, without an exponent where that is readable.
 * @param {number | null | undefined} value
 * @param {number} [significant]
 */
export function digits(value, significant = 4) {
  if (value === null || value === undefined || !Number.isFinite(value)) return "none";
  if (value === 0) return "0";
  const size = Math.abs(value);
  const text =
    size >= 10 ** significant && size < 1e7
      ? size.toFixed(0)
      : size < 1e-4 || size >= 1e7
        ? size.toExponential(significant - 1)
        : size.toPrecision(significant);
  return (value < 0 ? MINUS : "") + text;
}

/**
 * Return the difference of a number from an earlier one in per cent, with its sign.
 * @param {number | null | undefined} value
 * @param {number | null | undefined} before
 */
export function difference(value, before) {
  if (!Number.isFinite(value) || !Number.isFinite(before) || !before) return "";
  const share = (100 * (Number(value) - Number(before))) / Math.abs(Number(before));
  if (Math.abs(share) < 0.005) return "same";
  const text = Math.abs(share).toFixed(Math.abs(share) < 10 ? 2 : Math.abs(share) < 100 ? 1 : 0);
  return `${share < 0 ? MINUS : "+"}${text} %`;
}

/**
 * Return a number as a field shows it after its slider was moved: rounded to what the slider resolves.
 * @param {number} value
 * @param {number} step resolution of the slider there
 */
export function rounded(value, step) {
  const decimals = Math.max(0, Math.min(12, -Math.floor(Math.log10(Math.abs(step) || 1))));
  return String(Number(value.toFixed(decimals)));
}
