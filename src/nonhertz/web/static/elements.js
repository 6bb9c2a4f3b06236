// Making and finding elements.

const SVG = "http://www.w3.org/2000/svg";

/**
 * Return the element with an identifier, which must exist on the page.
 * @param {string} id
 * @returns {any}
 */
export function byId(id) {
  const found = document.getElementById(id);
  if (!found) throw new Error(`the page has no #${id}`);
  return found;
}

/**
 * Return a new element. Text goes in as text: nothing from files or users is ever parsed as HTML.
 * @param {string} name
 * @param {Record<string, string | boolean | ((event: any) => void)>} attributes a function is an event listener
 * @param {(Node | string)[]} [children]
 * @returns {any}
 */
export function element(name, attributes, children = []) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (typeof value === "function") made.addEventListener(key, value);
    else if (typeof value === "boolean") made.toggleAttribute(key, value);
    else made.setAttribute(key, value);
  }
  made.append(...children);
  return made;
}

/**
 * Return a new element of a drawing.
 * @param {string} name
 * @param {Record<string, string | number>} attributes
 * @param {(Node | string)[]} [children]
 * @returns {any}
 */
export function drawn(name, attributes, children = []) {
  const made = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, String(value));
  made.append(...children);
  return made;
}
