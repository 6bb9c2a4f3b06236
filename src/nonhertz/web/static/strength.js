// Whether the body whose stress is shown withstands it: sentences, requested when a slider rests.
//
// The search for the largest stresses of the whole body takes seconds. An edit meanwhile ends it.

import { byId } from "./elements.js";
import { AWAY, post } from "./live.js";
import { html, render } from "./preact.js";

const REST = 700; // ms without an edit before the search begins

/** @typedef {{verdict: string, sentence: string}} Check */

export class Strength {
  /** @param {(answer: any) => void} onAnswer called with an answer, which has the largest stress of the whole body */
  constructor(onAnswer) {
    this.onAnswer = onAnswer;
    this.rest = 0;
    /** @type {AbortController | null} */
    this.asking = null;
    this.section = byId("strength");
    this.section.dataset.state = "idle";
  }

  /** What is shown belongs to another case or body: it stays, dimmed, until the next search has ended. */
  forget() {
    window.clearTimeout(this.rest);
    this.asking?.abort();
    this.asking = null;
    this.section.classList.add("stale");
    this.section.dataset.state = "idle";
  }

  /** Hide it, where no stress is shown. */
  hide() {
    this.forget();
    this.section.hidden = true;
  }

  /** Ask for it if the case stays as it is. @param {object} document @param {"a" | "b"} body */
  wait(document, body) {
    this.forget();
    this.section.dataset.state = "working";
    this.rest = window.setTimeout(() => void this.run(document, body), REST);
  }

  /** @param {object} document @param {"a" | "b"} body */
  async run(document, body) {
    const stop = new AbortController();
    this.asking = stop;
    if (this.section.hidden) this.show(body, [], "Searching the whole body for its largest stresses …");
    try {
      const answer = await (await post("strength", { document, body }, stop.signal)).json();
      if (stop.signal.aborted) return;
      this.show(body, answer.checks ?? [], answer.mistakes?.[0].sentence ?? "");
      this.onAnswer(answer);
    } catch {
      if (stop.signal.aborted) return;
      this.show(body, [], AWAY);
    }
    this.section.dataset.state = "done";
  }

  /** @param {"a" | "b"} body @param {Check[]} checks @param {string} note */
  show(body, checks, note) {
    render(
      html`<h3 id="strength-title">Strength of body ${body}</h3>
        <ul id="strength-list" aria-labelledby="strength-title">
          ${checks.map(({ verdict, sentence }) => html`<li data-verdict=${verdict}>${sentence}</li>`)}</ul>
        <p class="hint" role="status">${note}</p>`,
      this.section,
    );
    this.section.classList.remove("stale");
    this.section.hidden = !checks.length && !note;
  }
}
