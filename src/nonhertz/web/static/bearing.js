// The page of a bearing: by slices at every edit, by strips when the hand rests.

import { watchHelp, watchKeys } from "./anywhere.js";
import { figure, head, whenResized } from "./chart.js";
import { Edits } from "./edits.js";
import { byId, element } from "./elements.js";
import { isOwnFile, saved } from "./files.js";
import { AWAY, post } from "./live.js";
import { Address, fragment, shared } from "./link.js";
import { showMistakes } from "./mistakes.js";
import { digits } from "./numbers.js";
import { Polar, degrees, newtons } from "./polar.js";
import { sayLater, writeKeyNumbers, writeRows } from "./results.js";
import { drawRoller } from "./roller.js";
import { Sliders } from "./sliders.js";
import { notice, timed, watchProgram } from "./status.js";
import { amount, parts, watchUnits } from "./units.js";

const start = JSON.parse(byId("start").textContent);
const REST = 250; // ms without a change before strips are asked for
const TYPING = 300; // ms without a key before the text of the file is read
const AGAIN = 1500; // ms between attempts to reach the program
/** @type {[string, string][]} */
const POLAR_KEY = [
  ["bar-inner", "inner ring"],
  ["bar-outer", "outer ring"],
];
const NO_MOTION = 1e-9; // mm: rounding
const root = document.documentElement;
const address = new Address();

/** What is on the page. */
const page = {
  /** @type {any} the bearing; null before the text has been read the first time */
  document: null,
  /** @type {any} the latest good answer */
  answer: null,
  /** @type {any} the latest by strips, and whether it is that of the bearing as it is now */
  pressed: null,
  fresh: false,
  /** @type {number | null} the roller that was chosen; null for the most loaded one */
  chosen: null,
};

/** @type {{given: object, since: number} | null} */
let next = null;
let busy = false;
let rest = 0;
/** @type {AbortController | null} */
let strips = null;

/** Solve by slices, now or as soon as the request in flight has been answered. */
function want(given, since = performance.now()) {
  next = { given, since };
  stopStrips();
  root.dataset.state = "solving";
  if (!busy) void run();
}

function stopStrips() {
  window.clearTimeout(rest);
  strips?.abort();
  strips = null;
}

async function run() {
  busy = true;
  let last = null;
  while (next) {
    const wanted = next;
    next = null;
    const begun = { drawing: 0 };
    const answer = await ask({ ...wanted.given, method: "slices" });
    if (!answer) {
      next ??= wanted;
      await new Promise((done) => window.setTimeout(done, AGAIN));
      continue;
    }
    begun.drawing = performance.now();
    page.fresh = false;
    answered(answer, wanted);
    timed(wanted.since, begun.drawing, (took) => saySlices(answer, took));
    last = answer;
  }
  busy = false;
  if (last?.ok && last.file_method === "strips") restSoon();
  else root.dataset.state = "settled";
}

function restSoon() {
  root.dataset.state = "sliced";
  rest = window.setTimeout(() => {
    if (sliders.held) restSoon();
    else void runStrips();
  }, REST);
}

async function runStrips() {
  const stop = new AbortController();
  strips = stop;
  const begun = performance.now();
  byId("state").textContent = "solved by slices of ISO/TS 16281";
  byId("round-trip").textContent = "while strips are being solved …";
  const answer = await ask({ document: page.document, method: "strips" }, stop.signal);
  if (stop.signal.aborted) return;
  if (!answer) {
    rest = window.setTimeout(() => void runStrips(), AGAIN);
    return;
  }
  strips = null;
  if (answer.ok) {
    page.pressed = answer;
    page.fresh = true;
    show(answer, performance.now());
    byId("state").textContent = "solved by strips";
    byId("round-trip").textContent = `in ${((performance.now() - begun) / 1e3).toFixed(1)} s`;
  } else {
    showMistakes(answer.mistakes);
    byId("state").textContent = "solved by slices of ISO/TS 16281; strips gave no answer";
    byId("round-trip").textContent = "";
  }
  root.dataset.state = "settled";
}

/** Return the program's answer, null if there is none, which a notice says. */
async function ask(body, signal) {
  try {
    const response = await post("bearing/solve", body, signal);
    if (response.status === 204) return null;
    const answer = await response.json();
    notice("program", response.status === 503 ? answer.mistakes[0].sentence : "");
    return response.status === 503 ? null : answer;
  } catch {
    if (!signal?.aborted) notice("program", `${AWAY} Trying again …`);
    return null;
  }
}

function answered(answer, { given, since }) {
  if (answer.document) {
    page.document = answer.document;
    keep();
  }
  // Not over what is being written.
  if (answer.text !== undefined && document.activeElement !== byId("text")) byId("text").value = answer.text;
  showMistakes(answer.ok ? [] : answer.mistakes.map(withUnit));
  byId("text").toggleAttribute("aria-invalid", !answer.ok && "text" in given);
  if (answer.sliders) sliders.show(answer.sliders, since);
  if (answer.ok) show(answer, since);
  else refuse(answer);
}

/** A mistake, with the unit of its field: the sentence is about the file, where a number alone is in mm or N. */
function withUnit({ path, sentence }) {
  const unit = sliders.unitOf(path);
  return { path, sentence: unit ? `${sentence} In this field a number alone is in ${unit}.` : sentence };
}

function show(answer, since) {
  page.answer = answer;
  byId("results").classList.remove("outdated");
  byId("case-title").textContent = answer.title;
  document.title = answer.title ? `${answer.title} – nonhertz` : "nonhertz";
  sliders.show(answer.sliders, since);
  writeKeys(answer);
  writeRows(answer.summary, answer.warnings);
  drawPictures();
  sayLater(spoken(answer));
}

function refuse({ mistakes }) {
  byId("results").classList.add("outdated");
  byId("state").textContent = page.answer ? "last good result" : "no result yet";
  byId("round-trip").textContent = "";
  sayLater(`${mistakes.length} mistake${mistakes.length > 1 ? "s" : ""}: ${mistakes[0]?.sentence ?? ""}`);
}

function saySlices(answer, took) {
  if (!answer.ok) return;
  if (page.fresh) return; // strips are there already
  byId("state").textContent = "solved by slices of ISO/TS 16281";
  const then = answer.file_method === "strips" ? "; strips follow when the slider rests" : "";
  byId("round-trip").textContent =
    `in ${Math.round(took)} ms, ${Math.round(answer.ms)} ms of it in the solver${then}`;
}

/** The roller whose lines are drawn. */
function roller() {
  const { answer, chosen } = page;
  return chosen !== null && chosen < answer.angle.length ? chosen : answer.most;
}

function drawPictures() {
  const { answer, pressed } = page;
  if (!answer) return;
  const number = roller();
  const fits = pressed && pressed.angle.length === answer.angle.length && answer.file_method === "strips";
  head(figure("polar"), "Loads of all rollers", POLAR_KEY, `by ${answer.method}`);
  polar.draw(answer, number);
  drawRoller(answer, fits ? pressed : null, number);
  const stale = figure("pressure");
  stale.classList.toggle("stale", !page.fresh);
  stale.title = page.fresh ? "" : "Of the bearing before the last change: strips are solved when the slider rests.";
  byId("most").hidden = page.chosen === null || number === answer.most;
  writeRollers(answer, number);
  offerContacts(number);
}

/** Show a roller, or the most loaded one. @param {number | null} number */
function choose(number) {
  page.chosen = number;
  drawPictures();
  remember();
}

function writeKeys(answer) {
  writeKeyNumbers([mostLoad(answer), displacement(answer), loaded(answer), pressure(answer), life(answer)], null);
}

function mostLoad({ key, angle, most }) {
  const [value, unit] = newtons(key.load).split(" ");
  const where = key.load > 0 ? `roller ${most} at ${degrees(angle[most])}°` : "";
  return { name: "Largest load of a roller", value, unit, where, number: key.load };
}

function displacement({ key }) {
  const [along, ...across] = key.displacement.slice(0, 3);
  const number = Math.hypot(...across);
  const where =
    Math.abs(along) > NO_MOTION ? `radial; axial ${amount(1e3 * along, "µm", 3)}` : "radial, of the inner ring";
  return { name: "Displacement", ...parts(1e3 * number, "µm"), where, number };
}

function loaded({ key }) {
  const { loaded: number, rollers } = key;
  return { name: "Loaded rollers", value: String(number), unit: `of ${rollers}`, where: "", number };
}

function pressure({ key, method }) {
  const { max_pressure: number, at } = key;
  const name = "Largest pressure";
  if (number === null) return { name, value: "–", unit: "", where: method === "slices" ? "by strips only" : "", number };
  return { name, ...parts(number, "MPa"), where: `roller ${at[0]}, ${at[1]} ring`, number };
}

function life({ key, method }) {
  const { life: number } = key;
  const name = "Modified life";
  if (number === null) return { name, value: "–", unit: "", where: "", number };
  return { name, value: digits(number, 3), unit: "10⁶ rev", where: `by ${method}`, number };
}

function writeRollers({ columns, rollers }, number) {
  const shown = columns.map((_, place) => place).filter((place) => rollers.some((row) => row[place] !== ""));
  const cells = (row, name) => shown.map((place) => element(name, name === "th" ? { scope: "col" } : {}, [row[place]]));
  const line = (row, place) => {
    const attributes = { class: place === number ? "chosen" : "", "data-roller-row": String(place) };
    return element("tr", { ...attributes, click: () => choose(place) }, cells(row, "td"));
  };
  const table = byId("rollers");
  table.querySelector("thead").replaceChildren(element("tr", {}, cells(columns, "th")));
  table.querySelector("tbody").replaceChildren(...rollers.map(line));
}

function spoken({ key, method }) {
  const largest = key.max_pressure === null ? "" : `, largest pressure ${amount(key.max_pressure, "MPa")}`;
  const few = `${key.loaded} of ${key.rollers} rollers loaded`;
  return `By ${method}: largest load of a roller ${newtons(key.load)}, ${few}${largest}`;
}

let first = true;
function keep() {
  if (first) edits.restart(page.document);
  else edits.note(page.document);
  first = false;
  remember();
}

/** Keep the bearing, and which roller is looked at. */
function remember() {
  address.keep(page.document, null, { roller: page.chosen });
}

function change(changed) {
  if (!page.document) return;
  page.document = changed;
  keep();
  want({ document: changed });
}

const polar = new Polar(byId("polar"), choose);
const sliders = new Sliders(byId("sliders"), (by) => page.document && change(by(page.document)));
const edits = new Edits(null, () => {
  byId("undo").disabled = !edits.can(-1);
  byId("redo").disabled = !edits.can(1);
});

function step(by) {
  const document = edits.step(by);
  if (!document) return;
  page.document = document;
  remember();
  want({ document });
}

async function download(name) {
  byId("downloads").open = false;
  notice("download", `${name} is being made …`);
  try {
    const mistakes = await saved(`bearing/download/${name}`, page.document);
    if (mistakes.length) showMistakes(mistakes);
  } catch {
    notice("program", AWAY);
  }
  notice("download", "");
}

/** Open the contact of the roller that is shown on the page of single contacts. @param {"inner" | "outer"} ring */
async function openContact(ring) {
  notice("download", "The contact is being opened …");
  try {
    const response = await post("bearing/contact", { document: page.document, roller: roller(), ring });
    const answer = await response.json();
    if (answer.ok) {
      await address.put(page.document, null, { roller: page.chosen }); // to come back to
      window.location.assign(`contact${await fragment(answer.document, null)}`);
    } else showMistakes(answer.mistakes);
  } catch {
    notice("program", AWAY);
  }
  notice("download", "");
}

/** Offer those contacts of a roller that bear load. @param {number} number */
function offerContacts(number) {
  for (const [place, ring] of ["inner", "outer"].entries()) {
    const button = /** @type {HTMLButtonElement} */ (document.querySelector(`[data-contact="${ring}"]`));
    button.disabled = !(page.answer.load[number][place] > 0);
  }
}

async function openFile(file) {
  if (file.size > start.limits.document_bytes) {
    const most = Math.floor(start.limits.document_bytes / 1024);
    const sentence = `${file.name} must be a bearing file of at most ${most} kB: choose another file.`;
    showMistakes([{ path: "", sentence }]);
    return;
  }
  read(await file.text());
}

/** Take the text of a bearing file. @param {string} text */
function read(text) {
  byId("text").value = text;
  page.chosen = null; // it was one of another bearing
  want({ text });
}

/** Start from a kind of bearing. @param {string} name */
async function startFrom(name) {
  byId("templates").open = false;
  try {
    const response = await fetch(`bearing/template/${name}`);
    read((await response.json()).text);
  } catch {
    notice("program", AWAY);
  }
}

function wire() {
  let typing = 0;
  byId("text").addEventListener("input", ({ target }) => {
    window.clearTimeout(typing);
    const since = performance.now();
    typing = window.setTimeout(() => want({ text: target.value }, since), TYPING);
  });
  byId("case").addEventListener("submit", (event) => event.preventDefault());
  /** @type {HTMLElement} */ (document.querySelector(".skip")).addEventListener("click", (event) => {
    event.preventDefault(); // the fragment of the address holds the bearing
    byId("results").focus();
  });
  byId("undo").addEventListener("click", () => step(-1));
  byId("redo").addEventListener("click", () => step(1));
  byId("most").addEventListener("click", () => choose(null));
  byId("open").addEventListener("click", () => byId("open-file").click());
  byId("open-file").addEventListener("change", ({ target }) => {
    if (target.files[0]) void openFile(target.files[0]);
    target.value = ""; // the same file may be opened again
  });
  for (const ring of /** @type {("inner" | "outer")[]} */ (["inner", "outer"]))
    document.querySelector(`[data-contact="${ring}"]`)?.addEventListener("click", () => void openContact(ring));
  for (const button of /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll("[data-download]")))
    button.addEventListener("click", () => void download(button.dataset.download ?? ""));
  for (const button of /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll("[data-template]")))
    button.addEventListener("click", () => void startFrom(button.dataset.template ?? ""));
  document.addEventListener("dragover", (event) => event.preventDefault());
  document.addEventListener("drop", (event) => {
    event.preventDefault(); // a browser would leave the page for the file
    const file = event.dataTransfer?.files[0];
    if (file && isOwnFile(file)) void openFile(file);
    else if (file) showMistakes([{ path: "", sentence: `${file.name} must be a bearing file, .toml: drop one.` }]);
  });
  window.addEventListener("hashchange", () => void fromLink());
  watchKeys(step);
  watchUnits(() => page.document && want({ document: page.document }));
  watchHelp();
  whenResized(drawPictures);
}

/** Show the bearing in the address, if it holds one. */
async function fromLink() {
  try {
    const found = await shared(window.location.hash);
    if (!found) return false;
    page.document = found.document;
    page.chosen = history.state?.roller ?? null;
    keep();
    want({ document: page.document });
    return true;
  } catch (error) {
    notice("link", /** @type {Error} */ (error).message);
    return false;
  }
}

wire();
if (window.matchMedia("(max-width: 900px)").matches) byId("editor").open = false;
void watchProgram((sentence) => notice("compiling", sentence), "bearing/status");
if (!(await fromLink())) read(start.text);
