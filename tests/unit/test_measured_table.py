"""Profiles of kind "measured" in a case file: options, mistakes, and the schema."""

import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.testing import assert_allclose

from nonhertz.errors import AccuracyWarning, CaseError, InputError
from nonhertz.files.casefile import read_case
from nonhertz.files.measured import MeasuredProfile, validate_key
from nonhertz.files.mistakes import describe_mistake
from nonhertz.files.profiles import read_profile
from nonhertz.files.reading import ReadContext
from nonhertz.files.traces import read_trace
from nonhertz.measured import prepare

DOCS = Path(__file__).parents[2] / "docs"
RADIUS = 900.0


@pytest.fixture
def folder(tmp_path):
    y = np.linspace(0.0, 10.0, 2001)
    height = -1e3 * ((y - 5.0) ** 2 / (2.0 * RADIUS) + np.maximum(np.abs(y - 5.0) - 4.5, 0.0)) + 1.5 * y
    height += 0.1 * np.random.default_rng(1).standard_normal(len(y))
    text = "\n".join(f"{position:.4f}\t{value:.4f}" for position, value in zip(y, height, strict=True))
    (tmp_path / "roller.txt").write_text(text, encoding="utf-8")
    return tmp_path


def read(folder: Path, keys: str) -> Any:
    path = folder / "case.toml"
    table = '{ kind = "measured", file = "roller.txt"' + (", " + keys if keys else "") + " }"
    body = f"[body.a]\ndiameter = 10\nlength = 10\nprofile = [{table}]\n[body.b]\n[load]\nload = 1000\n"
    path.write_text(body, encoding="utf-8")
    return read_case(path).contact.a.profile


def test_the_file_is_prepared_as_from_python(folder):
    profile = read(folder, 'height_unit = "um"')
    expected = prepare(read_trace(folder / "roller.txt", height_unit="um")).profile()
    assert profile == expected
    # A noise of 0.1 um over the filter's width of some thirty points, and a chord at either end.
    assert_allclose(profile.relief([-4.0, 4.0]), 8.0 / RADIUS, atol=1e-4)


def test_every_step_can_be_set(folder):
    keys = 'height_unit = "um", level = false, align = "ends", trim = "8 mm", outliers = 6, smooth = "spline", '
    keys += 'cutoff = "250 um", slope = 0.1, points = 77, interpolation = "linear", shift = "1 mm", scale = 2'
    profile = read(folder, keys)
    trace = read_trace(folder / "roller.txt", height_unit="um")
    options: dict[str, Any] = {"level": False, "align": "ends", "trim": 8.0, "outliers": 6, "smooth": "spline"}
    expected = prepare(trace, **options, cutoff=0.25, slope=0.1, points=77).profile("linear")
    y = np.linspace(-3.0, 3.0, 7)
    assert_allclose(profile.relief(y + 1.0), 2.0 * expected.relief(y), rtol=1e-12)
    assert read(folder, keys + ", flip = true") == profile.flipped()


def test_roughness_that_is_left_in_is_warned_of(folder):
    with pytest.warns(AccuracyWarning, match="strips cannot resolve"):
        read(folder, 'height_unit = "um", smooth = false')


@pytest.mark.parametrize(
    ("keys", "sentence"),
    [
        ("", "profile[1].file = 'roller.txt' must state the unit of its heights"),
        ('heigth_unit = "um"', "Did you mean body.a.profile[1].height_unit?"),
        ('height_unit = "um", cutoff = "0.8"', "cutoff = '0.8' must have a unit"),
        ('height_unit = "um", cutoff = 40', "cutoff = 40.0 must lie between five points"),
        ('height_unit = "um", trim = "12 mm"', "trim = '12 mm' must lie within the points"),
        ('height_unit = "um", smooth = "median"', "smooth = 'median' must be true or false, or one of 'gaussian'"),
        ('height_unit = "um", align = "symmetry"', "align = 'symmetry' must find a place"),
        ('height_unit = "um", level = 1', "level = 1 must be True or False"),
        ('height_unit = "um", outliers = "5"', "outliers = '5' must be true or false, or a plain number"),
        ('height_unit = "um", points = 3', "points = 3 must be true or false, or 'auto' or a"),
        ("height_unit = true", "height_unit = True must be text: put it in quotes"),
        ('height_unit = "um", slope = -1', "slope = -1.0 must be positive"),
        ('height_unit = "um", step = "5 um"', "step = '5 um' must not be given for a file that has positions"),
        ('height_unit = "um", interpolation = "spline"', "interpolation = 'spline' must be one of 'pchip', 'linear'"),
        ('height_unit = "um", scale = nan', "scale = nan must be a finite number"),
        ('height_unit = "um", shift = inf', "shift = inf must be a finite number"),
        ('height_unit = "um", trim = [8]', "trim = [8] must be true or false, or 'auto' or a number in mm"),
        ('height_unit = "um", points = "all"', "points = 'all' must be true or false, or 'auto' or a whole number"),
        ('height_unit = "um", height_column = 1.5', "height_column = 1.5 must be the name of a column"),
        ('position_column = 1, height_column = 1', "height_column = 1 must differ from position_column"),
    ],
    ids=range(20),
)  # fmt: skip
def test_a_mistake_is_told_at_its_key(folder, keys, sentence):
    with pytest.raises(CaseError) as caught:
        read(folder, keys)
    (mistake,) = caught.value.mistakes
    assert sentence in mistake
    assert mistake.removeprefix("Unknown key ").startswith("body.a.profile[1].")


def test_all_mistakes_of_a_table_are_told_at_once(folder):
    with pytest.raises(CaseError) as caught:
        read(folder, 'level = 3, smooth = "x", cutof = 1')
    assert len(caught.value.mistakes) == 3


def test_a_table_without_a_file_says_so():
    with pytest.raises(InputError) as caught:
        read_profile({"kind": "measured"}, {}, ReadContext(Path()))
    assert [describe_mistake(mistake) for mistake in caught.value.each] == ["file must be given: name it in quotes."]


def test_no_file_is_read_where_none_may_be():
    with pytest.raises(InputError) as caught:
        read_profile({"kind": "measured", "file": "roller.txt"}, {}, ReadContext())
    (mistake,) = caught.value.each
    assert "file = 'roller.txt' must not be read here: give y and relief, or upload" in str(mistake)


def test_the_reference_lists_every_key():
    page = (DOCS / "reference" / "case-file.md").read_text(encoding="utf-8")
    section = page.split("### Measured profiles")[1].split("\n## ")[0]
    assert set(re.findall(r"^\| `(\w+)`", section, re.MULTILINE)) == set(MeasuredProfile.descriptions)


@pytest.mark.parametrize(
    ("name", "value", "meant"),
    [("cutoff", "250 um", 0.25), ("trim", "auto", "auto"), ("trim", 9, 9.0), ("points", 11, 11), ("level", True, True)],
    ids=range(5),
)
def test_values_are_taken_as_meant(name, value, meant):
    assert validate_key(name, value) == meant
