// The page of a single contact: what happens when its case is answered.

import { Curve } from "./curve.js";
import { byId } from "./elements.js";
import { Live, post } from "./live.js";
import { roundTrip } from "./status.js";
import { Sketch } from "./sketch.js";
import { Strength } from "./strength.js";
import { View } from "./view.js";
import { Work } from "./work.js";

const REST = 120; // ms without a new case before stresses are requested separately
const STILL = 150; // ms after the last answer before coarsely drawn stresses are redrawn finely
let refining = 0;

const view = new View((profiles) => work.drawProfiles(profiles));
const curve = new Curve(byId("case"));
const sketch = new Sketch(byId("case"));
const strength = new Strength((answer) => view.searched(answer));

const live = new Live({
  request: (document, stress, body) => ["solve", { document, stress, body: body ?? "a" }],
  wish: () => view.shownBody(),
  together: true,
  rest: REST,
  answered(answer, { document, since }, stress) {
    const begun = performance.now();
    if (answer.ok) view.show(document, answer);
    else view.refuse(document, answer);
    if (stress) showStress(answer, false);
    if (answer.ok) {
      curve.at(document, answer.key);
      sketch.draw(answer);
    }
    roundTrip(since, begun, answer);
  },
  more(answer) {
    showStress(answer, true);
    searchStrength(answer.planes !== undefined);
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
  gaveUp(sentence, stress) {
    if (!stress) {
      view.outdate(sentence);
      return;
    }
    byId("round-trip").textContent = `Stresses: ${sentence}`;
    searchStrength(false);
    document.documentElement.dataset.state = "settled";
  },
});

function showStress(answer, fine) {
  byId("stress-figures").classList.remove("stale");
  if (answer.ok) view.stress({ ...answer, body: answer.wish }, fine);
}

/** Ask whether the body that is shown withstands its stress. @param {boolean} stressed whether it has stresses */
function searchStrength(stressed) {
  const body = view.shownBody();
  if (!live.latest) return; // what is shown of the last good case stays, dimmed
  if (stressed && body) strength.wait(live.latest.document, body);
  else strength.hide();
}

const work = new Work(JSON.parse(byId("start").textContent), {
  what: "case",
  at: "",
  bodies: { a: "body.a", b: "body.b" },
  want: (document, since) => live.want(document, since),
  latest: () => view.latest,
  pin: (pins) => view.pin(pins),
  async solve(document) {
    const body = view.shownBody();
    return (await post("solve", { document, stress: body !== null, body: body ?? "a" })).json();
  },
  drawn: () => curve.offer(),
  again({ document, answer }) {
    view.show(document, answer);
    view.stress(answer);
  },
  renamed: () => curve.reread(),
  begun() {
    view.clear();
    sketch.clear();
  },
});

for (const choice of document.querySelectorAll("[name=stress-unit]"))
  choice.addEventListener("change", () => view.drawStress());
for (const choice of document.querySelectorAll("[name=stress-body], #stress-on")) {
  choice.addEventListener("change", () => {
    if (view.shownBody()) strength.forget();
    else strength.hide();
    view.redraw();
    live.wantMore();
  });
}
await work.begin();
