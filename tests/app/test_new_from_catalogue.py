"""Bearing files that begin with a catalogue."""

import tomllib

import pytest

import nonhertz as nh
from nonhertz.bearing.catalogue import from_catalogue

NU206 = ("d=30", "D=62", "B=16", "C=44kN", "C0=36500", "F=37.5", "E=55.5")
HR30306J = ("d=30", "D=72", "T=20.75", "C=59.5kN", "C0=60kN", "kind=tapered", "e=0.31")


@pytest.mark.parametrize("given", [NU206, HR30306J], ids=["cylindrical", "tapered"])
def test_a_file_holds_the_guess_and_is_solved(given, run, tmp_path):
    file = tmp_path / "bearing.toml"
    run("new", str(file), "--bearing", "--catalogue", *given)
    case = nh.read_bearing(file, {"solver.method": "slices"})
    (row,) = (each.bearing for each in case.bearing.rows)
    tapered = "kind=tapered" in given
    guess = (
        from_catalogue(30.0, 72.0, 20.75, 59.5e3, 60e3, kind="tapered", limiting_ratio=0.31)
        if tapered
        else from_catalogue(30.0, 62.0, 16.0, 44e3, 36.5e3, inner_raceway=37.5, outer_raceway=55.5)
    )
    assert row.rollers == guess.bearing.rollers
    assert row.pitch == pytest.approx(guess.bearing.pitch, rel=1e-5)
    assert row.roller_length == pytest.approx(guess.bearing.roller_length, rel=1e-5)
    # The ratings of the catalogue, not those of the standard.
    life = case.assess(case.solve())
    assert life.rating.dynamic == pytest.approx(guess.dynamic)
    assert life.rating.static == pytest.approx(guess.static)
    text = file.read_text(encoding="utf-8")
    comments = [line for line in text.splitlines() if line.startswith("#")]
    assert any("rollers of" in line for line in comments)
    assert any("times that of ISO 281" in line for line in comments)
    assert tomllib.loads(text)["roller"]["material"] == "100Cr6"


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (("d=30", "D=62"), "--catalogue = 'd=30 D=62' must include B, C and C0: add them, as in d=30"),
        ((*NU206, "z=13"), "--catalogue = 'z' must be a known symbol"),
        ((*NU206[1:], "d=70"), "D = 62.0 must exceed the bore of 70 mm"),
        ((*NU206[:3], "C=44kN", "C0=3650kN"), "C0 = 3650000.0 must be that of rollers which fit"),
        ((*NU206[:3], "C=44kg", "C0=36kN"), "C = '44kg' must"),
        ((*NU206, "kind=ball"), "kind = 'ball' must be one of"),
        ((*NU206, "e=0.3"), "e = 0.3 must be left out for a cylindrical bearing"),
    ],
)
def test_what_no_catalogue_has_is_refused(words, sentence, run):
    assert sentence in run("new", "--bearing", "--catalogue", *words, code=2).err


def test_a_catalogue_is_of_a_bearing(run):
    assert "must be given with --bearing" in run("new", "--catalogue", *NU206, code=2).err
    assert (
        "--template = 'needle' must not be given with --catalogue"
        in run("new", "--bearing", "--template", "needle", "--catalogue", *NU206, code=2).err
    )


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (("--designation", "NU 206"), "--designation = 'NU 206' must be given with --bearing"),
        (("--bearing", "--designation", "NU 206", "--rexs", "a.rexs"), "must not be given with --rexs"),
        (("--bearing", "--geometries", "own.csv"), "--geometries = 'own.csv' must be given with --designation"),
        (("--bearing", "--designation", "NU 206", "--geometries", "no.csv"), "--geometries = 'no.csv' must be a file"),
    ],
)
def test_options_of_designations_belong_together(words, sentence, run):
    assert sentence in run("new", *words, code=2).err


def test_a_designation_starts_a_file(run, tmp_path):
    file = tmp_path / "nu.toml"
    assert "nonhertz bearing" in run("new", str(file), "--bearing", "--designation", "NJ 2310").out
    assert tomllib.loads(file.read_text(encoding="utf-8"))["title"] == "NJ 2310"
