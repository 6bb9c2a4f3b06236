"""The numbers of examples and templates are those of the golden files; see `golden.py` for what to do where not."""

import math
import re

import pytest

from golden import BEARING_TEMPLATES, EXAMPLES, RUNS, TEMPLATES, compact, kept, machine, ran
from nonhertz.files import starting

SAME, ELSEWHERE = 1e-12, 1e-9
# Parts of command and name, and how far a number may be off on the same machine and elsewhere. The first were measured
# with arrays of whole rollers that were stored by a process with another number of threads, whose last bits differ; the
# second with code for a processor without FMA and AVX and other kernels of the linear algebra.
LOOSER = {
    "sampled_error": (math.inf, math.inf),  # the largest of 300, near first touch, where rounding decides
    "residual": (math.inf, math.inf),  # rounding
    "bearing tilt": (1e-6, 1e-6),  # of rollers that bear next to nothing, as good as the balance of all
    "error": (1e-10, 1e-5),  # differences of solutions
    "indices": (1e-10, 1e-5),  # differences of variances
    "max_pressure_y": (SAME, 1e-6),  # a pressure is flat at its peak
    # As tilts are: of rollers that bear next to nothing, whose approach and pressure follow from the balance of all.
    "bearing approach": (1e-10, ELSEWHERE),
    "bearing max_pressure": (1e-8, 1e-8),
    "orthogonal_shear.x": (1e-9, 1e-6),  # as a stress is flat at its largest
    "fits": (SAME, 1e-6),  # least squares end where they improve no more,
    "design": (ELSEWHERE, ELSEWHERE),  # as searches do
    "gap": (1e-11, ELSEWHERE),  # a difference of displacements
}
# What may cancel to zero is measured by another number of the run: a moment by the load at 1 mm, a gap by the approach.
MEASURED_BY = {"moment": "load", "gap": "approach", "displacement_z": "displacement_y", "shift": "largest"}
MEASURED_BY |= {"load_by_tilt": "load_by_approach", "moment_by_approach": "load_by_approach"}
# Signed sums of what symmetry makes rounding, such as tilts of rollers under a radial load, have no relative accuracy:
# nor need they be nearer than rounding of another number, here the approach at 1 mm.
ROUNDING_OF = {"bearing tilt": "approach"}
QUICK = ("solve", "profile")


@pytest.mark.parametrize(
    ("command", "source"),
    [
        pytest.param(command, source, marks=[] if command in QUICK else pytest.mark.slow)
        for command, sources in RUNS.items()
        for source in sources
    ],
)
def test_numbers_are_those_that_are_kept(command, source):
    golden = kept(command)
    at = 0 if golden["machine"] == machine() else 1
    code, found, warned = ran(command, source)
    found, expected = {"exit code": code} | compact(found), golden[source]
    assert found.keys() == expected.keys()
    # Nothing strains the model in contacts that a user begins with, nor in any bearing here.
    assert not (warned and (command == "bearing" or f"{command} {source}".startswith("solve new")))
    differ = [
        key for key, value in expected.items() if difference(found[key], value) > limit(command, expected, key)[at]
    ]
    assert {key: (found[key], expected[key]) for key in differ} == {}


def limit(command, run, key):
    """How far a number may be off here and elsewhere; those beside it may be what it comes of."""
    shares = next((each for part, each in LOOSER.items() if part in f"{command} {quantity(key)}"), (SAME, ELSEWHERE))
    path, _, last = quantity(key).rpartition(".")
    beside = {quantity(key), f"{path}.{MEASURED_BY.get(last, last)}".lstrip(".")}
    largest = largest_size(run, beside)
    rounding = SAME * largest_size(run, {ROUNDING_OF.get(f"{command} {quantity(key)}")})
    return [max(share * largest if largest else 0.0, rounding) for share in shares]


def largest_size(run, names):
    """Return the largest size of some quantities in a run, 0 where it has none of them."""
    return max((size(value) for key, value in run.items() if quantity(key) in names), default=0.0)


def quantity(key):
    """The name of a number without its place in a list and its unit."""
    return ".".join(part for part in re.sub(r" \[.*\]", "", key).split(".") if not part.isdigit())


def size(value):
    return value[1] if isinstance(value, list) else abs(value)


def difference(one, other):
    if isinstance(other, list):
        return max(map(difference, one[1:], other[1:])) if one[0] == other[0] else math.inf
    return 0.0 if one == other else abs(one - other)


def test_every_template_is_among_them():
    assert set(TEMPLATES) == set(starting.TEMPLATES)
    assert set(BEARING_TEMPLATES) == set(starting.BEARING_TEMPLATES)


def test_every_example_is_among_them():
    sources = {source for sources in RUNS.values() for source in sources}
    assert {path.name for path in EXAMPLES.glob("*.toml")} <= sources
