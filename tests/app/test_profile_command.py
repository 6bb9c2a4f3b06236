"""``nonhertz profile`` as a user meets it: steps, numbers, files, refusals, exit codes."""

import tomllib
from pathlib import Path

import jsonschema
import numpy as np
import pytest
from numpy.testing import assert_allclose

from nonhertz.files.casefile import read_case
from nonhertz.files.schemas import schema_of

RADIUS = 900.0
FILES = {"profile.csv", "profile.json", "profile.toml", "profile-steps.svg", "profile-steps.png", "profile-steps.csv"}


@pytest.fixture
def file(tmp_path, monkeypatch):
    """A crown with chamfers, tilted, rough by 0.1 um, heights in um without saying so."""
    monkeypatch.chdir(tmp_path)
    y = np.linspace(0.0, 10.0, 2001)
    height = -1e3 * ((y - 5.0) ** 2 / (2.0 * RADIUS) + np.maximum(np.abs(y - 5.0) - 4.5, 0.0)) + 1.5 * y
    height += 0.1 * np.random.default_rng(1).standard_normal(len(y))
    text = "\n".join(f"{position:.4f}\t{value:.4f}" for position, value in zip(y, height, strict=True))
    Path("roller.txt").write_text(text, encoding="utf-8")
    return "roller.txt"


def test_the_steps_the_roughness_and_the_best_fit_are_printed(file, run):
    printed = run("profile", file, "--height-unit", "um", "--fit", "best").out
    for word in ("raw", "level", "align", "trim", "outliers", "smooth", "thin", "relief", "roughness", "fit"):
        assert f"\n{word} " in printed, word
    first = printed.split("behind\n")[1].split()[0]
    assert first == "crown"
    assert "warning" not in printed


def test_heights_alone_take_their_step_from_the_option(file, run):
    heights = [line.split("\t")[1] for line in Path(file).read_text(encoding="utf-8").splitlines()]
    Path("alone.txt").write_text("\n".join(heights), encoding="utf-8")
    assert "give --step, such as 0.5um" in run("profile", "alone.txt", code=2).err
    found = run("profile", "alone.txt", "--step", "5um", "--height-unit", "um", "--fit", "crown", "--json").json
    pairs = run("profile", file, "--height-unit", "um", "--fit", "crown", "--json").json
    assert_allclose(found["fits"][0]["parameters"]["radius"], pairs["fits"][0]["parameters"]["radius"], rtol=1e-9)


def test_roughness_that_is_left_in_is_warned_of(file, run):
    assert "warning: Waves shorter than" in run("profile", file, "--height-unit", "um", "--smooth", "no").out


def test_json_has_all_numbers(file, run):
    found = run("profile", file, "--height-unit", "um", "--fit", "crown", "--json").json
    jsonschema.validate(found, schema_of("profile"))
    assert [step["name"] for step in found["steps"]] == [
        "raw", "level", "align", "trim", "outliers", "smooth", "thin"
    ]  # fmt: skip
    assert_allclose(found["steps"][1]["tilt"], 1.5e-3, rtol=0.02)
    # Four standard errors, of a fit that knows its own.
    (fit,) = found["fits"]
    error = fit["standard_errors"]["radius"]
    assert_allclose(fit["parameters"]["radius"], RADIUS, atol=4.0 * error)
    assert_allclose(found["roughness"]["rq"], 1e-4, rtol=0.1)
    assert len(found["y"]) == len(found["relief"]) == found["steps"][-1]["points"]


@pytest.mark.slow
def test_what_is_written_is_what_a_case_file_reads(file, tmp_path, run):
    """The piece of a case file, the table and the numbers are one profile."""
    run("profile", file, "--height-unit", "um", "--cutoff", "0.5 mm", "--fit", "crown", "--out", "out")
    out = tmp_path / "out"
    assert {path.name for path in out.iterdir()} == FILES
    text = (out / "profile.toml").read_text(encoding="utf-8")
    asked = tomllib.loads(text)["profile"][0]
    assert asked == {"kind": "measured", "file": "../roller.txt", "height_unit": "um", "cutoff": 0.5}
    cases = [text, *("\n" + line[2:] for line in text.splitlines() if line.startswith("# profile = "))]
    reliefs = []
    for lines in cases:
        kept = "\n".join(line for line in lines.splitlines() if not line.startswith("#"))
        body = f"[body.a]\ndiameter = 10\nlength = 10\n{kept}\n[body.b]\n[load]\nload = 1000\n"
        (out / "case.toml").write_text(body, encoding="utf-8")
        reliefs.append(read_case(out / "case.toml").contact.a.profile.relief(np.linspace(-4.0, 4.0, 33)))
    measured, tabulated, fitted = reliefs
    # The table has picometres; a crown has no roughness, of which the filter leaves 10 nm, and the highest point of
    # what is left is as much above the crown.
    assert_allclose(tabulated, measured, atol=2e-9)
    assert_allclose(fitted, measured, atol=8e-5)


def test_options_mean_what_they_say(file, run):
    words = ["--no-level", "--align", "no", "--trim", "no", "--outliers", "no", "--smooth", "spline", "--points", "99"]
    found = run("profile", file, "--height-unit", "um", *words, "--json").json
    assert [step["name"] for step in found["steps"]] == ["raw", "smooth", "thin"]
    assert len(found["y"]) == 99


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        ([], "FILE = 'roller.txt' must state the unit of its heights"),
        (["--height-unit", "um", "--cutoff", "90"], "--cutoff = 90.0 must lie between five points"),
        (
            ["--height-unit", "um", "--smooth", "median"],
            "--smooth = 'median' must be true or false, or one of 'gaussian', 'spline'",
        ),
        (["--height-unit", "um", "--fit", "circle"], "--fit = 'circle' must be one of 'straight'"),
        (["--height-unit", "um", "--outliers", "many"], "--outliers = 'many' must be true or false, or a plain number"),
        (["--height-column", "5"], "--height-column = 5 must be a column from 1 to 2"),
        (["--height-unit", "um", "--out", "roller.txt"], "--out = 'roller.txt' must be a directory, not a file"),
    ],
    ids=range(7),
)
def test_a_mistake_ends_in_one_sentence_and_two(file, words, sentence, run):
    complaint = run("profile", file, *words, code=2).err
    assert sentence in complaint
    assert complaint.count("\n") == 1
    assert not Path("out").exists()


def test_a_missing_file_is_told(tmp_path, monkeypatch, run):
    monkeypatch.chdir(tmp_path)
    assert "FILE = 'none.txt' must be a file that can be read" in run("profile", "none.txt", code=2).err
