"""The small mistakes that are put into the sources: each is one, and the list does not depend on chance."""

import ast

import pytest
from mutants import chosen, mutants
from run import ROOMS, everything, explanations, users

SOURCE = '''
"""Words: 3 < 4."""
LEAST = 1e-3  # \u00e4\u00f6

@compiled
def solved(x, y=0.5):
    """Words: 3 < 4."""
    total = 0.0
    for i in range(3):
        if x < y and not -x > LEAST:
            raise ValueError(f"{x + 1}")
        total += max(x * y, 2.0**i)
    x[0] = total
    return total

def read(text: "1"):
    return text if text else abs(3)

def doubled(sign):
    def value(x):
        return sign * solved(x) + 7
    return compiled(value)

double = doubled(2)
'''
EXPECTED = {
    "-: 1e-3 -> 0.002",
    "solved: 0.5 -> 1.0",
    "solved: x < y -> (x <= y)",
    "solved: x < y -> (x > y)",
    "solved: x < y and not -x > LEAST -> (x < y or not -x > LEAST)",
    "solved: not -x > LEAST -> (-x > LEAST)",
    "solved: -x -> (x)",
    "solved: max(x * y, 2.0**i) -> (min(x * y, 2.0 ** i))",
    "solved: 2.0**i -> (2.0 * i)",
    "solved: total += max(x * y, 2.0**i) -> pass",
    "solved: x[0] = total -> pass",
    "read: text if text else abs(3) -> (text if not text else abs(3))",
    "read: abs(3) -> (3)",
}


@pytest.fixture
def found(tmp_path):
    path = tmp_path / "source.py"
    path.write_text(SOURCE, encoding="utf-8")
    return mutants(path, "source.py")


def test_each_changes_one_thing_and_is_python(found):
    for mutant in found:
        changed = mutant.applied(SOURCE)
        assert ast.dump(ast.parse(changed)) != ast.dump(ast.parse(SOURCE))
        assert changed.startswith(SOURCE[: mutant.start])
        assert changed.endswith(SOURCE[mutant.end :])
        assert changed.count("\n") == SOURCE.count("\n")


def test_mistakes_of_all_kinds_are_among_them(found):
    keys = {mutant.key.removeprefix("source.py ") for mutant in found}
    assert keys >= EXPECTED
    assert not [key for key in keys if "x + 1" in key or "Words" in key]


def test_keys_tell_them_apart_and_do_not_depend_on_lines(found, tmp_path):
    path = tmp_path / "moved.py"
    path.write_text("\n\n" + SOURCE, encoding="utf-8")
    moved = mutants(path, "source.py")
    assert [each.key for each in moved] == [each.key for each in found]
    assert len({each.key for each in found}) == len(found)
    assert moved[0].line == found[0].line + 2


def test_it_is_known_what_is_compiled(found):
    assert {each.function for each in found if each.compiled} == {"", "solved", "doubled.value"}
    assert {each.function for each in found if not each.compiled} == {"read"}


def test_it_is_known_what_runs_when_the_lines_are_not_seen(found):
    named = {(each.function, each.before): each.names for each in found}
    assert named["", "1e-3"] == ("LEAST",)
    assert named["solved", "x < y"] == ("solved",)
    assert named["read", "abs(3)"] == ()
    assert named["doubled.value", "7"] == ("doubled",)
    used = set(users(ast.parse(SOURCE)))
    assert {("LEAST", 10, "solved"), ("text", 17, ""), ("solved", 21, "doubled"), ("doubled", 24, "double")} <= used


def test_the_choice_of_one_seed_is_always_the_same(found):
    some = chosen(found, 5, seed=1)
    assert some == chosen(found[::-1], 5, seed=1)
    assert some != chosen(found, 5, seed=2)
    # What else there is does not change which of two goes first.
    fewer = [each for each in found if each in some or each.function == "read"]
    assert set(some) <= set(chosen(fewer, len(fewer), seed=1))
    assert chosen(some, 3, seed=1) == [each for each in some if each in chosen(found, 3, seed=1)]


@pytest.mark.slow
def test_what_is_explained_is_there():
    """A function that has another name, or is gone, takes its explanations along."""

    there = {each.key for room in ROOMS for each in everything(room)}
    assert explanations().keys() - there == set()
