// The content of the dialog for a measured profile: the file, the switches of its steps, and the result.

import { element } from "./elements.js";

/** @typedef {import("./measured.js").Upload} Upload */
/** @typedef {(option: string, value: string) => void} Set an empty value leaves the option out */

/** Steps: name, the option that switches it, and what it does. */
const STEPS = [
  ["level", "level", "remove the tilt"],
  ["align", "align", "put the middle at y = 0"],
  ["trim", "trim", "cut off what is neither land nor corner"],
  ["outliers", "outliers", "remove outliers"],
  ["smooth", "smooth", "smooth, which removes roughness"],
  ["thin", "points", "thin to fewer points"],
];
const AS_SAID = /** @type {[string, string]} */ (["", "as the file says"]);
/** @type {[string, string, [string, string][]][]} */
const CHOICES = [
  ["height_unit", "heights in", [AS_SAID, ["um", "µm"], ["mm", "mm"], ["nm", "nm"], ["m", "m"], ["in", "in"]]],
  ["position_unit", "positions in", [AS_SAID, ["mm", "mm"], ["um", "µm"], ["m", "m"], ["in", "in"]]],
  ["corner", "corners", [["", "keep"], ["cut", "cut off"]]],
  ["sense", "positive is", [["", "material (height)"], ["drop", "material removed (drop)"]]],
  ["cutoff", "cutoff", [["", "0.8 mm"], ["0.25", "0.25 mm"], ["2.5", "2.5 mm"], ["8", "8 mm"]]],
];
/** What is typed: the option, its words, and what an empty field shows. */
const TYPED = [
  ["step", "points apart", "such as 0.5 um"],
  ["position_column", "column of positions", "number or name"],
  ["height_column", "column of heights", "number or name"],
];

/**
 * Where a file is chosen.
 * @param {string | undefined} name of the current file
 * @param {(file: File) => void} take
 */
export function picker(name, take) {
  const input = element("input", {
    type: "file",
    id: "measured-file",
    hidden: true,
    "aria-label": "measured profile",
    change: (event) => event.target.files[0] && take(event.target.files[0]),
  });
  const words = name ? "Choose another file…" : "Choose a file…";
  const hint = name
    ? "or drop one here"
    : "with positions and heights, or drop it here. It goes to the program on this machine and nowhere else.";
  return element("div", { class: "picker" }, [
    element("button", { type: "button", id: "measured-choose", click: () => input.click() }, [words]),
    input,
    name ? element("b", {}, [name]) : "",
    element("span", { class: "hint" }, [hint]),
  ]);
}

/**
 * The switches of the steps, and how to read the file.
 * @param {Upload} upload
 * @param {Set} set
 */
export function options(upload, set) {
  const switches = STEPS.map(([name, option, words]) => {
    const change = (event) => set(option, event.target.checked ? "" : "false");
    const checked = upload.options[option] !== "false";
    const box = element("input", { type: "checkbox", id: `step-${name}`, checked, change });
    return element("label", { class: "check" }, [box, ` ${words}`]);
  });
  const choices = CHOICES.map(([option, words, values]) => {
    const chosen = upload.options[option] ?? "";
    const entries = values.map(([value, text]) => element("option", { value, selected: chosen === value }, [text]));
    const change = (event) => set(option, event.target.value);
    return element("label", { class: "choice" }, [
      `${words} `,
      element("select", { id: `option-${option}`, change }, entries),
    ]);
  });
  const typed = TYPED.map(([option, words, placeholder]) => {
    const value = upload.options[option] ?? "";
    const change = (event) => set(option, event.target.value.trim());
    const field = { type: "text", id: `option-${option}`, value, placeholder, change };
    return element("label", { class: "choice" }, [`${words} `, element("input", field)]);
  });
  return element("div", { class: "measured-options" }, [
    element("fieldset", {}, [element("legend", {}, ["Steps"]), ...switches]),
    element("fieldset", {}, [element("legend", {}, ["Reading"]), ...choices, ...typed]),
  ]);
}

/**
 * The result of preparing the file, with a place for the drawings of the steps.
 * @param {Upload} upload
 * @param {string} body what it is called
 * @param {() => void} use
 */
export function outcome({ answer }, body, use) {
  if (!answer) return [element("p", { class: "hint", role: "status" }, ["reading …"])];
  if (!answer.ok) {
    const sentences = answer.mistakes.map(({ sentence }) => sentence);
    return [list("mistakes-plain", sentences, { role: "alert" })];
  }
  const button = { type: "button", class: "primary", id: "measured-use", click: use };
  const points = `${answer.table.y.length} points, replacing the profiles of ${body}`;
  return [
    ...answer.notes.map((words) => element("p", { class: "hint" }, [words])),
    ...(answer.warnings.length ? [list("warnings", answer.warnings)] : []),
    element("div", { class: "steps" }),
    ...(answer.roughness?.length ? [roughness(answer.roughness)] : []),
    element("p", { class: "measured-foot" }, [
      element("button", button, [`Use as profile of ${body}`]),
      element("span", { class: "hint" }, [points]),
    ]),
  ];
}

function list(style, sentences, more = {}) {
  const entries = sentences.map((words) => element("li", {}, [words]));
  return element("ul", { class: style, ...more }, entries);
}

function roughness(rows) {
  const cells = (row) => row.map((cell, place) => element(place ? "td" : "th", {}, [String(cell)]));
  const lines = rows.map((row) => element("tr", {}, cells(row)));
  return element("details", { class: "roughness" }, [
    element("summary", {}, ["Roughness removed by smoothing"]),
    element("table", {}, lines),
  ]);
}
