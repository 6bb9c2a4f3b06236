// The case in the address of the page: reloading, or going away and back, loses nothing.

import { fragment } from "./link.js";

const REST = 300; // ms: browsers refuse more than a hundred changes in half a minute

export class Address {
  constructor() {
    this.rest = 0;
  }

  /** Keep a case in the address once no other follows. @param {object} document @param {object | null} pinned */
  keep(document, pinned) {
    window.clearTimeout(this.rest);
    this.rest = window.setTimeout(() => void this.put(document, pinned), REST);
  }

  /** @param {object} document @param {object | null} pinned */
  async put(document, pinned) {
    window.clearTimeout(this.rest);
    // Replaced and not added: a drag would fill the history with a hundred pages.
    history.replaceState(null, "", await fragment(document, pinned));
    return window.location.href;
  }
}
