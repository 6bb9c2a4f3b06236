"""Films of oil between rollers and rings: published formulas and numbers, speeds along rollers, and what is said."""

import json
import math
import re
import tempfile
from pathlib import Path

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.bearing.film import dowson_higginson, films, hamrock_dowson, pan_hamrock, surface_speeds
from nonhertz.bearing.quantities import QUANTITIES, SolvedBearing
from nonhertz.figures.film import film_figures
from nonhertz.figures.value import Level as Height
from nonhertz.files.bearing_results import files as written
from nonhertz.files.starting import starting_bearing
from nonhertz.show.bearing import solution_sections
from nonhertz.show.films import film_rows
from nonhertz.verdict import Level, judge_bearing

OIL = nh.bearing.Lubrication(oil="ISO VG 68", temperature=70)


# What is published


def test_the_roller_of_a_course_has_its_central_film_over_its_least_one():
    # Assignment 3 of a course after Hamrock, Schmid, Jacobson (VictorLier/Tribology on GitHub, Assignment3/data/4.1):
    # 20 rollers of 8 x 8 mm on 69.5 mm under 8 kN at 837 rad/s in 0.01 Pa s, alpha = 20 / GPa; h_c / h_min = 1.070103.
    modulus, radius = 210e3 / (1 - 0.3**2), 1.0 / (2 / 8 + 2 / 69.5)
    load = 4 * 8e3 / 20 / 8 / (modulus * radius)
    speed = 77.5 * 837 / 4 * (1 + (8 / 77.5) ** 2)  # as there
    least, central = pan_hamrock(np.array([1e-8 * speed / (modulus * radius)]), 20e-3 * modulus, np.array([load]))
    assert central / least == pytest.approx([1.070102994389823], rel=1e-9)


def test_of_steel_the_least_film_is_that_of_the_dimensional_formula():
    # Equation 18.73 there: h_min = 1.806 (w')^-0.128 (eta u)^0.694 xi^0.568 R^0.434, in m, N, Pa, s.
    modulus, radius, q, viscosity, alpha, speed = 228e9, 0.0036, 3e5, 0.012, 2.2e-8, 8.0
    least, _ = pan_hamrock(
        np.array([viscosity * speed / (modulus * radius)]), alpha * modulus, np.array([q / (modulus * radius)])
    )
    published = 1.806 * q**-0.128 * (viscosity * speed) ** 0.694 * alpha**0.568 * radius**0.434
    assert least * radius == pytest.approx([published], rel=1e-3)


@pytest.mark.parametrize(("ellipticity", "factor"), [(1.0, 1.90), (math.inf, 2.69)])
def test_the_central_film_of_a_circle_and_of_a_line(ellipticity, factor):
    # Of Hamrock and Dowson, as the public program tribology has them.
    one = np.ones(1)
    _, central = hamrock_dowson(2.0 * one, 3.0, 4.0 * one, ellipticity)
    assert central == pytest.approx(factor * 2.0**0.67 * 3.0**0.53 * 4.0**-0.067, rel=1e-3)


@pytest.mark.parametrize("speed", [1e-11, 5e-11])
@pytest.mark.parametrize("load", [5e-5, 3e-4])
def test_both_formulas_of_lines_say_much_the_same(speed, load):
    least, central = pan_hamrock(np.array([speed]), 5e3, np.array([load]))
    assert dowson_higginson(np.array([speed]), 5e3, np.array([load])) == pytest.approx(least, rel=0.12)
    assert 1.0 < central / least < 1.3


# In bearings


def case(template="cylindrical", oil=True, **changes):
    """Return the bearing of a template, solved by slices, with an oil by its grade or none."""
    text = re.sub(r"\[lubrication\]\n(.+\n)+", "", starting_bearing(template))
    if oil:
        text += '\n[lubrication]\noil = "ISO VG 68"\ntemperature = 70\n'
    path = Path(tempfile.mkdtemp(), f"{template}.toml")
    path.write_text(text, encoding="utf-8")
    return nh.read_bearing(path, {"solver.method": "slices"} | changes)


ROUGH = {f"{part}.roughness": rq for part, rq in (("roller", "0.05 um"), ("inner", "0.08 um"), ("outer", "0.1 um"))}


def test_the_film_of_a_roller_is_that_of_its_load_radius_and_speed():
    given = case()
    found = given.films(given.solve())
    row = given.bearing
    j, k = found.least
    assert (j, k) == (0, 0)
    motion = row.kinematics(inner_speed=3000)
    speed = (3000 - motion.cage_speed) * 2 * math.pi / 60 * row.inner.diameter / 2
    assert found.entrainment[0, 0] == pytest.approx(speed, rel=2e-3)
    modulus, radius = 207e3 / (1 - 0.3**2), 1.0 / (2 / row.roller_diameter + 2 / row.inner.diameter)
    largest = max(each.line_load.max() for each in found.contacts if 0 in each.rollers and each.ring == "inner")
    oil = given.lubrication
    args = oil.dynamic_viscosity * speed / (modulus * radius), oil.pressure_coefficient * modulus
    least, _ = pan_hamrock(np.array([args[0]]), args[1], np.array([largest / (modulus * radius)]))
    assert found.least_film[0, 0] == pytest.approx(float(least[0]) * radius, rel=0.02)


def test_strips_and_slices_have_much_the_same_films():
    strips, slices = (case(**{"solver.method": method}) for method in ("strips", "slices"))
    one, other = (each.films(each.solve()) for each in (strips, slices))
    assert one.least_film[0] == pytest.approx(other.least_film[0], rel=0.05)
    assert one.rib_sliding == pytest.approx(other.rib_sliding, rel=1e-9, nan_ok=True)


def test_a_film_grows_with_the_speed_and_hardly_shrinks_with_the_load():
    slow = case().solve()
    base = films(slow, speed=1000, lubrication=OIL).least_film[0, 0]
    assert films(slow, speed=2000, lubrication=OIL).least_film[0, 0] == pytest.approx(base * 2**0.694, rel=1e-9)
    heavy = nh.bearing.solve(case().bearing, radial=24e3, method="slices")
    assert 0.85 < films(heavy, speed=1000, lubrication=OIL).least_film[0, 0] / base < 0.95


def test_cones_that_meet_in_a_point_roll_all_along_and_barrels_and_washers_do_not():
    y = np.linspace(-2.5, 2.5, 5)
    for template, most in (("tapered-pair", 0.004), ("spherical", 0.03), ("thrust", 0.2)):
        row = case(template, **{"load.speed": 500}).bearing.rows[0].bearing
        motion = row.kinematics(inner_speed=500)
        for ring in (0, 1):
            raceway, roller = surface_speeds(row, ring, motion, y)
            sliding = np.abs(raceway - roller) / (0.5 * (raceway + roller))
            assert sliding[2] == pytest.approx(0.0, abs=1e-9)
            assert 0.0 < sliding.max() < most


def test_the_smallest_film_parameter_counts_though_the_film_is_least_at_the_smoother_ring():
    rough = case(**ROUGH | {"outer.roughness": "0.8 um"})
    found = rough.films(solved := rough.solve())
    smallest = found.least_film[0, 1] / math.hypot(0.05e-3, 0.8e-3)
    assert (found.least, found.least_parameter) == ((0, 0), (0, 1))
    assert smallest < 0.4 * found.film_parameter[0, 0]
    finding = next(f for f in judge_bearing(solved, None, None, found).findings if f.kind == "film")
    assert dict(finding.numbers)["parameter"] == pytest.approx(smallest)
    assert next(row for row in film_rows(rough, found) if row[0] == "film parameter") == (
        "film parameter", f"{smallest:.3g}",
        "lambda: minimum film over combined Rq, outer ring, roller 1 at 0.0 degrees",
    )  # fmt: skip
    for figure in film_figures(found).values():
        levels = [mark.y for mark in figure.panels[0].marks if isinstance(mark, Height)]
        assert levels == pytest.approx([math.hypot(0.05e-3, 0.08e-3), math.hypot(0.05e-3, 0.8e-3)])


def test_different_rows_have_their_own_speeds_and_roughness():
    def row(diameter, rollers, rough):
        roller = nh.Roller(diameter=diameter, length=10, roughness=rough, profile=nh.profile.crown(radius=4000))
        inner, outer = (nh.Ring(diameter=size, roughness=rough) for size in (46.5 - diameter, -46.5 - diameter))
        return nh.bearing.CylindricalRollerBearing(roller=roller, inner=inner, outer=outer, rollers=rollers)

    rows = row(9.0, 13, 1e-4), row(20.0, 6, 5e-4)
    both = nh.bearing.Paired(bearings=rows, x=(-10, 10), turned=(False, False))
    found = films(nh.bearing.solve(both, radial=10e3, method="slices"), speed=3000, lubrication=OIL)
    for first, single in ((0, rows[0]), (13, rows[1])):
        # In the cage's frame the inner ring turns at n (1 + D / d) / 2.
        inner = 46.5 - single.roller_diameter
        speed = 0.5 * 3000 * (1 + single.roller_diameter / 46.5) * math.pi / 30 * inner / 2
        assert found.entrainment[first] == pytest.approx([speed, speed], rel=2e-3)
        assert found.roughness[first] == pytest.approx(math.sqrt(2) * single.roller.roughness)
    assert [motion.rollers for motion in found.kinematics] == [13, 6]
    shown = [row for section in solution_sections(found.solution) for table in section[1] for row in table.rows]
    assert [row[1:] for row in shown if row[0] == "rollers"] == [
        ("13, 9 x 10 mm", "in row 1, pitch circle 46.5 mm"),
        ("6, 20 x 10 mm", "in row 2, pitch circle 46.5 mm"),
    ]


def test_the_film_parameter_is_judged_where_the_roughness_is_known():
    plain, rough = case(), case(**ROUGH)
    solved = plain.solve()
    assert plain.films(solved).film_parameter is None
    assert ("film parameter", "not judged", "give roughness, Rq, of rollers and both rings") in film_rows(
        plain, plain.films(solved)
    )
    found = rough.films(solved := rough.solve())
    expected = found.least_film[0, 0] / math.hypot(0.05e-3, 0.08e-3)
    assert found.film_parameter[0, 0] == pytest.approx(expected)
    verdict = judge_bearing(solved, None, None, found)
    assert [each.kind for each in verdict.findings if each.kind == "film"] == ["film"]
    assert "The smallest film parameter lambda is" in str(next(f for f in verdict.findings if f.kind == "film"))
    coarse = case(**dict.fromkeys(ROUGH, "1 um"))
    solved = coarse.solve()
    verdict = judge_bearing(solved, None, None, coarse.films(solved))
    assert verdict.level is Level.STRAINED
    assert "which shortens the life unless additives protect them" in verdict.sentence


def test_without_a_speed_or_an_oil_a_film_is_not_judged():
    still = case(oil=False, **{"load.speed": None})
    solved = still.solve()
    assert still.films(solved) is None
    assert film_rows(still, None) == [("minimum film", "not judged", "give load.speed and an oil in [lubrication]")]
    with pytest.raises(nh.InputError, match=r"lubrication = .* must have a viscosity"):
        films(solved, speed=1000, lubrication=nh.bearing.Lubrication())
    with pytest.raises(nh.InputError, match=r"speed = -1 must be positive"):
        films(solved, speed=-1, lubrication=OIL)


def test_a_thrust_bearing_has_films_and_a_life_that_is_not_modified():
    given = case("thrust", **{"load.speed": 1000})
    solved = given.solve()
    assert given.films(solved).least is not None
    assert given.assess(solved).life_factor is None


def test_files_and_figures_have_the_films():
    given = case("tapered-pair", **ROUGH)
    solved = given.solve()
    found = given.films(solved)
    texts = written(solved, given, *given.rated(solved))
    film = json.loads(texts["result.json"])["film"]
    assert film["least_film"][0][0] == found.least_film[0, 0]
    assert film["rib_sliding"][1] is None
    assert film["rib_sliding"][0] > 0.0
    assert "least_film_inner [mm]" in texts["rollers.csv"].splitlines()[0]
    head, *rows = texts["lines.csv"].splitlines()
    at = head.split(",").index("least_film [mm]")
    along = [row.split(",")[at] for row in rows if row.startswith("1,inner,")]
    assert min(float(film) for film in along if film) == found.least_film[0, 0]
    drawn = film_figures(found)
    assert list(drawn) == ["film", "film-along"]
    assert len(drawn["film"].panels) == 2
    assert QUANTITIES["least_film"].get(SolvedBearing(given, solved)) == np.nanmin(found.least_film)
