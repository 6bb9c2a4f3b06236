"""20,000 random cases: every one converges, and every answer is checked without the solver's own loops.

A part of them runs by default: see `extent`.
"""

import os
import re
import warnings
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, field

import numpy as np
import pytest
from extent import extent
from independent_check import faults
from random_cases import random_case

import nonhertz as nh

CASES, SOME = 20_000, 800
CHUNK = 250


@dataclass(frozen=True)
class Outcome:
    """What became of one case."""

    number: int
    kind: str
    failure: str = ""
    steps: int = 0
    warned: frozenset[str] = field(default_factory=frozenset)


def run(number):
    """Solve one case and look at the answer."""
    contact, prescribed, options = random_case(number)
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always", nh.AccuracyWarning)
        try:
            solution = nh.solve(contact, **prescribed, **options)
        except nh.InputError as error:
            return Outcome(number, "refused: " + in_words(error), "" if foreseen(error) else f"refused: {error}")
        except (nh.NonhertzError, ValueError, RuntimeWarning) as error:
            # Arrays that numpy cannot work with are ValueErrors; one such case must not hide the others.
            return Outcome(number, "failed", f"{type(error).__name__}: {error}")
    wrong = faults(solution, prescribed, options["strips"] is None)
    warned = frozenset(without_numbers(str(one.message)) for one in caught)
    return Outcome(number, "wrong" if wrong else "solved", "; ".join(wrong), solution.iterations, warned)


def foreseen(error):
    """Say whether no solution exists: a resultant outside, no strip in contact, lift-off, a body too thin."""
    thin = error.field.endswith(".depth") and "half-width of the contact" in error.condition
    return error.field in {"moment", "strips"} or "the moment causes" in str(error) or thin


def in_words(error):
    return without_numbers(f"{error.field} must {error.condition}")


def without_numbers(sentence):
    return re.sub(r"-?\d[\d.]*(e[+-]?\d+)?", "#", sentence)


def run_chunk(first):
    return [run(number) for number in range(first, first + CHUNK)]


def most_common(kinds):
    return "".join(f"\n{count:7} {kind}" for kind, count in Counter(kinds).most_common())


@pytest.mark.campaign
def test_every_sensible_case_converges_to_a_right_answer():
    with ProcessPoolExecutor(os.cpu_count()) as pool:
        chunks = pool.map(run_chunk, range(0, extent(CASES, SOME), CHUNK))
        outcomes = [outcome for chunk in chunks for outcome in chunk]
    failures = [f"{outcome.number}: {outcome.failure}" for outcome in outcomes if outcome.failure]
    steps = [outcome.steps for outcome in outcomes if outcome.kind == "solved"]
    percentile = float(np.percentile(steps, 95))
    print("\ncases", most_common(outcome.kind for outcome in outcomes))
    print("accuracy warnings", most_common(sentence for outcome in outcomes for sentence in outcome.warned))
    print("failures", "".join(f"\n    {failure}" for failure in failures))
    print(f"Newton steps: 95th percentile {percentile}, max {max(steps)}")
    assert not failures, failures[:20]
    # A refusal is a case that the drawn number of strips cannot carry, or too thin; there must be next to none.
    assert len(steps) >= 0.98 * len(outcomes)
    assert percentile <= 12
