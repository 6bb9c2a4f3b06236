// What the page shows: the latest good result, those that are pinned, and what is wrong now.

import { figure, pinnedAs, whenResized } from "./chart.js";
import { FINE, QUICK } from "./contours.js";
import { byId } from "./elements.js";
import { showMistakes } from "./mistakes.js";
import { drawPanels } from "./panel.js";
import { entitle, keyNumbers, outdate, refuse, writeKeyNumbers, writeVerdict, writeWords } from "./results.js";
import { sayState } from "./status.js";
import { Tilt } from "./tilt.js";

/** @typedef {import("./types.js").Answer} Answer */
/** @typedef {{document: object, answer: Answer, stressed?: Answer | null}} Result a case with its answers */

export class View {
  /** @param {(profiles: any) => void} drawProfiles */
  constructor(drawProfiles) {
    this.drawProfiles = drawProfiles;
    /** @type {Result | null} */
    this.latest = null;
    /** @type {import("./types.js").Pin[]} */
    this.pins = [];
    /** @type {import("./types.js").Profiles | undefined} */
    this.profiles = undefined;
    this.tilt = new Tilt(figure("gap"), () => this.drawResult());
    whenResized(() => this.redraw());
  }

  /** Show a good result. @param {object} document @param {Answer} answer */
  show(document, answer) {
    showMistakes([]);
    this.profiles = answer.profiles;
    // Stresses of the previous case stay, dimmed, until those of this one arrive.
    this.latest = { document, answer, stressed: this.latest?.stressed ?? null };
    this.drawResult();
    writeWords(answer);
  }

  /**
   * Show what is wrong; the last good result stays, dimmed.
   * @param {any} document
   * @param {import("./types.js").Refusal} refusal
   */
  refuse(document, refusal) {
    if (!this.latest) entitle(typeof document.title === "string" ? document.title : "");
    refuse(Boolean(this.latest), refusal.mistakes);
    this.profiles = refusal.profiles;
    this.drawProfiles(this.profiles);
  }

  /** Dim the last good result, which is not that of the case. @param {string} why */
  outdate(why) {
    outdate(Boolean(this.latest), why);
  }

  /** Another case is begun: the last one is taken away. */
  clear() {
    this.latest = null;
    byId("results").classList.add("empty");
    sayState("solving");
  }

  /** Show the stresses of the latest result. @param {Answer} answer @param {boolean} fine whether on the fine grid */
  stress(answer, fine = true) {
    if (!this.latest) return;
    this.latest.stressed = answer.planes ? answer : null; // none without contact, or where the solver stopped short
    byId("stress-note").textContent = answer.stress_note ?? "";
    this.drawStress(fine);
    this.writeKeys();
  }

  /**
   * Show the largest stress of the whole body, the plane through it, and the verdict that it decides.
   * @param {any} found without if there is none
   */
  searched({ stress, planes, verdict }) {
    if (!this.latest?.stressed || !stress) return;
    this.latest.answer.verdict = verdict;
    writeVerdict(verdict);
    this.latest.stressed = { ...this.latest.stressed, stress, planes };
    this.drawStress();
    this.writeKeys();
  }

  /** Show what is pinned. @param {import("./types.js").Pin[]} pins */
  pin(pins) {
    // What was solved for a link has its stresses in the answer itself.
    this.pins = pins.map((pin) => ({ stressed: pin.answer.planes ? pin.answer : null, ...pin }));
    this.redraw();
  }

  drawResult() {
    if (!this.latest) return;
    const { figures, key } = this.latest.answer;
    const before = this.pins[0]?.answer.figures;
    const how = { pinnedAs: pinnedAs(this.pins) };
    drawPanels(figures.pressure, before?.pressure, how);
    drawPanels(figures.footprint, undefined);
    const undeformed = figures.distance.panels[0].marks.find(({ name }) => name === "undeformed");
    const placed = (axes) => this.tilt.place(/** @type {any} */ (undeformed), key.tilt, axes);
    drawPanels(figures.distance, before?.distance, { ...how, limits: this.tilt.limits, last: "gap", placed });
    this.drawProfiles(this.profiles);
    this.writeKeys();
  }

  /** Draw the von Mises stress in both planes. @param {boolean} [fine] whether there is time for the fine grid */
  drawStress(fine = true) {
    const { planes, key } = this.latest?.stressed ?? {};
    byId("stress-figures").hidden = !this.shownBody() || !planes;
    if (!planes || !this.shownBody()) return;
    const isShare = document.querySelector("[name=stress-unit][value=p0]:checked");
    const share = { factor: 1 / (key.max_pressure || 1), unit: "", title: "von Mises stress / maximum p₀" };
    for (const plane of [planes.axial, planes.section]) {
      const [panel] = plane.panels;
      const colours = isShare ? { ...panel.colours, ...share } : panel.colours;
      drawPanels({ ...plane, panels: [{ ...panel, colours }] }, undefined, { last: panel.name, net: fine ? FINE : QUICK });
    }
  }

  redraw() {
    this.drawResult();
    this.drawStress();
  }

  /** The body whose stress is shown, null if none is. @returns {"a" | "b" | null} */
  shownBody() {
    const body = /** @type {HTMLInputElement} */ (document.querySelector("[name=stress-body]:checked")).value;
    return byId("stress-on").checked ? /** @type {"a" | "b"} */ (body) : null;
  }

  writeKeys() {
    if (!this.latest) return;
    const numbers = ({ answer, stressed }) => keyNumbers(answer, this.shownBody() ? stressed?.stress : undefined);
    writeKeyNumbers(numbers(this.latest), this.pins.map((pin) => ({ ...pin, numbers: numbers(pin) })));
  }
}
