"""Where bodies fatigue, drawn: lines are the densities, and the key tells the lives."""

from dataclasses import replace

import numpy as np
import pytest
from matplotlib.figure import Figure

import nonhertz as nh
from nonhertz.life import assess
from nonhertz.plot import life_density, life_figure

NAMES = ("lundberg-palmgren", "iso-16281")


@pytest.fixture(scope="module")
def solution():
    profile = nh.profile.iso_logarithmic(diameter=15, length=15)
    roller = nh.Roller(diameter=15, length=15, profile=profile)
    return nh.solve(nh.Contact(roller, nh.Ring(diameter=60)), load=5e3, strips=15)


@pytest.fixture(scope="module")
def lives(solution):
    return assess(solution, NAMES, body="b")


def labels(figure: Figure) -> list[list[str]]:
    return [[text.get_text() for text in axes.get_legend().get_texts()] for axes in figure.axes]


@pytest.mark.slow
def test_lines_are_densities_and_laminae_steps(solution, lives):
    volume, laminae = lives
    axes = life_density([(solution, 1.0)], lives, Figure().add_subplot())
    np.testing.assert_array_equal(axes.lines[1].get_xydata(), np.column_stack([volume.y, volume.density]))
    edges, values = next(line for line in axes.lines if str(line.get_label()).startswith("iso")).get_xydata().T
    np.testing.assert_array_equal(values, np.repeat(laminae.density, 2))
    np.testing.assert_allclose(edges, np.repeat(np.linspace(-7.5, 7.5, 61), 2)[1:-1], rtol=0.0, atol=1e-12)
    low, high = axes.get_ylim()
    assert (axes.get_yscale(), low) == ("linear", 0.0)
    assert high > max(life.density.max() for life in lives)


def test_what_has_no_number_is_told_in_words(solution, lives):
    nothing = np.full(lives[0].y.size, np.nan)
    no_ideal = replace(lives[0], reference=np.nan, density=nothing)
    figure = life_figure([(solution, 1.0)], {"a": [no_ideal], "b": [no_ideal]})
    assert labels(figure) == [["lundberg-palmgren: no ideal life"]]
    assert any("unlimited length" in text.get_text() for text in figure.axes[0].texts)
    untouched = replace(lives[0], damage=0.0, density=0.0 * nothing)
    (told,) = labels(life_figure([(solution, 1.0)], {"a": [untouched], "b": [untouched]}))
    assert told == ["lundberg-palmgren: no damage"]
