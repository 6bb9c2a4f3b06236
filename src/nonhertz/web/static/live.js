// Asking for solutions while somebody drags: one request on its way, the latest case next, every answer drawn.
//
// A request that is on its way is never cut short for a newer case. With a slider that gives a case every 16 ms, all
// answers would be lost until the hand rests. Stresses take longer: they come with every answer as long as that is
// quick enough to drag by, else when the hand rests, and then they are cut short by a newer case.

const REST = 120; // ms without a new case before stresses are asked for alone
const QUICK = 100; // ms from asking to drawn, up to which stresses come with every answer
const PATIENCE = 3; // answers in a row that may take longer, or one that takes three times as long
const AGAIN = 1500; // ms between attempts to reach the program
/** What is said where nothing answers. */
export const AWAY = "The program behind this page does not answer: look whether nonhertz serve still runs.";
const ATTEMPTS = 4; // while it is busy

/**
 * @typedef {{document: object, since: number}} Wanted a case and when the edit that made it began
 * @typedef {{
 *   answered: (answer: any, wanted: Wanted, stress: boolean) => void,
 *   stressed: (answer: any) => void,
 *   waiting: () => void,
 *   rested: (complete: boolean) => void,
 *   trouble: (sentence: string) => void,
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
 * Post something. A program that is busy is asked again; what it says in the end may still be that it is.
 * @param {string} place
 * @param {string} type
 * @param {BodyInit} body
 * @param {AbortSignal} [signal]
 */
export async function send(place, type, body, signal) {
  for (let left = ATTEMPTS; ; left -= 1) {
    const response = await fetch(place, { method: "POST", headers: { "Content-Type": type }, body, signal });
    if (response.status !== 503 || left <= 1) return response;
    await new Promise((done) => window.setTimeout(done, AGAIN / 3));
  }
}

export class Live {
  /** @param {Listener} listener */
  constructor(listener) {
    this.listener = listener;
    /** @type {Wanted | null} */
    this.next = null;
    /** @type {Wanted | null} */
    this.latest = null;
    this.busy = false;
    this.slow = 0; // answers with stresses in a row that took too long
    this.rest = 0;
    /** @type {AbortController | null} */
    this.stresses = null;
  }

  /**
   * Solve a case, now or as soon as the request on its way has been answered.
   * @param {object} document
   * @param {number} [since] when the edit began, as performance.now() tells it
   */
  want(document, since = performance.now()) {
    this.next = { document, since };
    this.forgetStress();
    this.listener.waiting();
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
      const answer = await this.ask(wanted, stress);
      if (!answer) {
        this.next ??= wanted;
        await new Promise((done) => window.setTimeout(done, AGAIN));
        continue;
      }
      this.latest = answer.ok ? wanted : null;
      this.listener.answered(answer, wanted, stress);
      if (stress && !first) this.judge(performance.now() - begun); // the first time everything is slower
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
   * Return the program's answer, or null if there is none, which the listener is told of.
   * @param {Wanted} wanted
   * @param {boolean} stress
   * @param {AbortSignal} [signal]
   */
  async ask(wanted, stress, signal) {
    const body = { document: wanted.document, stress, body: this.listener.stress() ?? "a" };
    try {
      const response = await post("solve", body, signal);
      const answer = await response.json();
      const busy = response.status === 503;
      this.listener.trouble(busy ? answer.mistakes[0].sentence : "");
      return busy ? null : { ...answer, body: body.body };
    } catch {
      // Nobody is there, or somebody who does not answer as the program does.
      if (!signal?.aborted) this.listener.trouble(`${AWAY} Asking again …`);
      return null;
    }
  }
}
