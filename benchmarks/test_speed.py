"""Speed of what users wait for. Not part of the tests: run `python -m pytest benchmarks`.

`report.py` beside it measures the same things into docs/benchmarks.
"""

from __future__ import annotations

import cases
import numpy as np
import pytest

import nonhertz as nh


@pytest.fixture(autouse=True)
def _one_thread():
    with cases.one_thread():
        yield


@pytest.mark.parametrize("strips", [cases.STRIPS, 161])
def test_equal_strips(benchmark, strips):
    solve = cases.fixed(strips)
    solve()
    solution = benchmark(solve)
    assert solution.strips == strips


@pytest.mark.parametrize("strips", [cases.STRIPS, "auto"])
@pytest.mark.parametrize("name", cases.finite())
def test_finite_bodies(benchmark, name, strips):
    solve = cases.fixed(strips, cases.finite()[name])
    solve()
    solution = benchmark(solve)
    assert solution.status is nh.Status.CONVERGED


@pytest.mark.parametrize("name", cases.automatic())
def test_automatic_grid(benchmark, name):
    solve = cases.automatic()[name]
    solve()
    solution = benchmark(solve)
    assert solution.status is nh.Status.CONVERGED


@pytest.mark.parametrize("element", [nh.SEMI_ELLIPTIC, nh.PARABOLIC], ids=lambda element: element.name)
def test_element_functions(benchmark, element):
    t = np.geomspace(1e-6, 1e6, 10000)
    element.functions(t)
    assert benchmark(element.functions, t)[0].shape == t.shape


def test_element_table(benchmark):
    benchmark(lambda: type(nh.PARABOLIC).table.func(nh.PARABOLIC))


def test_help(benchmark):
    benchmark.pedantic(cases.command("-m", "nonhertz", "--help"), rounds=7, warmup_rounds=1)
