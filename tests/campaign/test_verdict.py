"""The checker of the campaigns is checked: it passes what is right and catches every wrong answer made here."""

import math
from dataclasses import replace

import numpy as np
import plain_case
import pytest
from verdict import solution_faults

import nonhertz as nh
from nonhertz.errors import without_accuracy_warnings
from nonhertz.result.outcome import Judgement

pytestmark = pytest.mark.campaign

CROWN = [{"of": "crown", "with": {"radius": 9000.0}, "shift": 0.0}]
STEEL = {"modulus": 207000.0, "poisson": 0.3}
FINITE = {
    "a": {"kind": "Roller", **STEEL, "diameter": 20.0, "length": 20.0, "profile": CROWN, "images": 2},
    "b": {"kind": "Ring", **STEEL, "diameter": -90.0, "length": 24.0, "position": 1.0, "depth": 9.0},
    "given": {"load": 2e4, "tilt": 3e-4},
    "element": "semi-elliptic",
    "strips": None,
}
SERIES = {**FINITE, "a": {**FINITE["a"], "images": "series"}, "element": "parabolic", "strips": 40}
BY_MOMENT = {**FINITE, "given": {"load": 5e3, "moment": 4e3}, "strips": 50}
BY_APPROACH = {**FINITE, "given": {"approach": 0.02, "moment": -500.0}, "strips": [-9.0, -5.0, *range(-4, 10)]}


def answer(case):
    contact, keywords = plain_case.arguments(case)
    with without_accuracy_warnings():
        return nh.solve(contact, **keywords)


def changed(case, which, **values):
    return {**case, which: {**case[which], **values}}


@pytest.mark.parametrize("case", [FINITE, SERIES, BY_MOMENT, BY_APPROACH])
def test_right_answers_pass(case):
    assert [kind for kind, _ in solution_faults(answer(case), case) if "without a word" not in kind] == []


def estimated(solution, **errors):
    """The judgement of a solution with other errors in its estimate."""
    names = ("contact_y", "edge_pressure", "singular_ends", "peaks_at_corner", "findings")
    known = {name: getattr(solution, name) for name in names}
    return {"judgement": Judgement.of(error_estimate=replace(solution.error_estimate, **errors), **known)}


WRONG_ARRAYS = {
    "all loads 0.1 % up": (lambda s: {"line_load": 1.001 * s.line_load, "load": 1.001 * s.load}, "other load"),
    "another share of the load": (
        lambda s: {"line_load": 0.7 * s.line_load, "load": 0.7 * s.load, "moment": 0.7 * s.moment},
        "other load",
    ),
    "a load reported that the strips lack": (lambda s: {"load": 1.001 * s.load}, "reported load"),
    "one strip 1e-4 up": (lambda s: {"line_load": s.line_load * (1.0 + 1e-4 * (np.arange(s.strips) == 40))}, "gap"),
    "one width 1e-4 up": (
        lambda s: {"element_half_width": s.element_half_width * (1.0 + 1e-4 * (np.arange(s.strips) == 40))},
        "curvature",
    ),
    "approach 1e-5 up": (lambda s: {"approach": s.approach * (1.0 + 1e-5)}, "gap in contact"),
    "other tilt": (lambda s: {"tilt": s.tilt * 1.0001}, "other tilt"),
    "a strip turned round": (lambda s: {"line_load": s.line_load * np.where(np.arange(s.strips) == 3, -1, 1)}, "neg"),
    "a strip lifted": (
        lambda s: {
            name: getattr(s, name) * (np.arange(s.strips) != 40) for name in ("line_load", "element_half_width")
        },
        "overlap out of contact",
    ),
    "a load of NaN": (lambda s: {"load": math.nan}, "not finite"),
    "a NaN among the loads": (lambda s: {"line_load": s.line_load * np.where(np.arange(s.strips) == 4, np.nan, 1)}, ""),
    "a stiffness without end": (lambda s: {"stiffness": np.full((2, 2), np.inf)}, "not finite"),
    "an estimate of NaN": (lambda s: estimated(s, max_pressure=math.nan), "estimate"),
    "a large estimate": (lambda s: estimated(s, approach=0.5), "large estimate"),
    "a doubled edge": (lambda s: {"edges": np.where(np.arange(s.strips + 1) == 5, s.edges[4], s.edges)}, "ascend"),
}


@pytest.mark.parametrize("name", WRONG_ARRAYS)
def test_wrong_arrays_are_caught(name):
    right = answer(FINITE)
    change, expected = WRONG_ARRAYS[name]
    kinds = [kind for kind, _ in solution_faults(replace(right, **change(right)), FINITE)]
    assert any(expected in kind for kind in kinds), kinds


WRONG_THEORY = {
    "kernel 5 % up": changed(FINITE, "b", modulus=207000.0 / 1.105),
    "an image dropped": changed(FINITE, "b", side_faces=("mirror", "none")),
    "fewer images of images": changed(FINITE, "a", images=1),
    "no depth": changed(FINITE, "a", depth="none"),
    "another depth": changed(FINITE, "b", depth=9.01),
    "tilted to the other side": {**FINITE, "given": {"load": 2e4, "tilt": -3e-4}},
    "a flatter crown": changed(FINITE, "a", profile=[{**CROWN[0], "with": {"radius": 9010.0}}]),
    "another diameter": changed(FINITE, "b", diameter=-90.01),
    "the other element": {**FINITE, "element": "parabolic"},
}


@pytest.mark.parametrize("name", WRONG_THEORY)
def test_answers_of_another_theory_are_caught(name):
    kinds = [kind for kind, _ in solution_faults(answer(WRONG_THEORY[name]), FINITE)]
    assert any("gap" in kind or "curvature" in kind or "tilt" in kind for kind in kinds), kinds


def test_a_place_of_contact_that_a_grid_misses_is_caught():
    two = [{"of": "Wave", "with": {"height": 0.2, "length": 10.0, "phase": math.pi}, "shift": 0.0}]
    case = changed({**FINITE, "given": {"approach": 0.02}, "strips": 80}, "a", profile=two)
    whole = answer(case)
    keep = whole.edges[whole.edges >= -1e-9]
    missed = answer({**case, "strips": keep.tolist()})
    vars(missed)["findings"] = ()
    assert "a place of contact missed" in [kind for kind, _ in solution_faults(missed, {**case, "strips": None})]
    assert "a place of contact missed" not in [kind for kind, _ in solution_faults(whole, {**case, "strips": None})]
