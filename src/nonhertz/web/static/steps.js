// What each step did to a measured profile: small drawings, before in grey and after in colour.

import { FIRST, PINNED, axis, draw, extent, line } from "./chart.js";
import { element } from "./elements.js";
import { named } from "./units.js";

/**
 * Draw the steps into their element.
 * @param {HTMLElement} host
 * @param {{name: string, sentence: string, before: {y: number[], height_um: number[]}, after: {y: number[], height_um: number[]}, floor_um: number}[]} steps
 */
export function drawSteps(host, steps) {
  const figures = steps.map((step) =>
    element("figure", { class: "step", "data-step": step.name }, [
      element("figcaption", {}, [element("b", {}, [step.name]), ` ${step.sentence}`]),
      element("div", { class: "drawing" }),
    ]),
  );
  host.replaceChildren(...figures);
  for (const [place, step] of steps.entries()) drawStep(figures[place], step);
}

function drawStep(host, { name, sentence, before, after, floor_um: floor }) {
  // Corners go down a hundred times deeper than the land.
  const heights = [...before.height_um, ...after.height_um].filter((height) => height >= floor);
  draw(
    host,
    {
      height: 130,
      marginLeft: 46,
      marginRight: 8,
      marginTop: 8,
      marginBottom: 30,
      x: { ...axis("y", "mm"), ticks: 5 },
      y: { ...axis("height", "µm", extent(heights)), nice: true, ticks: 3, grid: true },
      marks: [
        line(before.y, before.height_um, { stroke: PINNED, strokeWidth: 1, clip: true }),
        line(after.y, after.height_um, { stroke: FIRST, strokeWidth: 1.4, clip: true }),
      ],
    },
    `Heights in ${named("µm")} before and after the step ${name}. ${sentence}`,
  );
}
