// Opening files, and saving the files that the program makes.

import { post, send } from "./live.js";

/** @typedef {import("./types.js").Mistake} Mistake */

/** Whether a file is one of ours, by its name. @param {File} file */
export function isOwnFile({ name }) {
  return name.toLowerCase().endsWith(".toml");
}

/**
 * Return the document in a file with its text, or what is wrong with the file.
 * @param {File} file
 * @param {number} most bytes
 * @param {string} what it is of, a case or a bearing
 * @returns {Promise<{document: object | null, text: string, mistakes: Mistake[]}>}
 */
export async function opened(file, most, what) {
  if (file.size > most) {
    const sentence = `${file.name} must be a ${what} file of at most ${Math.floor(most / 1024)} kB: choose another file.`;
    return { document: null, text: "", mistakes: [{ path: "", sentence }] };
  }
  const response = await send("open", "application/toml", await file.arrayBuffer());
  const answer = await response.json();
  return { document: answer.ok ? answer.document : null, text: answer.text ?? "", mistakes: answer.mistakes ?? [] };
}

/**
 * Save a file that the program makes from a case or a bearing; return the mistakes if it cannot.
 * @param {string} place such as "download/case.toml"
 * @param {{document: object, text: string}} of the text of the file, for its comments
 * @returns {Promise<Mistake[]>}
 */
export async function saved(place, of) {
  const response = await post(place, of);
  if (!response.ok) return (await response.json()).mistakes;
  const name = response.headers.get("Content-Disposition")?.match(/filename="([^"]+)"/)?.[1];
  hand(await response.blob(), name ?? place.split("/").pop() ?? place);
  return [];
}

/** Let the browser save a file. @param {Blob} content @param {string} name */
export function hand(content, name) {
  const address = URL.createObjectURL(content);
  Object.assign(document.createElement("a"), { href: address, download: name }).click();
  window.setTimeout(() => URL.revokeObjectURL(address), 60_000);
}
