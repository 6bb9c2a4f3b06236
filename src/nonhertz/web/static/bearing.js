// The page of a bearing: solved by slices at every edit, by strips when the slider rests.

import { watchCatalogue } from "./catalogue.js";
import { figure, head, pinnedAs, whenResized } from "./chart.js";
import { noteNumbers } from "./csv.js";
import { byId } from "./elements.js";
import { AWAY, Live, answerTo, post } from "./live.js";
import { fragment } from "./link.js";
import { showMistakes } from "./mistakes.js";
import { drawPanels } from "./panel.js";
import { html, render } from "./preact.js";
import { Polar } from "./polar.js";
import { Columns, cells, outdate, refuse, writeKeyNumbers, writeWords } from "./results.js";
import { notice, sayState, timed } from "./status.js";
import { Work } from "./work.js";

const REST = 250; // ms without a change before strips are asked for
const HELD = 600; // ms after the last key, while a slider is moved by keys
/** @type {[string, string][]} */
const POLAR_KEY = [
  ["bar-inner", "inner ring"],
  ["bar-outer", "outer ring"],
];
const SLICED = "solved by slices of ISO/TS 16281";
const root = document.documentElement;

/** What is on the page. */
const page = {
  /** @type {any} the latest good answer, and what was asked */
  answer: null,
  document: null,
  /** @type {import("./types.js").Pin[]} */
  pins: [],
  /** @type {any} the latest by strips, its document, and whether it is that of the bearing as it is now */
  pressed: null,
  pressedOf: null,
  fresh: false,
  /** @type {number | null} the roller that was chosen; null for the most loaded one */
  chosen: history.state?.roller ?? null,
  moved: 0, // when a slider was last moved by a key
};

/** Slices at every edit, strips when the hand rests. */
const live = new Live({
  request: (document, more) => ["bearing/solve", { document, method: more ? "strips" : "slices", roller: page.chosen }],
  wish: () => (page.answer?.file_method === "strips" ? "strips" : null),
  together: false,
  rest: REST,
  isBusy: () => work.edits.dragging || performance.now() - page.moved < HELD,
  counted: `${SLICED}, strips are being solved`,
  answered(answer, { document, since }) {
    const begun = performance.now();
    page.fresh = false;
    if (answer.ok) show(answer, document);
    else refuse(Boolean(page.answer), answer.mistakes);
    timed(since, begun, () => saySlices(answer));
  },
  more(answer, { document }) {
    if (answer.ok) {
      page.pressed = answer;
      page.pressedOf = document;
      page.fresh = true;
      show(answer, document);
      sayState("solved by strips");
    } else {
      showMistakes(answer.mistakes);
      stay("No result by strips");
    }
    root.dataset.state = "settled";
  },
  waiting(more) {
    if (more) sayState(`${SLICED}, strips are being solved …`);
    else root.dataset.state = "solving";
  },
  rested() {
    root.dataset.state = live.latest && live.page.wish() ? "sliced" : "settled";
  },
  gaveUp(sentence, more) {
    if (more) stay(sentence);
    else outdate(Boolean(page.answer), sentence);
    root.dataset.state = "settled";
  },
});

/** Stay with slices. @param {string} why */
function stay(why) {
  sayState(`${SLICED}. ${why}`);
}

function show(answer, shown) {
  page.answer = answer;
  page.document = shown;
  showMistakes([]);
  writeWords(answer, pressedBefore());
  writeTolerances(answer);
  work.drawProfiles(answer.profiles);
  drawPictures();
}

function saySlices(answer) {
  if (!answer.ok || page.fresh) return; // fresh: strips have answered already
  sayState(SLICED + (answer.file_method === "strips" ? ", strips follow when the slider rests" : ""));
}

/** The roller whose lines are drawn. */
function roller() {
  const { answer, chosen } = page;
  return chosen !== null && chosen < answer.angle.length ? chosen : answer.most;
}

/** The latest result by strips with as many rollers, while the result shown is by slices. */
function pressedBefore() {
  const { answer, pressed, fresh } = page;
  return !fresh && pressed?.angle.length === answer.angle.length && answer.file_method === "strips" ? pressed : null;
}

function drawPictures() {
  const { answer } = page;
  if (!answer) return;
  const before = pressedBefore();
  writeKeyNumbers(keyNumbers(answer, before), page.pins.map((pin) => ({ ...pin, numbers: pin.answer.numbers })));
  const number = roller();
  noteNumbers(figure("polar"), answer.loads);
  head(figure("polar"), "Loads of all rollers", POLAR_KEY, `by ${answer.method}`);
  polar.draw(answer, number);
  drawRoller(answer, before, number);
  drawMaps(before ?? answer, number);
  drawFilms(answer, number);
  const stale = figure("pressure");
  stale.classList.toggle("stale", !page.fresh);
  stale.title = page.fresh ? "" : "From before the last change: strips are solved when the slider rests.";
  byId("most").hidden = page.chosen === null || number === answer.most;
  writeRollers(answer, number);
  offerContacts(number);
}

/**
  * Draw load and pressure along a roller; pressures are by strips, if need be those before the last change.
 * @param {any} answer
 * @param {any} before
 * @param {number} number
 */
function drawRoller({ lines }, before, number) {
  const [pin] = page.pins;
  const isPressure = ({ name }) => name === "pressure";
  const pressures = (before ?? page.answer).lines.panels.filter(isPressure);
  [byId("roller-name").textContent] = lines.conditions.split(";");
  figure("pressure").hidden = !pressures.length;
  const drawn = { ...lines, panels: [...pressures, ...lines.panels.filter((panel) => !isPressure(panel))] };
  drawPanels(drawn, pin?.answer.shown === number ? pin.answer.lines : undefined, { last: "relief", pinnedAs: pinnedAs(page.pins) });
  void askLines(page.answer, page.document, number);
  void askLines(page.pressed, page.pressedOf, number);
  if (pin) void askLines(pin.answer, pin.document, number);
}

/** Ask for the lines of a roller where an answer has those of another: of one at a time, the last one that is wanted. */
async function askLines(answer, document, number) {
  if (!answer || number >= answer.angle.length) return;
  const asks = answer.wanted !== undefined;
  if (!asks && answer.shown === number) return;
  answer.wanted = number;
  while (!asks && answer.wanted !== answer.shown) {
    const more = await answerTo("bearing/roller", { document, method: answer.method, roller: answer.wanted });
    if (!more?.ok) break;
    [answer.shown, answer.lines] = [more.shown, more.lines];
  }
  if (asks) return;
  answer.wanted = undefined;
  if (roller() === answer.shown) drawPictures();
}

/** Draw the pressures of all rollers in the row of the one that is shown, by strips. @param {any} answer @param {number} number */
function drawMaps({ maps, ridges, rows }, number) {
  const row = rows.findIndex(({ first, count }) => first <= number && number < first + count);
  byId("maps").hidden = !maps;
  byId("maps").classList.toggle("stale", !page.fresh);
  const ofRow = (drawn) => ({ ...drawn, panels: drawn.panels.slice(2 * row, 2 * row + 2) });
  if (maps) drawPanels(ofRow(maps), undefined, { last: "map-outer" });
  if (maps) drawPanels(ofRow(ridges), undefined, { last: "ridges-outer" });
}

/** Draw the films over the row of the roller that is shown, and along the roller with the minimum film. @param {any} answer @param {number} number */
function drawFilms({ films, rows }, number) {
  byId("films").hidden = !films.film;
  if (!films.film) return;
  const row = rows.findIndex(({ first, count }) => first <= number && number < first + count);
  drawPanels({ ...films.film, panels: [{ ...films.film.panels[row], name: "film" }] }, undefined, { last: "film" });
  drawPanels(films["film-along"], undefined, { last: "film-along" });
}

/** Show a roller, or the most loaded one. @param {number | null} number */
function choose(number) {
  page.chosen = number;
  drawPictures();
  work.keep();
}

/** The numbers on top, with the pressure of the bearing before the last change where it is that of strips. */
function keyNumbers({ numbers: [pressure, ...others] }, before) {
  return [before ? { ...before.numbers[0], stale: true } : pressure, ...others];
}

function writeTolerances({ tolerances }) {
  const section = byId("tolerances");
  section.hidden = !tolerances;
  const { columns, rows } = tolerances ?? { columns: [], rows: [] };
  const lines = rows.map((row) => html`<tr>${cells(row)}</tr>`);
  render(html`<${Columns} heads=${columns}>${lines}<//>`, section.querySelector("table"));
}

function writeRollers({ columns, rollers }, number) {
  const shown = d3.range(columns.length).filter((place) => rollers.some((row) => row[place] !== ""));
  const line = (row, place) =>
    html`<tr class=${place === number ? "chosen" : ""} data-roller-row=${place} onClick=${() => choose(place)}>
      ${cells(d3.permute(row, shown))}</tr>`;
  render(html`<${Columns} heads=${d3.permute(columns, shown)}>${rollers.map(line)}<//>`, byId("rollers"));
}

const polar = new Polar(byId("polar"), choose);
const start = JSON.parse(byId("start").textContent);
const work = new Work(start, {
  what: "bearing",
  at: "bearing/",
  bodies: { roller: "roller", inner: "inner", outer: "outer" },
  want: (document, since) => live.want(document, since),
  latest: () => page.answer && { document: page.document, answer: page.answer },
  pin(pins) {
    page.pins = pins;
    drawPictures();
  },
  again: ({ document, answer }) => show(answer, document),
  solve: async (document) => (await post("bearing/solve", { document })).json(),
  looked: () => ({ roller: page.chosen }),
  begun() {
    // The roller that was chosen, and what was drawn, are those of another bearing.
    page.chosen = page.answer = page.pressed = null;
    byId("results").classList.add("empty");
  },
});

/** Open the contact of the roller that is shown on the page of single contacts. @param {"inner" | "outer"} ring */
async function openContact(ring) {
  notice("download", "The contact is being opened …");
  try {
    const response = await post("bearing/contact", { document: work.document, roller: roller(), ring });
    const answer = await response.json();
    if (answer.ok) {
      await work.put(); // to come back to
      window.location.assign(`contact${await fragment(answer.document)}`);
    } else showMistakes(answer.mistakes);
  } catch {
    notice("program", AWAY);
  }
  notice("download", "");
}

/** Enable the buttons that open the loaded contacts of a roller. @param {number} number */
function offerContacts(number) {
  for (const [place, ring] of ["inner", "outer"].entries()) {
    const button = /** @type {HTMLButtonElement} */ (document.querySelector(`[data-contact="${ring}"]`));
    button.disabled = !(page.answer.load[number][place] > 0);
  }
}

byId("case").addEventListener("keydown", ({ target }) => {
  if (target.matches(".slider")) page.moved = performance.now();
});
byId("most").addEventListener("click", () => choose(null));
for (const ring of /** @type {("inner" | "outer")[]} */ (["inner", "outer"]))
  document.querySelector(`[data-contact="${ring}"]`)?.addEventListener("click", () => void openContact(ring));
watchCatalogue(start.form.catalogue, async (data) => {
  try {
    const answer = await (await post("bearing/catalogue", { document: data })).json();
    if (!answer.ok) return answer.mistakes[0].sentence;
    await work.another(answer);
    return "";
  } catch {
    return AWAY;
  }
});
whenResized(drawPictures);
await work.begin();
