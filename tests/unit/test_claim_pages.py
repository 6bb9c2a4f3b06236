"""Claims, their verdicts, and the tables that are made of them."""

import json
import math
import pkgutil
import re
from fnmatch import filter as matching
from pathlib import Path

import pytest

import claims
import nonhertz as nh
from claims.claim import Claim, Evidence, Section, forget, named, solved
from claims.page import as_json, row


def check(computed=2.001, tolerance=1e-3, *, quantity="a number", expected=2.0, **more):
    return Claim(quantity, "a law", expected, lambda: computed, tolerance, **more).check()


FOUND = (
    Section("one", "The first", (check(), check(3.0, None))),
    Section(
        "two", "The second", (check(3.0), check(1e-7, quantity="|p| of a_1 ~ b", expected=lambda: 1e-7, unit="mm"))
    ),
)


@pytest.mark.parametrize(
    ("computed", "tolerance", "absolute", "verdict"),
    [
        (2.0, 1e-3, False, "pass"),
        (2.0019, 1e-3, False, "pass"),
        (1.9981, 1e-3, False, "pass"),
        (2.0021, 1e-3, False, "FAIL"),
        (1.9979, 1e-3, False, "FAIL"),
        (2.0009, 1e-3, True, "pass"),
        (2.0019, 1e-3, True, "FAIL"),
        (1.9981, 1e-3, True, "FAIL"),
        (7.0, None, False, "shown"),
        (math.nan, 1e-3, False, "FAIL"),
        (math.nan, 1e-3, True, "FAIL"),
        (math.inf, math.inf, False, "FAIL"),
        (math.nan, None, False, "shown"),
    ],
)
def test_verdicts(computed, tolerance, absolute, verdict):
    assert check(computed, tolerance, absolute=absolute).verdict == verdict


def test_a_difference_is_relative_to_the_size_of_the_expected_value():
    assert check(-3.0, expected=-2.0).difference == -0.5
    assert check(-3.0, expected=-2.0, absolute=True).difference == -1.0


def test_a_claim_whose_number_is_not_found_fails_with_the_reason():
    def stopped():
        raise nh.InputError("load", 0.0, "be positive", "raise it")

    found = Claim("a number", "a law", 2.0, stopped, None).check()
    assert found.verdict == "FAIL"
    assert row(found)[0] == "a number (not found: load = 0.0 must be positive: raise it.)"
    assert json.loads(as_json([Section("one", "", (found,))]))[0]["computed"] is None


def test_numbers_found_together_are_claims_of_their_own():
    both = Evidence("pair", "law", lambda: (1.0, 3.0), lambda: (1.0, 2.0))
    first, second = both.each(["a", "b"], (1e-3, None), "mm")
    assert (first.check().verdict, second.check().verdict) == ("pass", "shown")
    checked = second.check()
    assert (second.quantity, second.unit, checked.expected, checked.computed) == ("pair: b", "mm", 2.0, 3.0)


def test_ids_are_section_and_quantity_and_never_the_same_twice():
    claims = [check(quantity=quantity).claim for quantity in ("K at the end, 9.5 mm", "K at the end, 9.5 mm", "p")]
    assert [each.id for each in named("one", claims)] == [
        "one/k-at-the-end-9.5-mm",
        "one/k-at-the-end-9.5-mm-2",
        "one/p",
    ]


def test_a_solved_case_is_solved_once_until_it_is_forgotten():
    calls = []
    case = solved(lambda load: calls.append(load) or load)
    assert [case(1.0), case(1.0), case(2.0)] == [1.0, 1.0, 2.0]
    forget()
    case(1.0)
    assert calls == [1.0, 2.0, 1.0]


def test_json_has_all_checks_and_no_infinity():
    entries = json.loads(as_json([*FOUND, Section("three", "The third", (check(math.nan),))]))
    assert [entry["section"] for entry in entries] == ["one", "one", "two", "two", "three"]
    assert [entry["verdict"] for entry in entries] == ["pass", "shown", "FAIL", "pass", "FAIL"]
    assert [entry["tolerance"] for entry in entries] == [1e-3, None, 1e-3, 1e-3, 1e-3]
    assert entries[-1]["computed"] is None
    assert entries[3]["unit"] == "mm"
    assert json.loads(as_json([])) == []


def test_sections_come_in_reading_order_and_unknown_ones_are_refused():
    assert claims.chosen() == tuple(claims.CATALOGUE)
    assert claims.chosen(["quarter-space", "half-space", "quarter-space"]) == ("half-space", "quarter-space")
    with pytest.raises(nh.InputError, match="choose from 'hertz-ellipse', 'line-limits', "):
        claims.chosen(["half-space", "nonsense"])


def test_claims_are_data_until_their_numbers_are_asked_for(monkeypatch):
    for place, _ in claims.CATALOGUE.values():
        # Imported before, so that no module keeps what is put in place of the solver's function.
        pkgutil.resolve_name(f"claims.{place}")
    monkeypatch.setattr(nh.solver.one, "problem_of", lambda *_: pytest.fail("something was solved"))
    every = [claim for name in claims.CATALOGUE for claim in claims.claims(name)]
    assert len(every) == len({claim.id for claim in every}) == 652


def test_what_the_pages_name_are_claims():
    ids = [claim.id for name in claims.CATALOGUE for claim in claims.claims(name)]
    pages = (Path(__file__).parents[2] / "docs" / "validation").glob("*.md")
    text = "".join(page.read_text("utf-8") for page in pages)
    patterns = [part for names in re.findall(r"<!-- (?:off|found|table) (\S+) -->", text) for part in names.split(",")]
    assert len(patterns) > 50
    assert [pattern for pattern in patterns if not matching(ids, pattern)] == []
