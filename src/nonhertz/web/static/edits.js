// Undo and redo: the cases that somebody has come to rest at.

const REST = 400; // ms: what follows faster belongs to one edit, such as a drag
const KEPT = 200;

export class Edits {
  /** @param {object} document @param {() => void} changed is told when what can be undone has changed */
  constructor(document, changed) {
    this.cases = [JSON.stringify(document)];
    this.place = 0;
    this.rest = 0;
    this.changed = changed;
    /** @type {string | null} */
    this.unsettled = null;
  }

  /** Begin again with a case that is nobody's edit. @param {object} document */
  restart(document) {
    window.clearTimeout(this.rest);
    [this.cases, this.place, this.unsettled] = [[JSON.stringify(document)], 0, null];
    this.changed();
  }

  /** Remember a case once no other follows. @param {object} document */
  note(document) {
    this.unsettled = JSON.stringify(document);
    window.clearTimeout(this.rest);
    this.rest = window.setTimeout(() => this.settle(), REST);
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
