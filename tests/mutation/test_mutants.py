"""The small mistakes that are put into the sources: each is one, and the list does not depend on chance."""

import ast

import pytest
from mutants import mutants, ranked
from run import ROOT, TESTS, everything, explanations

PYTHON = '''
"""Words: 3 < 4."""
LEAST = 1e-3  # \u00e4\u00f6

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
'''
OF_PYTHON = {
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
CPP = """#include "7.hpp"
static_assert(sizeof(int) == 4);
constexpr double LEAST = 1e-3;  // 3 < 4
constexpr std::array<double, 5> ROOM{};

template <class T>
double solved(std::vector<T>& x, bool rough) {
  double total = 0.5;
  for (int i = 0; i < 3; ++i) {
    if (x[i] > LEAST && !rough) throw Error("x + 1");
    total += std::max(-x[i], std::fabs(total)) * 2.0;
  }
  if (rough) return 0.0;
  x[0] = total;
  const double* other = &x[0];
  return total / *other;
}

class Sum {
  void add(double y) { sum_ -= y; }
};
"""
OF_CPP = {
    "-: LEAST = 1e-3; -> LEAST = 0.002;",
    "solved: total = 0.5; -> total = 0.25;",
    "solved: 0; i < 3; -> 0; i <= 3;",
    "solved: i < 3; ++i) -> i < 2; ++i)",
    "solved: if (x[i] > LEAST -> if (x[i] < LEAST",
    "solved: > LEAST && !rough) -> > LEAST || !rough)",
    "solved: LEAST && !rough) throw -> LEAST && rough) throw",
    "solved: total += std::max(-x[i], std::fabs(total)) * 2.0; -> ;",
    "solved: total += std::max(-x[i], std::fabs(total)) -> total += std::min(-x[i], std::fabs(total))",
    "solved: total += std::max(-x[i], std::fabs(total)) -> total += std::max(x[i], std::fabs(total))",
    "solved: += std::max(-x[i], std::fabs(total)) * -> += std::max(-x[i], (total)) *",
    "solved: std::max(-x[i], std::fabs(total)) * 2.0; -> std::max(-x[i], std::fabs(total)) / 2.0;",
    "solved: if (rough) return -> if (!rough) return",
    "solved: x[0] = total; -> ;",
    "Sum: { sum_ -= y; -> { sum_ += y;",
}


@pytest.fixture(params=[("source.py", PYTHON, OF_PYTHON), ("source.cpp", CPP, OF_CPP)], ids=["python", "cpp"])
def source(request):
    return request.param


def found_in(folder, name, text):
    path = folder / name
    path.write_text(text, encoding="utf-8")
    return mutants(path, name)


def test_each_changes_one_thing(source, tmp_path):
    name, text, _ = source
    for mutant in found_in(tmp_path, name, text):
        changed = mutant.applied(text)
        assert changed != text
        assert changed.startswith(text[: mutant.start])
        assert changed.endswith(text[mutant.end :])
        if name.endswith(".py"):
            assert ast.dump(ast.parse(changed)) != ast.dump(ast.parse(text))


def test_mistakes_of_all_kinds_are_among_them(source, tmp_path):
    name, text, expected = source
    keys = {mutant.key.removeprefix(f"{name} ") for mutant in found_in(tmp_path, name, text)}
    assert keys >= expected
    for passed_over in ("+ 1", "Words", "sizeof", "hpp", "ROOM", "double* ->"):
        assert not [key for key in keys if passed_over in key]


def test_keys_tell_them_apart_and_do_not_depend_on_lines(source, tmp_path):
    name, text, _ = source
    found, moved = (found_in(tmp_path, name, each) for each in (text, "\n\n" + text))
    assert [each.key for each in moved] == [each.key for each in found]
    assert len({each.key for each in found}) == len(found)
    assert moved[0].start == found[0].start + 2


def test_the_order_of_one_seed_is_always_the_same(source, tmp_path):
    name, text, _ = source
    found = found_in(tmp_path, name, text)
    order = ranked(found, seed=1)
    assert order == ranked(found[::-1], seed=1)
    assert order != ranked(found, seed=2)
    # What else there is does not change which of two goes first.
    fewer = [each for each in found if each.function]
    assert ranked(fewer, seed=1) == [each for each in order if each.function]


def test_tests_of_rooms_are_there():
    for tests in TESTS.values():
        assert [each for each in tests if not (ROOT / "tests" / each).is_file()] == []


def test_what_is_explained_is_there():
    """A function that has another name, or is gone, takes its explanations along."""
    rooms = [everything(room) for room in TESTS]
    assert all(rooms)
    there = {each.key for mutants in rooms for each in mutants}
    assert explanations().keys() - there == set()
