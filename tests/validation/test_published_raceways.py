"""Guesses of the inside of cylindrical bearings, against raceways that catalogues print (geometries.csv)."""

import numpy as np
import pytest

from nonhertz.bearing import from_catalogue
from nonhertz.files.geometries import published_geometries

# Of all rows of these series: mean, standard deviation and largest of relative errors, as docs/validation/bearings.md
# has them; of D_w, F and D_pw.
PUBLISHED = {
    ("2", "3", "22", "23"): ((0.017, 0.034, 0.12), (0.004, 0.008, 0.02), (0.0003, 0.003, 0.011)),
    ("10",): ((0.106, 0.03, 0.18), (0.002, 0.004, 0.012), (0.011, 0.001, 0.011)),
    ("4",): ((0.124, 0.048, 0.28), (0.018, 0.014, 0.053), (0.013, 0.01, 0.044)),
}


def errors(sizes):
    """Return relative errors of D_w, F and D_pw of guesses from d, D, B, C and C_0 alone, shape (n, 3)."""
    ratios = []
    for size in sizes:
        row = published_geometries()[size]
        catalogue = [float(row[symbol]) for symbol in ("d", "D", "B", "C", "C0")]
        inner, outer = float(row["F"]), float(row["E"])
        guess = from_catalogue(*catalogue).bearing
        raceway = guess.pitch - guess.roller_diameter
        ratios.append(
            [2.0 * guess.roller_diameter / (outer - inner), raceway / inner, 2.0 * guess.pitch / (inner + outer)]
        )
    return np.array(ratios) - 1.0


@pytest.mark.slow
@pytest.mark.parametrize("series", PUBLISHED, ids=" ".join)
def test_guesses_are_off_by_what_the_validation_says(series):
    off = errors(size for size in published_geometries() if size[:-2] in series)
    for column, (mean, scatter, largest) in zip(off.T, PUBLISHED[series], strict=True):
        assert abs(column.mean()) == pytest.approx(mean, rel=0.5, abs=6e-4)
        assert column.std() == pytest.approx(scatter, rel=0.5, abs=1.1e-3)
        assert largest / 1.2 < abs(column).max() < largest


@pytest.mark.parametrize("size", ["206", "310", "2212", "2320"])
def test_a_guess_of_the_reinforced_design_is_near_its_raceways(size):
    largest = [off for _, _, off in PUBLISHED["2", "3", "22", "23"]]
    assert (np.abs(errors([size])[0]) < largest).all()
