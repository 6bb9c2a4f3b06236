// The page: what happens when something is edited, answered, pinned, opened or shared.

import { watchHelp, watchKeys } from "./anywhere.js";
import { Edits } from "./edits.js";
import { Curve } from "./curve.js";
import { watchDrops } from "./drops.js";
import { byId } from "./elements.js";
import { opened, saved } from "./files.js";
import { Form } from "./form.js";
import { Address, shared } from "./link.js";
import { AWAY, Live, post } from "./live.js";
import { Measured } from "./measured.js";
import { showMistakes } from "./mistakes.js";
import { drawProfiles, placeProfiles } from "./profiles.js";
import { notice, roundTrip, watchProgram } from "./status.js";
import { Strength } from "./strength.js";
import { watchUnits } from "./units.js";
import { View } from "./view.js";

const start = JSON.parse(byId("start").textContent);
const view = new View();
const address = new Address();

const STILL = 150; // ms after the last answer before coarsely drawn stresses are redrawn finely
let refining = 0;

const live = new Live({
  answered(answer, { document, since }, stress) {
    const begun = performance.now();
    if (answer.ok) view.show(document, answer);
    else view.refuse(document, answer);
    if (stress) showStress(answer, false);
    if (answer.ok) curve.at(document, answer.key);
    roundTrip(since, begun, answer);
  },
  stressed(answer) {
    showStress(answer, true);
    searchStrength(answer.section !== undefined);
    document.documentElement.dataset.state = "settled";
  },
  waiting() {
    window.clearTimeout(refining);
    strength.forget();
    document.documentElement.dataset.state = "solving";
    byId("stress-figures").classList.add("stale");
  },
  rested(complete) {
    if (live.latest) curve.rested();
    if (complete) {
      refining = window.setTimeout(() => view.drawStress(), STILL);
      searchStrength(Boolean(view.latest?.stressed));
    }
    if (complete || !view.shownBody() || !live.latest) document.documentElement.dataset.state = "settled";
  },
  trouble: (sentence) => notice("program", sentence),
  stress: () => view.shownBody(),
});

function showStress(answer, fine) {
  byId("stress-figures").classList.remove("stale");
  if (answer.ok) view.stress(answer, fine);
}

const strength = new Strength((largest) => view.searched(largest));

/** Ask whether the body that is shown bears it. @param {boolean} stressed whether it has stresses */
function searchStrength(stressed) {
  const body = view.shownBody();
  if (!live.latest) return; // what is shown of the last good case stays, dimmed
  if (stressed && body) strength.wait(live.latest.document, body);
  else strength.hide();
}

const curve = new Curve(byId("case"));

const form = new Form(start.document, {
  edited(document, since) {
    notice("link", "");
    edits.note(document);
    address.keep(document, view.pinned?.document ?? null);
    live.want(document, since);
  },
  fresh: freshForm,
  drawn() {
    curve.offer();
    placeProfiles((body) => measured.open(body));
    drawProfiles(view.profiles, view.pinned?.answer.profiles);
  },
});

const edits = new Edits(start.document, () => {
  byId("undo").disabled = !edits.can(-1);
  byId("redo").disabled = !edits.can(1);
});

const measured = new Measured({
  most: start.limits.upload_bytes,
  use(body, table) {
    const changed = structuredClone(form.document);
    changed.body[body].profile = [table];
    void form.open(changed);
  },
});

/** Request the form of a case. */
async function freshForm(document) {
  try {
    const response = await post("form", { document });
    if (response.ok) return await response.text();
    showMistakes((await response.json()).mistakes);
  } catch {
    notice("program", AWAY);
  }
  return null;
}

async function step(by) {
  const document = edits.step(by);
  if (document) await form.open(document);
}

/** Solve and pin a case that came with a link. */
async function pinShared(document) {
  const body = view.shownBody();
  try {
    const response = await post("solve", { document, stress: body !== null, body: body ?? "a" });
    const answer = await response.json();
    if (answer.ok) view.pin({ document, answer, stressed: answer.section ? answer : null });
    else notice("link", `The pinned case in the link cannot be shown: ${answer.mistakes[0]?.sentence}`);
  } catch {
    notice("link", AWAY);
  }
}

function togglePin() {
  view.pin(view.pinned || !view.latest ? null : view.latest);
  address.keep(form.document, view.pinned?.document ?? null);
}

async function copyLink() {
  const link = await address.put(form.document, view.pinned?.document ?? null);
  const button = byId("share");
  try {
    await navigator.clipboard.writeText(link);
    button.textContent = "Copied";
  } catch {
    button.textContent = "Copy from the address bar"; // no access to the clipboard
  }
  window.setTimeout(() => (button.textContent = "Copy link"), 2000);
}

async function download(name) {
  byId("downloads").open = false;
  notice("download", `${name} is being written …`);
  try {
    const mistakes = await saved(`download/${name}`, form.document);
    if (mistakes.length) showMistakes(mistakes);
  } catch {
    notice("program", AWAY); // until the next answer
  }
  notice("download", "");
}

async function openFile(file) {
  try {
    const { document, mistakes } = await opened(file, start.limits.document_bytes);
    if (!document) showMistakes(mistakes);
    else await form.open(document);
  } catch {
    notice("program", AWAY);
  }
}

/** Show everything in the units that are chosen now. */
async function reread() {
  await form.open(form.document);
  curve.reread();
  if (view.pinned) await pinShared(view.pinned.document);
}

/** Start from a machine element. @param {string} name */
async function startFrom(name) {
  byId("templates").open = false;
  try {
    const response = await fetch(`template/${name}`);
    await form.open((await response.json()).document);
  } catch {
    notice("program", AWAY);
  }
}

function wire() {
  /** @type {HTMLElement} */ (document.querySelector(".skip")).addEventListener("click", (event) => {
    event.preventDefault(); // the fragment of the address holds the case
    byId("results").focus();
  });
  byId("undo").addEventListener("click", () => void step(-1));
  byId("redo").addEventListener("click", () => void step(1));
  byId("pin").addEventListener("click", togglePin);
  byId("show-pinned").addEventListener("click", () => view.pinned && void form.open(view.pinned.document));
  byId("share").addEventListener("click", () => void copyLink());
  byId("open").addEventListener("click", () => byId("open-file").click());
  byId("open-file").addEventListener("change", ({ target }) => {
    if (target.files[0]) void openFile(target.files[0]);
    target.value = ""; // the same file may be opened again
  });
  for (const button of /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll("[data-download]"))) {
    button.addEventListener("click", () => void download(button.dataset.download ?? ""));
  }
  for (const button of /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll("[data-template]"))) {
    button.addEventListener("click", () => void startFrom(button.dataset.template ?? ""));
  }
  for (const choice of document.querySelectorAll("[name=stress-unit]"))
    choice.addEventListener("change", () => view.drawStress());
  for (const choice of document.querySelectorAll("[name=stress-body], #stress-on")) {
    choice.addEventListener("change", () => {
      if (view.shownBody()) strength.forget();
      else strength.hide();
      view.redraw();
      live.wantStress();
    });
  }
  watchKeys((by) => void step(by));
  watchUnits(() => void reread());
  watchDrops({
    isTable: (path) => form.isTable(path),
    open: (file) => void openFile(file),
    table: (path, table) => form.tabulate(path, table),
    measured: (event, body) => measured.dropped(event, body),
    refuse: (mistake) => showMistakes([mistake]),
  });
  window.addEventListener("hashchange", () => void fromLink());
}

/** Show the case in the address, if it holds one. */
async function fromLink() {
  try {
    const found = await shared(window.location.hash);
    if (!found) return false;
    if (found.pinned) void pinShared(found.pinned);
    return await form.open(found.document);
  } catch (error) {
    notice("link", /** @type {Error} */ (error).message);
    return false;
  }
}

wire();
if (window.matchMedia("(max-width: 900px)").matches) byId("editor").open = false;
watchHelp();
void watchProgram((sentence) => notice("compiling", sentence));
if (await fromLink()) edits.restart(form.document);
else live.want(start.document);
