// Undo and redo: the cases at which editing paused.

const REST = 400; // ms: changes in quicker succession are one edit, and all those of a drag
const KEPT = 200;

export class Edits {
  /** @param {object} document @param {() => void} changed called when what can be undone changes */
  constructor(document, changed) {
    this.cases = [JSON.stringify(document)];
    this.place = 0;
    this.rest = 0;
    this.changed = changed;
    /** @type {string | null} */
    this.unsettled = null;
    this.dragging = false;
    window.addEventListener("pointerdown", () => this.hold(), { capture: true });
    for (const end of ["pointerup", "pointercancel"]) window.addEventListener(end, () => this.release());
  }

  /** All changes until the pointer is released are one edit, however long it rests. */
  hold() {
    this.settle();
    this.dragging = true;
  }

  release() {
    this.dragging = false;
    if (this.unsettled !== null) this.pause();
  }

  /** Start afresh with a case that was not edited. @param {object} document */
  restart(document) {
    window.clearTimeout(this.rest);
    [this.cases, this.place, this.unsettled] = [[JSON.stringify(document)], 0, null];
    this.changed();
  }

  /** Remember a case after a pause in editing. @param {object} document */
  note(document) {
    this.unsettled = JSON.stringify(document);
    this.pause();
  }

  /** Settle after a pause, but not within a drag. */
  pause() {
    window.clearTimeout(this.rest);
    if (!this.dragging) this.rest = window.setTimeout(() => this.settle(), REST);
  }

  settle() {
    window.clearTimeout(this.rest);
    if (this.unsettled !== null && this.unsettled !== this.cases[this.place]) {
      this.cases = [...this.cases.slice(0, this.place + 1), this.unsettled].slice(-KEPT);
      this.place = this.cases.length - 1;
      this.changed();
    }
    this.unsettled = null;
  }

  /** Step back (-1) or forward (1): the case there, or null if there is none. @param {-1 | 1} step */
  step(step) {
    this.settle();
    if (!this.can(step)) return null;
    this.place += step;
    this.changed();
    return JSON.parse(this.cases[this.place]);
  }

  /** @param {-1 | 1} step */
  can(step) {
    const place = this.place + step;
    return place >= 0 && place < this.cases.length;
  }
}
