// The link that holds a case, and the address of the page that keeps it. Everything is in the fragment, which browsers
// never send to a server.

const LARGEST = 1_000_000; // characters of an unpacked case, the program's own limit
const LONGEST = 2_000_000; // characters of a fragment; a longer one is not read

/** @typedef {{document: object, name: string}} Named a pinned case */
/** @typedef {{document: object, pinned: Named[], text: string}} Shared */

/**
 * Return the fragment for a case, "#c=..." with "&p=..." and "&n=..." for each pinned one and its name, and "&t=..." for
 * the text of a file that has comments.
 * @param {object} document
 * @param {Named[]} [pinned]
 * @param {string} [text]
 */
export async function fragment(document, pinned = [], text = "") {
  const fields = [`c=${await packed(JSON.stringify(document))}`];
  for (const { document: other, name } of pinned)
    fields.push(`p=${await packed(JSON.stringify(other))}`, `n=${await packed(name)}`);
  if (text.includes("#")) fields.push(`t=${await packed(text)}`);
  return `#${fields.join("&")}`;
}

/**
 * Return the case and the pinned cases in a fragment, null if there is no case.
 * @param {string} hash
 * @returns {Promise<Shared | null>}
 */
export async function shared(hash) {
  if (hash.length > LONGEST) throw new Error("The link is longer than any case of 1 MB: copy it again.");
  const fields = new URLSearchParams(hash.replace(/^#/, ""));
  const document = fields.get("c");
  if (!document) return null;
  const names = fields.getAll("n");
  const pinned = fields.getAll("p").map(async (packed, place) => ({
    document: await unpackedCase(packed),
    name: names[place] ? await unpacked(names[place]).catch(() => "") : "",
  }));
  const text = fields.get("t");
  return {
    document: await unpackedCase(document),
    pinned: await Promise.all(pinned),
    text: text ? await unpacked(text).catch(() => "") : "",
  };
}

async function unpackedCase(text) {
  let value;
  try {
    value = JSON.parse(await unpacked(text));
  } catch {
    throw new Error("The link is incomplete or was changed on the way: copy it again.");
  }
  if (typeof value !== "object" || value === null || Array.isArray(value)) {
    throw new Error("The link holds no case: copy it again.");
  }
  return value;
}

/** Deflate a text and encode it in characters allowed in URLs. @param {string} text */
export async function packed(text) {
  const stream = new Blob([text]).stream().pipeThrough(new CompressionStream("deflate-raw"));
  const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
  return bytes.toBase64({ alphabet: "base64url", omitPadding: true });
}

/** The text again; one larger than any case is refused before it fills the memory. @param {string} text */
export async function unpacked(text) {
  const bytes = Uint8Array.fromBase64(text, { alphabet: "base64url" });
  const reader = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw")).getReader();
  const decoder = new TextDecoder("utf-8", { fatal: true });
  let whole = "";
  for (;;) {
    const { done, value } = await reader.read();
    if (done) return whole + decoder.decode();
    whole += decoder.decode(value, { stream: true });
    if (whole.length > LARGEST) {
      await reader.cancel();
      throw new Error("too large");
    }
  }
}

const REST = 300; // ms: browsers refuse more than a hundred changes in half a minute

/** Keeps the case in the address of the page, so that reloading or navigating away and back loses nothing. */
export class Address {
  constructor() {
    this.rest = 0;
  }

  /**
   * Put a case into the address after a pause in editing.
   * @param {object} document
   * @param {Named[]} pinned
   * @param {string} text of its file
   * @param {object | null} [looked] what is looked at, which `history.state` keeps: no part of the case or of its link
   */
  keep(document, pinned, text, looked = null) {
    window.clearTimeout(this.rest);
    this.rest = window.setTimeout(() => void this.put(document, pinned, text, looked), REST);
  }

  /** @param {object} document @param {Named[]} pinned @param {string} text @param {object | null} [looked] */
  async put(document, pinned, text, looked = null) {
    window.clearTimeout(this.rest);
    // Replaced, not pushed: a drag would fill the history with a hundred entries.
    history.replaceState(looked, "", await fragment(document, pinned, text));
    return window.location.href;
  }
}
