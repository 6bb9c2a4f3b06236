// Contours of values at uneven places.

export const BANDS = 10;
/** Cells of the grids, along and down. Fine ones take too long to paint during a drag. */
export const FINE = { columns: 96, rows: 40 };
export const QUICK = { columns: 60, rows: 26 };

/** @param {number[]} places */
function last(places) {
  return places[places.length - 1];
}

/**
 * Values on a uniform grid, as contours need them, from a grid with uneven spacing; rows go down.
 * @param {number[]} along
 * @param {number[]} depths
 * @param {(number | null)[][]} values one row for each place along
 * @param {{columns: number, rows: number}} net
 */
export function resampled(along, depths, values, net) {
  const columns = shares(along, net.columns);
  const rows = shares(depths, net.rows);
  const even = new Float64Array(net.columns * net.rows);
  for (const [row, [upper, down]] of rows.entries()) {
    for (const [column, [left, right]] of columns.entries()) {
      const at = (i, j) => values[i][j] ?? NaN; // no material: left blank
      const above = at(left, upper) * (1 - right) + at(left + 1, upper) * right;
      const below = at(left, upper + 1) * (1 - right) + at(left + 1, upper + 1) * right;
      even[row * net.columns + column] = above * (1 - down) + below * down;
    }
  }
  return { even, x1: along[0], x2: last(along), y1: depths[0], y2: last(depths) };
}

/** For the centre of each uniform cell: the interval of the places that contains it, and the fraction into it. */
function shares(places, count) {
  const length = last(places) - places[0];
  return d3.range(count).map((cell) => {
    const place = places[0] + (length * (cell + 0.5)) / count;
    const left = Math.max(0, Math.min(places.length - 2, d3.bisectRight(places, place) - 1));
    return /** @type {[number, number]} */ ([left, (place - places[left]) / (places[left + 1] - places[left])]);
  });
}
