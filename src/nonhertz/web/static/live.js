// Requesting solutions during a drag: one request in flight, the latest document next, every answer drawn.
//
// A request in flight is not aborted for a newer document until it has taken long: a slider gives one every 16 ms, and
// all answers would be lost until the drag pauses. More takes longer, stresses of a contact or strips of a bearing: it
// comes with every answer while that is quick enough for dragging, otherwise when the drag pauses, and then a newer
// document aborts it.

import { notice, whileSolving } from "./status.js";
import { unitsCode } from "./units.js";

const QUICK = 50; // ms from request to drawn; up to this, more comes with every answer and the hand feels no lag
const PATIENCE = 3; // slow answers in a row, or one three times as slow, after which more is requested separately
const LONG = 6000; // ms after which an answer is given up for that of a newer document
/** ms between attempts to reach the program. */
export const AGAIN = 1500;
/** Shown when nothing answers. */
export const AWAY = "The program behind this page does not answer: check that nonhertz serve is still running.";
const ATTEMPTS = 4; // while it is busy

/**
 * @typedef {{document: object, since: number}} Pending a document and when the edit that made it began
 * @typedef {{
 *   request: (document: object, more: boolean, wish: string | null) => [string, object],
 *   wish: () => string | null,
 *   together: boolean,
 *   rest: number,
 *   isBusy?: () => boolean,
 *   counted?: string,
 *   answered: (answer: any, wanted: Pending, more: boolean) => void,
 *   more: (answer: any, wanted: Pending, begun: number) => void,
 *   waiting: (more: boolean) => void,
 *   rested: (complete: boolean) => void,
 *   gaveUp: (sentence: string, more: boolean) => void,
 * }} Page
  * `request` gives address and body of a request; `wish` what is wanted beyond the quick answer, the stresses in a body
 * or strips, null for nothing. `together`: that comes with the quick answer while it is quick enough; otherwise it is
 * requested after `rest` ms without a new document, unless the page `isBusy`, as while a slider is dragged. `counted` is shown, with the
 * seconds, while it is computed. The others are called on an answer, on more, while waiting, when nothing is left to
 * request, and when there is no answer.
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
export async function answerTo(place, body, signal) {
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
  /** @param {Page} page */
  constructor(page) {
    this.page = page;
    /** @type {Pending | null} */
    this.next = null;
    /** @type {Pending | null} */
    this.latest = null;
    this.busy = false;
    this.slow = 0; // answers with more in a row that took too long
    this.rest = 0;
    /** @type {AbortController | null} */
    this.more = null;
    /** @type {{stop: AbortController, since: number} | null} */
    this.asking = null;
  }

  /**
   * Solve a document, now or as soon as the request in flight has been answered.
   * @param {object} document
   * @param {number} [since] when the edit began, by performance.now()
   */
  want(document, since = performance.now()) {
    this.next = { document, since };
    this.forgetMore();
    this.page.waiting(false);
    if (this.asking && performance.now() - this.asking.since > LONG) this.asking.stop.abort();
    if (!this.busy) void this.run();
  }

  /** Ask for what else is wished of the latest document, when the hand rests. */
  wantMore() {
    this.forgetMore();
    const ask = () => (this.page.isBusy?.() ? this.wantMore() : void this.runMore());
    if (this.latest && this.page.wish()) this.rest = window.setTimeout(ask, this.page.rest);
  }

  forgetMore() {
    window.clearTimeout(this.rest);
    this.more?.abort();
    this.more = null;
  }

  async run() {
    this.busy = true;
    let complete = false;
    while (this.next) {
      const wanted = this.next;
      this.next = null;
      const more = this.page.together && this.slow < PATIENCE && this.page.wish() !== null;
      const first = this.latest === null;
      const begun = performance.now();
      const stop = new AbortController();
      this.asking = { stop, since: begun };
      const done = whileSolving(() => stop.abort(), "still solving", true);
      const answer = await this.ask(wanted, more, stop.signal);
      done();
      this.asking = null;
      if (stop.signal.aborted || answer?.slow) {
        this.latest = null;
        if (!this.next) this.page.gaveUp(answer?.mistakes[0].sentence ?? "cancelled", false);
        continue;
      }
      if (!answer) {
        this.next ??= wanted;
        await new Promise((again) => window.setTimeout(again, AGAIN));
        continue;
      }
      this.latest = answer.ok ? wanted : null;
      this.page.answered(answer, wanted, more);
      if (more && !first) this.judge(performance.now() - begun); // the first answer is always slow
      complete = more && answer.wish === this.page.wish(); // another body may be shown by now
    }
    this.busy = false;
    if (complete) this.forgetMore();
    else this.wantMore();
    this.page.rested(complete);
  }

  async runMore() {
    const wanted = this.latest;
    if (!wanted) return;
    this.page.waiting(true);
    const stop = new AbortController();
    this.more = stop;
    const begun = performance.now();
    const giveUp = (why) => {
      stop.abort();
      this.page.gaveUp(why, true);
    };
    const done = this.page.counted ? whileSolving(() => giveUp("Cancelled"), this.page.counted, false) : () => {};
    const answer = await this.ask(wanted, true, stop.signal);
    done();
    if (stop.signal.aborted) return;
    if (!answer) {
      this.rest = window.setTimeout(() => this.runMore(), AGAIN);
      return;
    }
    if (answer.slow) giveUp(answer.mistakes[0].sentence);
    else this.page.more(answer, wanted, begun);
    this.slow = performance.now() - begun < QUICK ? 0 : PATIENCE;
  }

  /** Note how long an answer with more took. @param {number} took ms */
  judge(took) {
    if (took < QUICK) this.slow = 0;
    else this.slow += took < PATIENCE * QUICK ? 1 : PATIENCE;
  }

  /**
   * Return the program's answer with what was wished, or null if there is none.
   * @param {Pending} wanted
   * @param {boolean} more
   * @param {AbortSignal} [signal]
   */
  async ask(wanted, more, signal) {
    const wish = this.page.wish();
    const answer = await answerTo(...this.page.request(wanted.document, more, wish), signal);
    return answer && { ...answer, wish };
  }
}
