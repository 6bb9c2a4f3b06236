// Keeps the case in the address of the page, so that reloading or navigating away and back loses nothing.

import { fragment } from "./link.js";

const REST = 300; // ms: browsers refuse more than a hundred changes in half a minute

export class Address {
  constructor() {
    this.rest = 0;
  }

  /** Put a case into the address after a pause in editing. @param {object} document @param {object | null} pinned */
  keep(document, pinned) {
    window.clearTimeout(this.rest);
    this.rest = window.setTimeout(() => void this.put(document, pinned), REST);
  }

  /** @param {object} document @param {object | null} pinned */
  async put(document, pinned) {
    window.clearTimeout(this.rest);
    // Replaced, not pushed: a drag would fill the history with a hundred entries.
    history.replaceState(null, "", await fragment(document, pinned));
    return window.location.href;
  }
}
