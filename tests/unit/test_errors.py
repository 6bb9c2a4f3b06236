"""How complaints read, and that they survive the way to another process."""

import pickle

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.errors import CaseError, UnknownKeyError, nearest
from nonhertz.files.geometries import bearing_of_designation
from nonhertz.model.materials import MATERIALS


def test_an_input_error_is_one_sentence_of_four_parts():
    error = nh.InputError("length", -5.0, "be positive", "give the distance between the side faces in mm")
    assert str(error) == "length = -5.0 must be positive: give the distance between the side faces in mm."
    assert (error.field, error.value, error.condition) == ("length", -5.0, "be positive")
    assert error.remedy == "give the distance between the side faces in mm"


@pytest.mark.parametrize(
    ("value", "said"),
    [
        (20.000000000000004, "x = 20.0"),
        ((0.1 + 0.2, np.float64(5.0)), "x = (0.3, 5.0)"),
        ([1e-320, 1.23456789012e-7], "x = [1e-320, 1.23456789012e-07]"),
        ({"kind": "crown"}, "x"),
        (None, "x = None"),
    ],
)
def test_values_are_shown_as_people_write_them(value, said):
    assert str(nh.InputError("x", value, "be right", "mend it")) == f"{said} must be right: mend it."


@pytest.mark.parametrize(
    ("word", "meant"),
    [
        ("Stel", "steel"), ("steal", "steel"), ("100cr6", "100Cr6"), ("aluminum", "aluminium"),
        ("castiron", "cast-iron"), ("silicon", "silicon-nitride"), ("GJS-400", "EN-GJS-400-15"), ("16MnCr", "16MnCr5"),
        ("unobtainium", ""), ("titanium", ""), ("brass", ""), ("copper", ""), ("ceramic", ""), ("S355", ""), ("", ""),
    ],
)  # fmt: skip
def test_only_close_words_are_suggested(word, meant):
    assert nearest(word, MATERIALS) == meant


def test_an_unknown_key_is_named_with_the_one_that_was_meant():
    error = UnknownKeyError("lenght", 3.0, "length", "choose another")
    assert str(error.within("a").within("body")) == "Unknown key body.a.lenght. Did you mean body.a.length?"
    assert str(UnknownKeyError("", 3.0, "", "choose from 'a'")) == "Unknown key '': choose from 'a'."


def test_long_values_are_cut():
    text = str(nh.InputError("y", list(range(1000)), "ascend", "sort the points"))
    assert text.startswith("y = [0, 1, 2,")
    assert text.endswith("... must ascend: sort the points.")
    assert len(text) < 110


@pytest.mark.parametrize(
    "error",
    [
        nh.InputError("length", -5.0, "be positive", "give it in mm"),
        CaseError(["First.", "Second."]),
        UnknownKeyError("lenght", 3.0, "length", "choose another").within("body.a"),
        nh.ConvergenceError("The loop ended.", solution=("so", "far")),
        nh.Interrupted("Stopped after 1 of 2 cases.", solutions=("so", "far")),
    ],
    ids=lambda error: type(error).__name__,
)
def test_errors_travel_between_processes(error):
    # A sweep in worker processes hands its failures back by pickle.
    back = pickle.loads(pickle.dumps(error))
    assert type(back) is type(error)
    assert str(back) == str(error)
    assert vars(back) == vars(error)


CASE = nh.new_case()


def written(path, text):
    path.write_text(text, encoding="utf-8")
    return path


@pytest.mark.parametrize(
    "call",
    [
        lambda folder: nh.sweep(folder / "file", over={"load.load": [1e3]}),
        lambda folder: nh.solve(CASE.contact, load=1e3, strips=41).save(folder / "file"),
        lambda folder: nh.sweep(CASE, over={"load.load": [1e3]}, out=folder / "file"),
        lambda folder: nh.sweep(CASE, over={"load.load": [1e3]}, scheduler="nowhere"),
        lambda folder: nh.optimize(CASE, bounds={}),
        lambda folder: nh.files.write_rexs(folder / "a.xml", nh.new_bearing()),
        lambda folder: nh.read_case(folder / "missing.toml", {"load.load": "5 furlongs"}),
        lambda folder: nh.read_plan(folder / "missing.toml"),
        lambda folder: nh.new_case(changes={"body.a.material": "unobtainium"}),
        lambda folder: nh.read_bearing(written(folder / "case.toml", nh.new_case().text)),
        lambda folder: nh.read_plan(written(folder / "case.toml", nh.new_case().text)),
        lambda folder: nh.read_result(folder / "file"),
        lambda folder: nh.ContactMap.read(folder / "file"),
        lambda folder: bearing_of_designation("NU 2232"),
    ],
)
def test_errors_of_functions_name_no_options_and_no_commands(call, tmp_path):
    written(tmp_path / "file", "no folder")
    with pytest.raises(nh.NonhertzError) as refused:
        call(tmp_path)
    assert "--" not in str(refused.value)
    assert "'nonhertz" not in str(refused.value)
