// The names of the keys of files on the page, and the headings of keys that most files leave out.

/** @type {Record<string, string>} by the last two keys of a path, or the last */
const LABELS = {
  accuracy_of: "accuracy of",
  at: "position of the drop",
  "bearing.clearance": "clearance, preload",
  "bearing.kind": "type of bearing",
  "bearing.pair": "second row",
  "body.a": "body a",
  "body.b": "body b",
  "fit.housing": "housing seat",
  "fit.shaft": "shaft seat",
  fit: "Fits and temperatures",
  k1: "factor k1",
  k2: "factor k2",
  inner: "inner ring",
  kind: "type",
  life: "Life",
  line_loads: "line loads by",
  lubrication: "Oil and cleanliness",
  "load.axial": "axial load",
  "load.radial": "radial load",
  "life.dynamic": "dynamic rating C",
  "life.required": "required life",
  "life.static": "static rating C0",
  modulus: "Young’s modulus",
  "pair.clearance": "clearance, preload",
  outer: "outer ring",
  poisson: "Poisson’s ratio",
  report: "Report",
  solver: "Solver",
  turning: "rotating ring",
  y: "positions y",
};

/** @type {[string, string[], string?][]} headings, the keys below them, and the table of which alone they are */
export const FOLDS = [
  ["Corners and position", ["effective_length", "corner_radius", "chamfer", "position"]],
  ["Side faces, depth and bore", ["side_faces", "images", "depth", "bore", "case_depth"]],
  ["Hardening and limits", ["yield_strength", "core_yield_strength", "hardness", "pressure_limit"]],
  ["Drop, shift, scale, flip", ["drop", "at", "shift", "scale", "flip"]],
  [
    "Pitch circle, ribs, out-of-roundness",
    ["pitch_diameter", "inner_shape", "outer_shape", "density", "rib", "axial_clearance"],
  ],
  ["Fits and temperatures", ["fit"]],
  ["Second row and its preload", ["pair"]],
  ["Oil and cleanliness", ["lubrication"]],
  ["Reliability and ratings", ["reliability", "required", "turning", "dynamic", "static"]],
  ["Load spectrum", ["spectrum"], "life"],
  ["Edges and laminae", ["edge_stress", "line_loads", "laminae"], "life"],
  ["Life", ["life"]],
  ["Solver", ["solver"]],
  ["Report", ["report"]],
];
/** Of these, each is a heading of the form. */
export const SECTIONS = ["fit", "lubrication", "life", "solver", "report"];
/** The most frequently changed keys come first; the rest in the order of the schema. */
export const FIRST = ["title", "kind", "load", "body", "bearing", "diameter", "length", "profile", "material", "oil"];

/**
 * What a key is called, with the number of an entry of a list.
 * @param {(string | number)[]} place
 * @returns {string}
 */
export function labelOf(place) {
  const last = place[place.length - 1] ?? "";
  if (typeof last === "number") return `${labelOf(place.slice(0, -1))} ${last}`;
  return LABELS[place.slice(-2).join(".")] ?? LABELS[last] ?? last.replaceAll("_", " ");
}
