"""The sections of the validation page on half-spaces, finite bodies and ends, and that they can fail."""

import importlib

import pytest
from matplotlib.figure import Figure

import nonhertz as nh
from nonhertz.strip import finite

MODULES = ("half_space", "plane_strain", "finite_bodies", "edge_exponents", "quarter_space")
over_modules = pytest.mark.parametrize("module", MODULES)


def section(module):
    return importlib.import_module(f"nonhertz.verify.{module}").section()


@pytest.fixture(scope="module")
def sections():
    return {module: section(module) for module in MODULES}


@over_modules
def test_no_check_fails(sections, module):
    assert [check.claim for check in sections[module].checks if check.passed is False] == []
    assert any(check.passed for check in sections[module].checks)


@over_modules
def test_pictures_can_be_drawn(sections, module):
    for picture in sections[module].pictures:
        figure = Figure(figsize=(6.7, picture.height), layout="constrained")
        picture.draw(figure)
        figure.draw_without_rendering()


@pytest.mark.parametrize("module", ["half_space", "plane_strain", "finite_bodies"])
def test_five_per_cent_too_much_compliance_is_noticed(monkeypatch, module):
    # The references take the materials' own compliance, the solver that of the contact.
    right = nh.Contact.compliance.fget
    monkeypatch.setattr(nh.Contact, "compliance", property(lambda contact: 1.05 * right(contact)))
    assert section(module).failed > 0


@pytest.mark.parametrize("module", ["finite_bodies", "edge_exponents", "quarter_space"])
def test_images_that_weigh_a_tenth_too_little_are_noticed(monkeypatch, module):
    right = finite._images
    monkeypatch.setattr(finite, "_images", lambda *args: {place: 0.9 * w for place, w in right(*args).items()})
    assert section(module).failed > 0


def test_a_depth_a_tenth_too_small_is_noticed(monkeypatch):
    right = finite.plane_strain_depth
    monkeypatch.setattr(finite, "plane_strain_depth", lambda *args: 0.9 * right(*args))
    assert section("plane_strain").failed > 0
    assert section("finite_bodies").failed > 0
