// A figure as a file: SVG as it is drawn, or PNG at twice the size, with heading and legend, in the colours of the page.

import { csvOf } from "./csv.js";
import { drawn } from "./elements.js";
import { hand } from "./files.js";

const SCALE = 2; // pixels of a PNG per pixel of the page
const TOP = 26; // pixels for heading and legend
/** What of the page's styles has to be written into a drawing that stands alone. */
const STYLES = ["fill", "stroke", "color", "stop-color", "font-family", "font-size", "font-weight", "font-style"];

/**
 * Save the drawing of a figure, or its numbers.
 * @param {HTMLElement} host
 * @param {"svg" | "png" | "csv"} kind
 */
export async function save(host, kind) {
  if (kind === "csv") return hand(new Blob([csvOf(host)], { type: "text/csv" }), `${host.dataset.figure}.csv`);
  const text = standing(host);
  if (!text) return;
  const drawing = new Blob([text], { type: "image/svg+xml" });
  const name = `${host.dataset.figure ?? "figure"}.${kind}`;
  hand(kind === "svg" ? drawing : await painted(drawing), name);
}

/** A drawing as an SVG file; null if nothing is drawn. @param {HTMLElement} host */
export function standing(host) {
  // A colour scale is a drawing of its own above the figure's.
  const parts = /** @type {SVGSVGElement[]} */ ([...host.querySelectorAll(".drawing svg")]);
  if (!parts.length) return null;
  const width = Math.max(...parts.map((svg) => sizeOf(svg, "width")));
  let height = TOP;
  const copies = parts.map((svg) => {
    const copy = /** @type {SVGSVGElement} */ (svg.cloneNode(true));
    dress(svg, copy);
    for (const aside of copy.querySelectorAll("style")) aside.remove();
    copy.setAttribute("y", String(height));
    height += sizeOf(svg, "height");
    return copy;
  });
  const ground = drawn("rect", { width: "100%", height: "100%", fill: getComputedStyle(host).backgroundColor });
  const frame = { width, height, viewBox: `0 0 ${width} ${height}` };
  return new XMLSerializer().serializeToString(drawn("svg", frame, [ground, ...captions(host, width), ...copies]));
}

/** @param {SVGSVGElement} drawing @param {"width" | "height"} side */
function sizeOf(drawing, side) {
  return Number(drawing.getAttribute(side)) || drawing.getBoundingClientRect()[side];
}

/** Heading, legend and remark as texts in a row. @param {HTMLElement} host @param {number} width */
function captions(host, width) {
  const texts = [];
  let x = 8;
  for (const part of host.querySelectorAll("figcaption > :is(.heading, .entry)")) {
    const swatch = part.querySelector(".swatch");
    if (swatch) texts.push(bar(x, swatch));
    texts.push(written(swatch ? x + 28 : x, part.textContent?.trim() ?? "", part, "start"));
    x += part.getBoundingClientRect().width + 14;
  }
  const remark = host.querySelector("figcaption > .remark");
  if (remark?.textContent) texts.push(written(width - 8, remark.textContent, remark, "end"));
  return texts;
}

function written(x, words, part, anchor) {
  const style = getComputedStyle(part);
  const attributes = {
    x,
    y: 17,
    "font-family": style.fontFamily,
    "font-size": style.fontSize,
    "font-weight": style.fontWeight,
    "font-style": style.fontStyle,
    "text-anchor": anchor,
    fill: style.color,
  };
  return drawn("text", attributes, [words]);
}

/** The swatch of a legend as a line. */
function bar(x, swatch) {
  const style = getComputedStyle(swatch);
  const dashes = { dashed: "5 3", dotted: "2 3" }[style.borderTopStyle] ?? "none";
  const stroke = { stroke: style.borderTopColor, "stroke-width": 2, "stroke-dasharray": dashes };
  return drawn("line", { x1: x, x2: x + 22, y1: 13, y2: 13, ...stroke });
}

/** Write styles that come from the page into a copy, element by element. @param {Element} part @param {Element} copy */
function dress(part, copy) {
  const style = getComputedStyle(part);
  for (const name of STYLES) {
    const value = style.getPropertyValue(name);
    if (value) /** @type {SVGElement} */ (copy).style.setProperty(name, value);
    copy.removeAttribute(name);
  }
  for (const [place, child] of [...part.children].entries()) dress(child, copy.children[place]);
}

/** @param {Blob} drawing @returns {Promise<Blob>} */
async function painted(drawing) {
  const address = URL.createObjectURL(drawing);
  try {
    const image = new Image();
    image.src = address;
    await image.decode();
    const canvas = document.createElement("canvas");
    canvas.width = SCALE * image.width;
    canvas.height = SCALE * image.height;
    /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d")).drawImage(image, 0, 0, canvas.width, canvas.height);
    return await new Promise((done, failed) =>
      canvas.toBlob((blob) => (blob ? done(blob) : failed(new Error("no picture"))), "image/png"),
    );
  } finally {
    URL.revokeObjectURL(address);
  }
}
