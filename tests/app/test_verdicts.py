"""One verdict for one file, whichever command is asked, and an exit code for scripts."""

import json
from pathlib import Path

import pytest

from nonhertz.files.casefile import Case
from nonhertz.web.view.jobs import solve as page_solves
from nonhertz.web.view.jobs import strength as page_searches

WHEEL = """
title = "Wheel on a track"
[body.a]
kind = "body"
diameter = 250.0
length = 40.0
profile = [{{ kind = "crown", radius = 300.0 }}]
material = {wheel}
[body.b]
kind = "body"
length = 60.0
material = {track}
[load]
load = {load}
"""
#: Materials of both bodies, load [N], and what is true: p0 by Hertz over 1.6 and 1.79 times the yield strength.
KINDS = {
    "yields": ('"EN-AW-6082-T6"', '"EN-AW-6082-T6"', 50000.0, "not-met", 4),
    "one of both yields": ('"100Cr6"', '"EN-GJL-250"', 50000.0, "not-met", 4),
    "yields not": ('"EN-GJS-700-2"', '"X105CrMo17"', 500.0, "met", 0),
    "pressure below": ('"100Cr6"', '"100Cr6"', 5000.0, "met", 0),
    "unknown": ("{ modulus = 3000, poisson = 0.4 }", '"100Cr6"', 5000.0, "not-judged", 5),
    "of no grade": ('"steel"', '"R260"', 5000.0, "not-judged", 5),
}


def level_of(run, *words: str) -> str:
    return str(run(*words, "--json").json["verdict"]["level"])


@pytest.mark.slow
@pytest.mark.parametrize("kind", KINDS)
def test_no_command_says_the_opposite_of_another(kind, folder, run):
    wheel, track, load, level, code = KINDS[kind]
    Path("wheel.toml").write_text(WHEEL.format(wheel=wheel, track=track, load=load), encoding="utf-8")
    assert level_of(run, "solve", "wheel.toml") == level
    assert [level_of(run, "stress", "wheel.toml", "--body", body) for body in "ab"] == [level, level]
    assert level_of(run, "life", "wheel.toml", "--model", "iso-16281") == level
    assert level_of(run, "sweep", "wheel.toml", "--over", f"load.load={0.5 * load}N,{load}N") == level
    (both,) = (run("solve", "wheel.toml", "--json").json,)
    assert both["verdict"]["level"] == level
    case = Case.of(both["case"], Path("wheel.toml"), files=False)
    quick = json.loads(page_solves(case.document, stress=False, body="a"))["verdict"]["level"].replace("_", "-")
    searched = json.loads(page_searches(case.document, body="a"))["verdict"]["level"].replace("_", "-")
    assert quick in {level, "not-judged"}
    assert searched == level
    run("report", "wheel.toml", "--out", "wheel.html")
    assert f'class="verdict-line {level.replace("-", "_")}"' in Path("wheel.html").read_text(encoding="utf-8")
    run("solve", "wheel.toml", "--judge", code=code)
    run("solve", "wheel.toml", "wheel.toml", "--judge", code=code)


def test_exit_codes_of_the_verdict(folder, run):
    text = WHEEL.format(wheel='"100Cr6"', track='"100Cr6"', load=200.0)
    Path("fine.toml").write_text(text, encoding="utf-8")
    Path("sharp.toml").write_text(text.replace("radius = 300.0", "radius = 3e6"), encoding="utf-8")
    run("solve", "fine.toml", "--judge")
    run("solve", "sharp.toml")
    run("solve", "sharp.toml", "--judge", code=4)
    run("map", "fine.toml", "--load", "100N:300N", "--judge", code=5)  # a map has no verdict
