"""Classes of ISO against the tables of catalogues, and what SKF calls probable interference."""

import math

import pytest

import nonhertz as nh
from nonhertz.bearing.fits import HOUSINGS, SHAFTS, Range, clearance_limits, ring_limits, seat_limits

# SKF, Rolling bearings (2018), B.6: over, up to [mm], class, limits of the seat's deviation [um] (tables 12 to 20).
SEATS = [
    (18.0, 30.0, "k5", 2.0, 11.0),
    (30.0, 50.0, "m6", 9.0, 25.0),
    (80.0, 120.0, "n5", 23.0, 38.0),
    (120.0, 180.0, "k6", 3.0, 28.0),
    (6.0, 10.0, "m5", 6.0, 12.0),
    (50.0, 80.0, "H7", 0.0, 30.0),
    (50.0, 80.0, "J7", -12.0, 18.0),
    (80.0, 120.0, "K7", -25.0, 10.0),
    (120.0, 150.0, "M7", -40.0, 0.0),
    (180.0, 250.0, "N7", -60.0, -14.0),
    (50.0, 80.0, "P7", -51.0, -21.0),
    (30.0, 50.0, "G6", 9.0, 25.0),
    (80.0, 120.0, "F7", 36.0, 71.0),
    (50.0, 80.0, "J6", -6.0, 13.0),
    (10.0, 18.0, "JS7", -9.0, 9.0),
    (30.0, 50.0, "M6", -20.0, -4.0),
]
# The same tables: size, class of the shaft, probable interference of Normal bearings [um], which SKF rounds outwards.
PROBABLE = [
    (30.0, "k5", 4.0, 19.0), (50.0, "k5", 5.0, 22.0), (30.0, "k6", 5.0, 22.0), (50.0, "m6", 13.0, 33.0),
    (120.0, "m5", 18.0, 43.0), (180.0, "n5", 33.0, 64.0), (18.0, "m6", 9.0, 24.0), (10.0, "k6", 3.0, 16.0),
]  # fmt: skip
# Lower deviations [um] of KINEX, Rolling bearings, tables 10 to 12, 16 and 19.
RINGS = [
    ("inner", 30.0, "Normal", False, -10.0), ("inner", 100.0, "6", False, -15.0), ("inner", 60.0, "5", False, -9.0),
    ("outer", 62.0, "Normal", False, -13.0), ("outer", 160.0, "6", False, -18.0), ("outer", 62.0, "5", False, -9.0),
    ("inner", 30.0, "Normal", True, -12.0), ("outer", 72.0, "Normal", True, -16.0), ("inner", 40.0, "5", True, -10.0),
    ("outer", 72.0, "6X", True, -16.0),
]  # fmt: skip
# NSK, CAT. No. E1102m, table 9.14, and KINEX, table 27: bore, group, kind, limits [um].
CLEARANCES = [
    (30.0, "C3", "cylindrical", 35.0, 60.0), (24.0, "C5", "cylindrical", 65.0, 90.0),
    (40.0, "C2", "cylindrical", 5.0, 30.0), (50.0, "CN", "needle", 30.0, 60.0), (80.0, "C4", "needle", 90.0, 125.0),
    (50.0, "C3", "spherical", 55.0, 75.0), (100.0, "CN", "spherical", 60.0, 100.0),
    (160.0, "C4", "spherical", 220.0, 280.0), (300.0, "C2", "spherical", 110.0, 190.0),
    (65.0, "C5", "spherical", 120.0, 150.0),
]  # fmt: skip


def in_um(found):
    return 1e3 * found.least, 1e3 * found.greatest


@pytest.mark.parametrize(("over", "upto", "fit", "least", "greatest"), SEATS)
def test_seats_of_a_catalogue(over, upto, fit, least, greatest):
    for size in (over + 1e-6, 0.5 * (over + upto), upto):
        assert in_um(seat_limits(fit, size)) == pytest.approx((least, greatest))


@pytest.mark.parametrize(("size", "fit", "least", "greatest"), PROBABLE)
def test_probable_interference_is_that_of_a_catalogue(size, fit, least, greatest):
    low, high = (seat_limits(fit, size) - ring_limits("inner", size)).probable
    assert (math.floor(1e3 * low + 1e-9), math.ceil(1e3 * high - 1e-9)) == (least, greatest)


@pytest.mark.parametrize(("ring", "size", "tolerance_class", "tapered", "low"), RINGS)
def test_rings_of_a_catalogue(ring, size, tolerance_class, tapered, low):
    assert in_um(ring_limits(ring, size, tolerance_class, tapered=tapered)) == pytest.approx((low, 0.0))


@pytest.mark.parametrize(("bore", "group", "kind", "least", "greatest"), CLEARANCES)
def test_clearances_of_catalogues(bore, group, kind, least, greatest):
    assert in_um(clearance_limits(group, bore, kind)) == pytest.approx((least, greatest))


def test_ranges_add_limits_and_squares_of_spreads():
    found = Range.between(2.0, 8.0) - Range.between(-4.0, 4.0) + Range.exactly(1.0)
    assert (found.least, found.likely, found.greatest, found.spread) == (-1.0, 6.0, 13.0, 5.0)
    assert found.probable == (1.0, 11.0)
    assert not found.known
    assert Range.exactly(1.0).known


@pytest.mark.parametrize(
    ("call", "sentence"),
    [
        (lambda: seat_limits("k", 30.0), "fit = 'k' must be a tolerance class of ISO 286: one of e, f, g,"),
        (lambda: seat_limits("x5", 30.0), "fit = 'x5' must be a tolerance class of ISO 286"),
        (lambda: seat_limits(5, 30.0), "fit = 5 must be a tolerance class of ISO 286"),
        (
            lambda: seat_limits("j8", 30.0),
            "fit = 'j8' must have one of the grades 5 to 7, for which j is tabulated",
        ),
        (lambda: seat_limits("h11", 30.0), "fit = 'h11' must have one of the grades 5 to 10"),
        (
            lambda: seat_limits("k5", 600.0),
            "size = 600.0 must lie above 0 and up to 500 mm, for which IT5",
        ),
        (lambda: seat_limits("k5", -1.0), "size = -1.0 must be positive"),
        (lambda: ring_limits("inner", 30.0, "6X"), "tolerance_class = '6X' must be one of 'Normal', '6', '5': these"),
        (lambda: ring_limits("outer", 62.0, "6", tapered=True), "must be one of 'Normal', '6X', '5': these"),
        (lambda: ring_limits("inner", 450.0, "5"), "bore = 450.0 must lie above 0 and up to 400 mm, for which 5 is"),
        (lambda: ring_limits("inner", 8.0, tapered=True), "bore = 8.0 must lie above 10 and up to 400 mm"),
        (lambda: clearance_limits("C6", 30.0), "clearance = 'C6' must be one of 'C2', 'CN', 'C3', 'C4', 'C5'"),
        (lambda: clearance_limits("C3", 30.0, "tapered"), "kind = 'tapered' must be one of 'cylindrical', 'needle'"),
        (lambda: clearance_limits("C3", 560.0), "bore = 560.0 must lie above 0 and up to 500 mm, for which C3 is"),
    ],
)
def test_classes_that_do_not_exist_are_refused_in_a_sentence(call, sentence):
    with pytest.raises(nh.InputError) as caught:
        call()
    assert sentence in str(caught.value)


@pytest.mark.parametrize("fit", [*SHAFTS, *HOUSINGS])
def test_every_class_has_limits_of_all_sizes(fit):
    # ISO 286-1: the tolerance is that of the grade alone, and grows with the size.
    widths = [seat_limits(fit, size).spread for size in (1.0, 6.0, 10.0, 18.0, 30.0, 50.0, 80.0, 120.0, 250.0, 500.0)]
    assert widths == sorted(widths)
    assert widths[0] > 0.0
