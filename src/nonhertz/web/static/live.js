// Requesting solutions during a drag: one request in flight, the latest case next, every answer drawn.
//
// A request in flight is not aborted for a newer case until it has taken long: a slider gives a case every 16 ms, and all
// answers would be lost until the drag pauses. Stresses take longer: they come with every answer while that is quick enough for dragging,
// otherwise when the drag pauses, and then a newer case aborts them.

import { notice, whileSolving } from "./status.js";
import { unitsCode } from "./units.js";

const REST = 120; // ms without a new case before stresses are requested separately
const QUICK = 100; // ms from request to drawn; up to this, stresses come with every answer
const PATIENCE = 3; // slow answers in a row, or one three times as slow, after which stresses are requested separately
const LONG = 6000; // ms after which an answer is given up for that of a newer case
const AGAIN = 1500; // ms between attempts to reach the program
/** Shown when nothing answers. */
export const AWAY = "The program behind this page does not answer: check that nonhertz serve is still running.";
const ATTEMPTS = 4; // while it is busy

/**
 * @typedef {{document: object, since: number}} Pending a case and when the edit that made it began
 * @typedef {{
 *   answered: (answer: any, wanted: Pending, stress: boolean) => void,
 *   stressed: (answer: any) => void,
 *   waiting: () => void,
 *   rested: (complete: boolean) => void,
 *   gaveUp: (sentence: string) => void,
 *   stress: () => ("a" | "b" | null),
 * }} Listener
 */

/**
 * Post JSON.
 * @param {string} place
 * @param {object} body
 * @param {AbortSignal} [signal]
 */
export function post(place, body, signal) {
  return send(place, "application/json", JSON.stringify(body), signal);
}

/**
 * Post something. A busy program is asked again a few times; the last answer may still be that it is busy.
 * @param {string} place
 * @param {string} type
 * @param {BodyInit} body
 * @param {AbortSignal} [signal]
 */
export async function send(place, type, body, signal) {
  for (let left = ATTEMPTS; ; left -= 1) {
    const headers = { "Content-Type": type, "Nonhertz-Units": unitsCode() };
    const response = await fetch(place, { method: "POST", headers, body, signal });
    if (response.status !== 503 || left <= 1) return response;
    await new Promise((done) => window.setTimeout(done, AGAIN / 3));
  }
}

/**
 * Post a document that is to be solved: the answer, or null if there is none, which a notice says.
 * @param {string} place
 * @param {object} body
 * @param {AbortSignal} [signal]
 */
export async function asked(place, body, signal) {
  try {
    const response = await post(place, body, signal);
    if (response.status === 204) return null;
    const answer = await response.json();
    const busy = response.status === 503;
    notice("program", busy ? answer.mistakes[0].sentence : "");
    return busy ? null : answer;
  } catch {
    // Nothing answers, or something other than the program.
    if (!signal?.aborted) notice("program", `${AWAY} Trying again …`);
    return null;
  }
}

export class Live {
  /** @param {Listener} listener */
  constructor(listener) {
    this.listener = listener;
    /** @type {Pending | null} */
    this.next = null;
    /** @type {Pending | null} */
    this.latest = null;
    this.busy = false;
    this.slow = 0; // answers with stresses in a row that took too long
    this.rest = 0;
    /** @type {AbortController | null} */
    this.stresses = null;
    /** @type {{stop: AbortController, since: number} | null} */
    this.asking = null;
  }

  /**
   * Solve a case, now or as soon as the request in flight has been answered.
   * @param {object} document
   * @param {number} [since] when the edit began, by performance.now()
   */
  want(document, since = performance.now()) {
    this.next = { document, since };
    this.forgetStress();
    this.listener.waiting();
    if (this.asking && performance.now() - this.asking.since > LONG) this.asking.stop.abort();
    if (!this.busy) void this.run();
  }

  /** Ask for the stresses of the latest case, if they are shown. */
  wantStress() {
    this.forgetStress();
    if (this.latest && this.listener.stress()) this.rest = window.setTimeout(() => this.runStress(), REST);
  }

  forgetStress() {
    window.clearTimeout(this.rest);
    this.stresses?.abort();
    this.stresses = null;
  }

  async run() {
    this.busy = true;
    let complete = false;
    while (this.next) {
      const wanted = this.next;
      this.next = null;
      const stress = this.slow < PATIENCE && this.listener.stress() !== null;
      const first = this.latest === null;
      const begun = performance.now();
      const stop = new AbortController();
      this.asking = { stop, since: begun };
      const done = whileSolving(() => stop.abort(), "still solving", true);
      const answer = await this.ask(wanted, stress, stop.signal);
      done();
      this.asking = null;
      if (stop.signal.aborted || answer?.slow) {
        this.latest = null;
        if (!this.next) this.listener.gaveUp(answer?.mistakes[0].sentence ?? "cancelled");
        continue;
      }
      if (!answer) {
        this.next ??= wanted;
        await new Promise((again) => window.setTimeout(again, AGAIN));
        continue;
      }
      this.latest = answer.ok ? wanted : null;
      this.listener.answered(answer, wanted, stress);
      if (stress && !first) this.judge(performance.now() - begun); // the first answer is always slow
      complete = stress && answer.body === this.listener.stress(); // another body may be shown by now
    }
    this.busy = false;
    if (complete) this.forgetStress();
    else this.wantStress();
    this.listener.rested(complete);
  }

  async runStress() {
    const wanted = this.latest;
    if (!wanted) return;
    this.listener.waiting();
    const stop = new AbortController();
    this.stresses = stop;
    const begun = performance.now();
    const answer = await this.ask(wanted, true, stop.signal);
    if (stop.signal.aborted) return;
    if (!answer) {
      this.rest = window.setTimeout(() => this.runStress(), AGAIN);
      return;
    }
    this.listener.stressed(answer);
    this.slow = performance.now() - begun < QUICK ? 0 : PATIENCE;
  }

  /** Note how long an answer with stresses took. @param {number} took ms */
  judge(took) {
    if (took < QUICK) this.slow = 0;
    else this.slow += took < PATIENCE * QUICK ? 1 : PATIENCE;
  }

  /**
   * Return the program's answer, or null if there is none.
   * @param {Pending} wanted
   * @param {boolean} stress
   * @param {AbortSignal} [signal]
   */
  async ask(wanted, stress, signal) {
    const body = this.listener.stress() ?? "a";
    const answer = await asked("solve", { document: wanted.document, stress, body }, signal);
    return answer && { ...answer, body };
  }
}
