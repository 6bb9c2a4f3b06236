// The chosen roller: pressure and line load along it at both rings, and its relief.

import {
  FAINT,
  FIRST,
  INK,
  MARGINS,
  NAMED,
  SECOND,
  alongAxis,
  draw,
  figure,
  fromZero,
  head,
  line,
  ofPressure,
  pinnedKey,
  pinnedLine,
  reading,
  uprightAxis,
} from "./chart.js";
import { byId } from "./elements.js";
import { degrees } from "./polar.js";
import { amount } from "./units.js";

const RINGS = /** @type {const} */ (["inner", "outer"]);
const COLOURS = { inner: FIRST, outer: SECOND };
const DASHES = { inner: undefined, outer: "5 3" };
const KEY = /** @type {[string, string][]} */ ([
  ["first", "inner ring"],
  ["second dashed", "outer ring"],
]);
// The relief is drawn up to this multiple of what it is at the ends of the contact.
const [AT_ENDS, SHALLOWEST] = [1.3, 1]; // -, um

/**
 * @typedef {{
 *   y: (number | null)[], line_load: (number | null)[], touching: [number, number][],
 *   pressure?: (number | null)[], max_pressure?: number, max_pressure_y?: number, penetration_um?: number,
 *   unlimited?: boolean,
 * }} Contact
 */

/**
 * Draw all three.
 * @param {any} answer
 * @param {any} pressed the latest answer by strips, which pressures are drawn of; null if there is none
 * @param {number} roller
 * @param {any} pinned the answer to a pinned bearing, whose line loads are drawn beside; null if there is none
 */
export function drawRoller(answer, pressed, roller, pinned) {
  const row = answer.rows.find(({ first, count }) => roller >= first && roller < first + count);
  const several = answer.rows.length > 1 ? `, row ${answer.rows.indexOf(row) + 1}` : "";
  const most = roller === answer.most ? ", the most loaded" : "";
  byId("roller-name").textContent = `Roller ${roller + 1} at ${degrees(answer.angle[roller])}°${several}${most}`;
  const span = /** @type {[number, number]} */ ([-0.5 * row.length, 0.5 * row.length]);
  drawPressure(pressed, roller, span);
  drawLineLoad(answer, roller, span, pinned);
  drawRelief(answer, row, roller, span);
}

function drawPressure(pressed, roller, span) {
  const host = figure("pressure");
  host.hidden = pressed === null;
  if (!pressed) return;
  const contacts = contactsOf(pressed, roller);
  const largest = Math.max(0, ...contacts.map(([, { max_pressure }]) => max_pressure));
  const cut = contacts.some(([, { unlimited }]) => unlimited);
  const { top, clamped, remark } = ofPressure(largest, cut, [[largest]]);
  head(host, "Pressure on the centre line", KEY, remark || "by strips");
  draw(
    host,
    {
      ...MARGINS,
      height: 190,
      x: alongAxis(span, false),
      y: uprightAxis(top, "p₀", "MPa"),
      marks: [
        Plot.ruleY([0], { stroke: INK, strokeWidth: 0.8 }),
        ...contacts.map(([ring, { y, pressure }]) => along(ring, y, clamped(pressure))),
        ...contacts.map(([ring, each]) =>
          Plot.dot([[each.max_pressure_y, each.max_pressure]], { r: 3, fill: COLOURS[ring] }),
        ),
        ...contacts
          .slice(0, 1)
          .flatMap(([, { y, pressure }]) =>
            reading(y, clamped(pressure), (place) => readout(contacts, y[place], "pressure", "p₀", "MPa")),
          ),
        ...nothing(contacts, span, top[1]),
      ],
    },
    contacts.length ? pressureWords(contacts) : "The roller bears no load.",
  );
}

function pressureWords(contacts) {
  const words = contacts.map(([ring, each]) => `at most ${amount(each.max_pressure, "MPa")} at the ${ring} ring`);
  return `Pressure along the roller: ${words.join(", ")}.`;
}

function drawLineLoad(answer, roller, span, pinned) {
  const contacts = contactsOf(answer, roller);
  const before = pinned ? contactsOf(pinned, roller) : [];
  const top = fromZero([...contacts, ...before].map(([, { line_load }]) => line_load), 1.15);
  const host = figure("line");
  head(host, "Line load", [...KEY, ...pinnedKey(pinned)], `by ${answer.method}`);
  draw(
    host,
    {
      ...MARGINS,
      height: 120,
      x: alongAxis(span, false),
      y: uprightAxis(top, "q", "N/mm", { ticks: 3 }),
      marks: [
        Plot.ruleY([0], { stroke: INK, strokeWidth: 0.8 }),
        ...before.flatMap(([, { y, line_load }]) => pinnedLine(y, line_load)),
        ...contacts.map(([ring, { y, line_load }]) => along(ring, y, line_load)),
        ...nothing(contacts, span, top[1]),
      ],
    },
    contacts.length
      ? `Line load along the roller by ${answer.method}, largest ${amount(top[1] / 1.15, "N/mm")}.`
      : "The roller bears no load.",
  );
}

function drawRelief(answer, row, roller, span) {
  const contacts = contactsOf(answer, roller);
  const shown = Math.max(
    SHALLOWEST,
    ...contacts.map(([ring, each]) => {
      const { y, relief_um: um } = row.relief[ring];
      const pressed = (place) => each.touching.some(([low, high]) => low <= place && place <= high);
      const within = um.filter((value, place) => value !== null && pressed(y[place]));
      return Math.max(AT_ENDS * Math.max(0, ...within), 0.2 * (each.penetration_um ?? 0));
    }),
    ...(contacts.length ? [] : [0.5 * d3.median(row.relief.inner.relief_um.filter((each) => each !== null))]),
  );
  const host = figure("relief");
  head(host, "Relief of roller and ring", KEY, contacts.length ? "bars: where they touch" : "");
  draw(
    host,
    {
      ...MARGINS,
      marginBottom: NAMED,
      height: 150,
      x: alongAxis(span),
      y: uprightAxis([-0.06 * shown, 1.2 * shown], "relief", "µm", { ticks: 4, reverse: true }),
      marks: [
        Plot.ruleY([0], { stroke: FAINT, strokeWidth: 0.6 }),
        ...RINGS.map((ring) => along(ring, row.relief[ring].y, row.relief[ring].relief_um)),
        ...contacts.flatMap(([ring, { touching }], place) =>
          touching.map(([low, high]) =>
            Plot.link([0], {
              x1: low,
              x2: high,
              y1: (1.1 + 0.06 * place) * shown,
              y2: (1.1 + 0.06 * place) * shown,
              stroke: COLOURS[ring],
              strokeWidth: 3,
            }),
          ),
        ),
      ],
    },
    "Relief of the roller and each ring together along the roller.",
  );
}

/** The contacts of a roller that bear load, with their rings. @returns {[("inner" | "outer"), any][]} */
function contactsOf(answer, roller) {
  return RINGS.map((ring, place) => [ring, answer.contacts[roller]?.[place]]).filter(([, each]) => each);
}

function along(ring, y, values) {
  return line(y, values, { stroke: COLOURS[ring], strokeDasharray: DASHES[ring], clip: true });
}

function readout(contacts, at, name, symbol, unit) {
  const values = contacts.map(([ring, each]) => {
    const place = d3.minIndex(each.y, (y) => (y === null ? Infinity : Math.abs(y - at)));
    return `${symbol} ${amount(each[name][place], unit)}, ${ring}`;
  });
  return [`y  ${amount(at, "mm")}`, ...values].join("\n");
}

function nothing(contacts, span, top) {
  if (contacts.length) return [];
  return [Plot.text([[0.5 * (span[0] + span[1]), 0.5 * top]], { text: ["no load"], fill: FAINT, fontSize: 13 })];
}
