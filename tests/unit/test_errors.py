"""How complaints read, and that they survive the way to another process."""

import pickle

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.errors import CaseError


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
