"""Every example runs, and each gives a number that is known from elsewhere; so does the tutorial."""

import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scripts import script

import nonhertz as nh
from nonhertz.files.bearingfile import read_bearing
from nonhertz.files.casefile import Case, read_case

ROOT = Path(__file__).parents[2]
EXAMPLES = ROOT / "examples"


TABULATED = "tabulated-profile.csv"
MEASURED = "measured-roller.txt"


def case(name: str) -> Case:
    return read_case(EXAMPLES / f"{name}.toml")


def solved(example: Case) -> nh.Solution:
    return nh.solve(example.contact, **example.prescribed.keywords, **example.solver.keywords)


@pytest.mark.parametrize(("name", "static", "tolerance"), [("nu206", 36.5e3, 2e-3), ("tapered-pair", 60e3, 0.015)])
def test_the_bearings_have_the_static_rating_of_their_catalogues(name, static, tolerance):
    """C0 of ISO 76 from the rollers of the file beside the catalogue's, which for HR30306J has two digits."""
    row = read_bearing(EXAMPLES / f"{name}.toml").bearing.rows[0].bearing
    assert_allclose(nh.bearing.rating(row).static, static, rtol=tolerance)


def test_every_example_is_in_the_list():
    text = (EXAMPLES / "README.md").read_text(encoding="utf-8")
    listed = set(re.findall(r"^\| \[(.+?)\]", text, re.MULTILINE))
    runnable = {path.name for path in EXAMPLES.iterdir() if path.suffix in {".toml", ".py"}}
    assert listed == runnable


def test_the_bearing_reaches_4000_mpa_at_its_static_rating():
    """The dimensions fit together: by this pressure on the most loaded roller, ISO 76 defines C0.

    ISO 76 counts a line contact over the whole effective length. The free ends of the roller and its profile take
    load from the ends, so that the middle carries 1.2 % more.
    """
    static_rating, rollers = 36.5e3, 13
    contact = case("cylindrical-roller-bearing").contact
    solution = nh.solve(contact, load=5 * static_rating / rollers, tilt=0)
    middle = float(np.interp(0.0, solution.y, solution.centre_pressure))
    # Room for that, and for a length and ratings of two or three digits.
    assert_allclose(middle, 4000, rtol=0.025)


def test_the_bearing_is_loaded_as_its_radial_load_and_misalignment_say():
    example = case("cylindrical-roller-bearing")
    # Stribeck's rule, 5 / 13 of 11 kN; the file rounds to two digits.
    assert_allclose(example.prescribed.load, 5 / 13 * 11e3, rtol=0.01)
    solution = solved(example)
    # The logarithm has its poles at the ends of the effective length: contact ends inside, without an edge.
    (low, high), *others = solution.contact_y
    assert not others
    assert -4.4 < low < high < 4.4
    assert solution.moment > 0
    assert not solution.warnings


def test_what_the_point_contact_says_of_hertz_is_true():
    text = (EXAMPLES / "elliptical-point-contact.toml").read_text(encoding="utf-8")
    compliance = 2 * nh.MATERIALS["steel"].compliance
    exact = nh.hertz.point_contact(load=1000, radius_x=10, radius_y=100, compliance=compliance)
    found = re.findall(r"(\w+) = ([\d.]+) M?[mP]", text.split("[body.a]")[0])
    stated = {name: float(value) for name, value in found}
    assert set(stated) == {"max_pressure", "half_width", "half_length", "approach"}
    for name, value in stated.items():
        # Seven digits are written.
        assert_allclose(value, getattr(exact, name), rtol=5e-7, err_msg=name)


def test_the_tabulated_profile_is_what_its_script_writes(tmp_path):
    written = script(EXAMPLES / "make_tabulated_profile.py").main(tmp_path)
    assert written.read_text(encoding="utf-8") == (EXAMPLES / TABULATED).read_text(encoding="utf-8")


def test_the_tabulated_profile_gives_what_its_formula_gives(tmp_path):
    """The way through the file, its units and the curve through its points changes nothing that matters."""
    make = script(EXAMPLES / "make_tabulated_profile.py")

    class Formula(nh.profile.Profile):
        def relief(self, y):
            return make.relief(np.asarray(y, dtype=float))

    example = case("tabulated-profile")
    roller = nh.Roller(diameter=16, length=24, profile=Formula(), material=example.contact.a.material)
    assert replace(example.contact.a, profile=roller.profile) == roller
    direct = nh.solve(nh.Contact(roller, example.contact.b), **example.prescribed.keywords)
    # Points are rounded to 10 nm, 3e-4 of the approach at each point and far less in the mean.
    assert_allclose(solved(example).approach, direct.approach, rtol=1e-4)


def test_the_measured_roller_is_what_its_script_writes(tmp_path):
    written = script(EXAMPLES / "make_measured_roller.py").main(tmp_path)
    assert written.read_text(encoding="utf-8") == (EXAMPLES / MEASURED).read_text(encoding="utf-8")


def test_the_measured_roller_is_the_profile_below_what_the_machine_added():
    """Tilt, place, chamfers, dust and roughness are gone: the contact is that of the profile they were added to."""
    make = script(EXAMPLES / "make_measured_roller.py")
    example = case("measured-roller")
    true = replace(example.contact.a, profile=make.profile(), chamfer=make.CHAMFER)
    direct = nh.solve(nh.Contact(true, example.contact.b), **example.prescribed.keywords)
    found = solved(example)
    # The waviness of 50 nm stays, and of the roughness 20 nm in waves of the cutoff: 0.07 um of 11 um of approach, and
    # with curvatures of 4 pi^2 * 50 nm / (1.9 mm)^2 a few per cent of pressure.
    assert_allclose(found.approach, direct.approach, atol=7e-5)
    assert_allclose(found.max_pressure, direct.max_pressure, rtol=0.04)


def test_the_sweep(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    sweep = script(EXAMPLES / "misalignment_sweep.py")
    pressures = sweep.main()
    printed = capsys.readouterr().out
    assert len(printed.splitlines()) == 2 + len(sweep.TILTS)
    assert (tmp_path / "out" / "misalignment-sweep.svg").stat().st_size > 0
    # The straight roller upright as a half-space, by the same independent program; near a sharp end strips are held
    # to 1 %.
    monkeypatch.setattr(sweep, "ROLLER", replace(sweep.ROLLER, side_faces="none", depth="none"))
    monkeypatch.setattr(sweep, "TILTS", sweep.TILTS[:1])
    ((middle, end),) = sweep.sweep(sweep.PROFILES["straight"])
    assert_allclose(middle, 1797.52, rtol=1e-3)
    assert_allclose(end, 2168.60, rtol=1e-2)
    # A free end is softer: it leaves more of the load to the middle.
    assert np.all(pressures["straight"][0] * [1, -1] > np.array([middle, -end]))


@pytest.mark.parametrize("name", ["first-solve", pytest.param("bearing-life", marks=pytest.mark.slow)])
def test_tutorials_show_what_the_program_prints(name, monkeypatch):
    monkeypatch.setenv("COLUMNS", "100")
    page = (ROOT / "docs" / "tutorials" / f"{name}.md").read_text(encoding="utf-8")
    now = script(ROOT / "docs" / "figures.py").with_output(page)
    # An estimate of an error is good for its decade only; all other digits that are printed hold anywhere.
    estimate, number = re.compile(r" *error about .*"), re.compile(r"-?\d+\.?\d*(?:e[+-]\d+)?")
    told, tells = (estimate.sub("", text).splitlines() for text in (page, now))
    assert [number.sub("0", line) for line in tells] == [number.sub("0", line) for line in told]
    for line, old in zip(tells, told, strict=True):
        numbers, before = ([float(n) for n in number.findall(text)] for text in (line, old))
        assert_allclose(numbers, before, rtol=2e-4, err_msg="run: python docs/figures.py")
