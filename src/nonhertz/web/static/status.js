// What the page says about itself: notices, and whether something is being solved.

import { byId } from "./elements.js";

/** @type {Map<string, string>} */
const notices = new Map();

/** Set the notice for a reason; an empty sentence clears it. @param {string} reason @param {string} sentence */
export function notice(reason, sentence) {
  notices.set(reason, sentence);
  const text = [...notices.values()].filter(Boolean).join(" ");
  byId("notice").textContent = text;
  byId("notice").hidden = !text;
}

/** Say what the numbers are. @param {string} words @param {string} [more] what goes on */
export function sayState(words, more = "") {
  byId("state").textContent = words;
  byId("round-trip").textContent = more;
}

const AGAIN = 1000; // ms

/**
 * Count the seconds of an answer that takes long, beside a button that gives it up; return what ends that.
 * @param {() => void} giveUp
 * @param {string} words what goes on
 * @param {boolean} outdates whether what is shown is of another case
 */
export function whileSolving(giveUp, words, outdates) {
  const [begun, button] = [performance.now(), byId("cancel")];
  const count = () => {
    sayState(words, `… ${Math.round((performance.now() - begun) / 1e3)} s`);
    button.hidden = false;
    button.onclick = giveUp;
    byId("results").classList.toggle("outdated", outdates);
  };
  const counting = window.setInterval(count, AGAIN);
  return () => {
    window.clearInterval(counting);
    button.hidden = true;
  };
}

// The time from an edit to the redrawn figures, recorded for measurements.
let answers = 0;

/**
 * Note that the answer to an edit has been drawn.
 * @param {number} since when the edit began, by performance.now()
 * @param {number} begun when the drawing of the answer began
 * @param {import("./types.js").Answer | import("./types.js").Refusal} answer
 */
export function roundTrip(since, begun, answer) {
  timed(since, begun, () => {
    if (answer.ok) sayState(answer.complaint ? answer.status : "solved");
  });
}

/**
 * Count an answer and measure it, once it is on the screen.
 * @param {number} since when the edit began, by performance.now()
 * @param {number} begun when the drawing of the answer began
 * @param {() => void} say called once the answer is drawn
 */
export function timed(since, begun, say) {
  answers += 1;
  performance.measure("nonhertz drawing", { start: begun });
  const root = document.documentElement;
  root.dataset.answers = String(answers);
  window.requestAnimationFrame(() => {
    const end = performance.now();
    performance.measure("nonhertz round trip", { start: since, end });
    root.dataset.roundTrip = (end - since).toFixed(1);
    say();
  });
}
