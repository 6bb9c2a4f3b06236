"""Every public function and method against wrong types and values: the right answer or one sentence, nothing else."""

from __future__ import annotations

import importlib
import inspect
from typing import Any

import numpy as np
import pytest

import nonhertz as nh
from nonhertz import bearing, hertz, life, measured, profile, subsurface

pytestmark = pytest.mark.filterwarnings("ignore::nonhertz.AccuracyWarning")

# Sorts of arguments
NONSENSE: dict[str, Any] = {
    "none": None,
    "text": "abc",
    "empty text": "",
    "true": True,
    "nan": float("nan"),
    "inf": float("inf"),
    "minus inf": -float("inf"),
    "huge": 1e308,
    "tiny": 1e-320,
    "minus one": -1.0,
    "zero": 0,
    "three": 3,
    "half": 0.5,
    "empty": [],
    "row": [1.0, 2.0, 3.0],
    "square": [[1.0, 2.0], [3.0, 4.0]],
    "ragged": [[1.0], [2.0, 3.0]],
    "mixed": [1.0, None],
    "words": ["a"],
    "row with nan": [1.0, float("nan")],
    "complex": 1j,
    "complex array": np.array([1j]),
    "array": np.array(1.0),
    "dictionary": {},
    "object": object(),
    "function": lambda *_: None,
}
NO_NUMBER = {"text", "empty text", "true", "nan", "complex", "complex array", "dictionary", "object", "function"}
NO_NUMBERS = NO_NUMBER | {"none", "ragged", "mixed", "words", "row with nan"}
NUMBER = NO_NUMBERS | {"inf", "minus inf", "huge", "empty", "row", "square"}
POSITIVE = NUMBER | {"minus one", "zero"}
ALL = set(NONSENSE)
#: What must be refused of every sort of argument; the rest may be in range or not.
REFUSED: dict[str, set[str]] = {
    "number": NUMBER,
    "number?": NUMBER - {"none"},
    "not negative": NUMBER | {"minus one"},
    "positive": POSITIVE | {"tiny"},
    "positive?": (POSITIVE | {"tiny"}) - {"none"},
    "angle": POSITIVE | {"three"},
    "load": POSITIVE | {"tiny"},
    "share": POSITIVE | {"three"},
    "whole": POSITIVE | {"half"},
    "whole?": (POSITIVE | {"half"}) - {"none"},
    "count": NUMBER | {"minus one", "half"},
    "numbers": NO_NUMBERS | {"inf", "minus inf", "huge"},
    "positive numbers": NO_NUMBERS | {"inf", "minus inf", "huge", "zero", "minus one"},
    "row": NO_NUMBERS | {"inf", "huge", "minus one", "zero", "three", "half", "empty", "square", "array"},
    "row?": (NO_NUMBERS | {"inf", "huge", "minus one", "zero", "three", "half", "empty", "square", "array"}) - {"none"},
    "table": ALL,
    "many": NO_NUMBERS | {"inf", "minus inf", "huge", "empty"},
    "many?": (NO_NUMBERS | {"inf", "minus inf", "huge", "empty"}) - {"none"},
    "flag": ALL - {"true"},
    "word": ALL,
    "name": ALL - {"text", "empty text"},
    "names": ALL - {"empty"},
    "function?": ALL - {"none", "function"},
    "file": ALL,
    "strips": ALL - {"none", "three", "row"},
    "cells": ALL - {"none"},
    "models": ALL - {"empty"},
    "thing": ALL,
    "several": ALL,
    "all": ALL,
    "tilts": ALL - {"zero", "tiny"},
    "stations": ALL - {"three", "array"},
    "options": ALL - {"dictionary"},
    # Below the contact, of which half a millimetre is.
    "edge?": POSITIVE - {"none", "half", "tiny", "zero"},
    "optional": ALL - {"none"},
    "seed?": NUMBER - {"none"} | {"minus one", "half"},
    "given options": ALL - {"none", "dictionary"},
    "given names": ALL - {"none", "empty"},
    # Which names there are is for the study to say.
    "any names": ALL - {"empty", "words"},
    "given any names": ALL - {"none", "empty", "words"},
    "spread": ALL - {"row"},
    "directory": ALL - {"none", "text", "empty text"},
    "open shares": NO_NUMBERS | {"inf", "minus inf", "huge", "minus one", "three", "row", "square", "zero"},
    "shares": NO_NUMBERS | {"inf", "minus inf", "huge", "minus one", "three", "row", "square"},
    "endless": POSITIVE - {"inf"},
    "unbounded": POSITIVE - {"huge"},  # a contact knows its own bounds of a load
    "intervals": ALL - {"empty", "square"},
    "lines": ALL - {"empty", "words"},
    "index": ALL - {"zero", "minus one"},
    "diameter": NUMBER - {"none", "function"} | {"zero"},
    "diameter?": NUMBER - {"none", "function"} | {"zero"},
    "rule": ALL - {"zero", "half", "three", "tiny", "array"},
    "depth": ALL - {"none", "half", "three", "tiny", "array"},
    "images": ALL - {"three", "array"},
    "prepared": ALL - {"none", "true", "half", "three", "array", "tiny", "zero"},
}


#: Of these only what must be refused is tried.
SLOW = {
    "bearing.maps", "compare", "map", "life.assess", "life.exposure", "life.overrolled", "measured.fit",
    "measured.fit_best", "measured.prepare", "strength.assess", "subsurface.extremes", "sweep", "tolerance",
}  # fmt: skip
#: What takes any keyword and refuses those that it does not know itself.
BY_THEMSELVES = {"life.model", "measured.fit", "profile.with_drop"}
MODULES = {
    "": nh,
    "bearing.": bearing,
    "hertz.": hertz,
    "life.": life,
    "measured.": measured,
    "profile.": profile,
    "study.": nh.study,
    "subsurface.": subsurface,
}


@pytest.fixture(scope="module")
def table():
    """The module of all entries, which is imported when the tests begin: it solves what they need."""
    return importlib.import_module("public_arguments")


def entries_of(module, table):
    """The entries of one module, by their names."""
    others = tuple(each for each in MODULES if each)
    return {name: each for name, each in table.ENTRIES.items() if name.startswith(module or others) == bool(module)}


@pytest.mark.parametrize("module", MODULES)
def test_the_good_arguments_are_taken_and_unknown_keywords_refused_by_name(module, table):
    for name, case in entries_of(module, table).items():
        case.call(**case.good)
        with pytest.raises((TypeError, *[nh.InputError] * (name in BY_THEMSELVES)), match="unknown_keyword"):
            case.call(**case.good, unknown_keyword=1)


@pytest.mark.parametrize("module", MODULES)
def test_nonsense_ends_in_the_right_answer_or_in_one_sentence(module, table):
    wrong = []
    for name, case in entries_of(module, table).items():
        for argument, sort in case.sorts.items():
            for what, value in NONSENSE.items():
                if name not in SLOW or what in REFUSED[sort]:
                    ended = how_ends(case, argument, value)
                    if ended == "taken" and what not in REFUSED[sort]:
                        continue
                    if ended:
                        wrong.append(f"{name}: {argument} = {what}: {ended}")
    assert not wrong, "\n".join(wrong)


def how_ends(case, argument, value):
    """Return what is wrong with the end of a call, "taken" where it returns, or nothing where it refuses well."""
    try:
        case.call(**case.good | {argument: value})
    except nh.InputError as error:
        return "" if " must " in str(error) and len(str(error).splitlines()) == 1 else str(error)
    except (nh.ConvergenceError, *case.raises):
        return ""
    except Exception as error:  # noqa: BLE001  (whatever it is, it is wrong)
        return repr(error)
    return "taken"


def test_what_a_verb_does_not_return_is_no_option_of_it(table):
    with pytest.raises(TypeError, match=r"passage\(\) got an unexpected keyword argument 'displacement'"):
        subsurface.passage(table.SOLUTION, 0.0, 0.1, displacement=True)
    with pytest.raises(TypeError, match=r"extremes\(\) got an unexpected keyword argument 'displacement'"):
        subsurface.extremes(table.SOLUTION, displacement=True)


def test_shares_out_of_range_and_what_is_no_spectrum_are_refused(table):
    solution = table.SOLUTION
    for share in (1e308, 1e300, float("inf"), float("nan"), -1.0, None, "half"):
        with pytest.raises(nh.InputError, match=r"^share = "):
            life.assess([(solution, share), (solution, share)], "iso-16281", body="b")
    for pairs in ([], [solution], [(solution,)], [(1.0, solution)], [(None, 1.0)], "ab", None, 3):
        with pytest.raises(nh.InputError, match=r"^solution = "):
            life.assess(pairs, "iso-16281", body="b")


def test_an_impossible_raceway_is_refused(table):
    with pytest.raises(nh.InputError, match=r"pitch_diameter = 5\.0 must exceed the roller's diameter of 10 mm"):
        life.Raceway(10.0, 9.6, 5.0, True)
    with pytest.raises(nh.InputError, match="rollers = 21 must be a whole number from 1 to 20"):
        table.RACEWAY.load_rating(21)


# Nothing public is left out
#: Made by the package and not by its users, who only read them.
RESULTS = {
    "Comparison", "ContactMap", "Portion", "study.Progress", "study.Sweep", "study.Tolerance",
    "study.Index", "study.Quantile", "study.Gradient", "study.Partials",
    "EdgeKind", "EdgePressure", "ErrorEstimate", "Result", "SingularEnd", "Solution", "Solutions",
    "Status",
    "hertz.LineContact", "hertz.PointContact",
    "bearing.BearingLife", "bearing.BearingMaps", "bearing.BearingSolution",
    "bearing.BearingSolutions", "bearing.CatalogueGuess", "bearing.Fit", "bearing.OperatingClearance",
    "bearing.Rating", "bearing.RingShape", "bearing.Row",
    "bearing.ForceTable", "bearing.UnrolledPressure",
    "bearing.VolumeLife",
    "life.Exposure", "life.Life", "life.Overrolled",
    "measured.Fit", "measured.Roughness", "measured.StepResult",
    "subsurface.Extreme", "subsurface.Extremes", "subsurface.Field", "subsurface.Passage",
    "AccuracyWarning", "CaseError", "ConvergenceError", "InputError", "Interrupted", "NonhertzError",
    *(f"profile.{name}" for name in (
        "Arcs", "Conical", "Flipped", "Logarithmic", "Profile", "Scaled", "Shifted", "Straight", "Sum", "Tabulated",
        "ProfileKind", "TaperedEnds", "UniformPressure",
    )),
}  # fmt: skip


def public() -> dict[str, Any]:
    found = {}
    for prefix, module in MODULES.items():
        home = "nonhertz" if module is nh else module.__name__
        for name in dir(module):
            value = getattr(module, name)
            ours = callable(value) and getattr(value, "__module__", "").startswith(home)
            if not name.startswith("_") and ours and (inspect.isclass(value) or inspect.isfunction(value)):
                found[prefix + name] = value
    return found


def test_every_public_name_is_in_the_table_with_all_its_arguments(table):
    for name, value in public().items():
        assert name in table.ENTRIES or name in RESULTS
        if name in table.ENTRIES:
            parameters = inspect.signature(value).parameters.values()
            named = {each.name for each in parameters if each.kind is not each.VAR_KEYWORD}
            assert named <= set(table.ENTRIES[name].sorts), name


#: Asked of a solution and not of a user, or in the table under another name.
ELSEWHERE = {"life.Laminae", "measured.Measured", "Comparison.along"}
#: It would write files of nonsensical names; in tests/unit/test_written.py.
WRITES = {
    "BearingCase.write",
    "Case.write",
    "Result.save",
    "Solution.save",
    "Solutions.save",
    "study.Sweep.write",
    "ContactMap.save",
}
#: Asked by the solver, of positions that it has checked, and of bearings that have been solved.
CHECKED = {
    "BearingCase.rated",
    "Chamfer.drop_at",
    "Body.relief_at",
    "Body.curvature_at",
    "Contact.separation_at",
    "Contact.curvature_at",
}


def test_every_method_that_takes_arguments_is_in_the_table(table):
    known = table.ENTRIES.keys() | WRITES | CHECKED
    for name, value in public().items():
        if not inspect.isclass(value) or name in ELSEWHERE or name.startswith(("measured.", "profile.")):
            continue
        for method, function in vars(value).items():
            if inspect.isfunction(function) and not method.startswith("_") and "Error" not in name:
                assert len(inspect.signature(function).parameters) == 1 or f"{name}.{method}" in known
