"""Two tapered rows that a force preloads: the clearance that gives it, by hand, mounted, warm and in files."""

import dataclasses
import json
import math
from pathlib import Path

import pytest
from few_rollers import changed

import nonhertz as nh
from nonhertz.files.bearing_results import as_object
from nonhertz.files.bearingfile import BearingCase, read_bearing
from nonhertz.files.starting import starting_bearing
from nonhertz.files.toml import parse
from nonhertz.show.bearing import summary_rows

CONE = nh.Roller(diameter=nh.TabulatedDiameter((-9, 9), (14.0, 12.4)), length=18)
ROW = nh.bearing.TaperedRollerBearing(
    roller=CONE,
    inner=nh.Ring(diameter=55.43),
    outer=nh.Ring(diameter=-82.57),
    rollers=15,
    contact_angle=math.radians(16.0),
    bore=45,
    outside_diameter=95,
)
PAIR = nh.bearing.paired(ROW, "O", 40.0, preload=2e3)
TEXT = starting_bearing("tapered-pair")
CLEARANCE = 'clearance = "-10 um" }'


def read(*changes):
    return BearingCase.of(parse(changed(TEXT, *changes), "pair.toml"), Path("pair.toml"))


def pressed(bearing, method="slices"):
    """Return the axial force of the first row, the ring in the middle."""
    half = dataclasses.replace(bearing, bearings=bearing.bearings[:1], x=(0.0,), turned=(False,))
    return nh.bearing.solve(half, axial_displacement=0.0, method=method).force[0]


def test_the_clearance_of_straight_rollers_by_hand():
    # All rollers bear Q = F / (Z sin(alpha)), and two contacts give way by (Q / 35948 L^(8/9))^0.9 (ISO/TS 16281).
    sine = math.sin(ROW.contact_angle)
    load = 2e3 / (15 * sine)
    length = ROW.effective_interval[1] - ROW.effective_interval[0]
    gives_way = (load / (35948.0 * length ** (8.0 / 9.0))) ** 0.9
    solution = nh.bearing.solve(PAIR, method="slices")
    assert solution.load == pytest.approx(load)
    assert solution.bearing.clearance == pytest.approx(-2.0 * gives_way / sine, rel=1e-4)
    assert nh.bearing.solve_many(PAIR, axial=[0.0], method="slices").load == pytest.approx(load)


def test_strips_and_their_ribs_have_it_too():
    case = read((CLEARANCE, 'preload = "2 kN" }'))
    assert pressed(case.mounted, "strips") == pytest.approx(2e3, rel=1e-4)
    assert case.solve().bearing == case.mounted


def test_it_is_that_of_rows_that_are_mounted_and_cold():
    seats = {"shaft": nh.bearing.Shaft(interference=0.012), "housing": nh.bearing.Housing(interference=0.0)}
    cold = nh.bearing.Mounting(**seats).mounted(PAIR, method="slices")
    assert cold.bearings[0].clearance == pytest.approx(-0.5 * 45.0 / 55.43 * 0.012 / math.tan(ROW.contact_angle))
    assert pressed(cold) == pytest.approx(2e3, rel=1e-4)
    fits = nh.bearing.Mounting(**seats, inner_temperature=60, outer_temperature=45)
    warm = fits.mounted(PAIR, method="slices")
    assert warm.clearance == pytest.approx(cold.clearance + fits.expansion(PAIR))
    assert warm.bearings[0].clearance < cold.bearings[0].clearance
    # With classes the rows are adjusted all the same, however tight their seats are.
    classed = nh.bearing.Mounting(shaft="k5", housing="H7")
    assert pressed(classed.mounted(PAIR, clearance="least", method="slices")) == pytest.approx(2e3, rel=1e-4)


def test_rows_expand_apart_by_their_distance_wherever_they_are():
    seats = {"shaft": nh.bearing.Shaft(interference=0.0), "housing": nh.bearing.Housing(interference=0.0)}
    fits = nh.bearing.Mounting(**seats, inner_temperature=80, outer_temperature=50, ring_expansion=12e-6)
    apart = 12e-6 * 30.0 * 20.0
    for arrangement, more in {"X": -apart, "O": apart, "tandem": 0.0}.items():
        pair = nh.bearing.paired(ROW, arrangement, 20.0)
        for x in (-10.0, 10.0), (0.0, 20.0), (25.0, 45.0):
            assert fits.expansion(dataclasses.replace(pair, x=x)) == pytest.approx(more, abs=1e-15)


def test_it_is_written_shown_and_read_back(tmp_path):
    case = read((CLEARANCE, 'preload = "2 kN" }'))
    case.write(tmp_path / "pair.toml")
    assert read_bearing(tmp_path / "pair.toml") == case
    solution = case.solve()
    assert ("preload", "2 kN", "axial, of the mounted rows without load") in summary_rows(case, solution)
    (tmp_path / "result.json").write_text(json.dumps(as_object(solution, case, None, "")))
    assert nh.read_result(tmp_path / "result.json").solution.bearing.clearance == pytest.approx(case.mounted.clearance)


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        (
            'preload = "2 kN", clearance = 0.01 }',
            "bearing.pair.preload = 2000.0 must not be given together with clearance",
        ),
        ("preload = -1 }", "bearing.pair.preload = -1.0 must be positive: give the axial force in N, or the clearance"),
    ],
)
def test_a_preload_that_is_none_is_one_sentence(text, sentence):
    with pytest.raises(nh.CaseError) as caught:
        read((CLEARANCE, text))
    assert [sentence in mistake for mistake in caught.value.mistakes] == [True]


def test_only_tapered_rows_against_each_other_have_one():
    roller = nh.Roller(diameter=9, length=10, profile=nh.profile.crown(radius=4000))
    rings = {"inner": nh.Ring(diameter=37.5), "outer": nh.Ring(diameter=-55.5)}
    straight = nh.bearing.CylindricalRollerBearing(roller=roller, **rings, rollers=13)
    for make in (
        lambda: nh.bearing.paired(ROW, "tandem", 40.0, preload=2e3),
        lambda: nh.bearing.paired(straight, "X", 20.0, preload=2e3),
    ):
        with pytest.raises(
            nh.InputError, match=r"preload = 2000\.0 must be left out except for two equal tapered rows in"
        ):
            make()
    with pytest.raises(nh.ConvergenceError, match="give smaller loads or displacements"):
        nh.bearing.solve(dataclasses.replace(PAIR, preload=1e9))


def test_a_preload_that_the_load_takes_is_said():
    def sentences(axial):
        case = BearingCase(PAIR, {"radial": 3e3, "axial": axial, "speed": 1000}, {"method": "slices"})
        return [str(limit.finding) for limit in case.limits(case.solve())]

    assert sentences(3e3) == []
    assert sentences(20e3) == ["Row 2 is unloaded: the preload of the pair is lost under load."]
