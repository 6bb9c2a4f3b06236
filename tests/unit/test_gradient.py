"""Gradients by one adjoint solve, beside contacts that are solved again and beside Hertz."""

import dataclasses
import pickle

import numpy as np
import pytest
from numpy.testing import assert_allclose

import nonhertz as nh
from nonhertz.errors import without_accuracy_warnings
from nonhertz.result.gradient import family_of
from nonhertz.result.measures import HalfWidthAt, PowerIntegral, PressureAt, PressureNorm, measure_of

HOLDING = [("load", "tilt"), ("approach", "tilt"), ("load", "moment"), ("approach", "moment")]
NAMES = ["approach", "load", "tilt", "moment", "max_pressure", "max_half_width"]
MEASURES = [
    PressureAt(2.3),
    HalfWidthAt(-1.1),
    PressureNorm(12.0),
    PowerIntegral(31 / 3, -4 / 3),
    PowerIntegral(4.5, 4.5),
]
SOFT = nh.Material(modulus=110e3, poisson=0.34)
CROWNED = nh.Contact(
    nh.Roller(diameter=15.0, length=20.0, corner_radius=0.5, profile=nh.profile.crown(radius=3000.0)),
    nh.Ring(diameter=80.0, material=SOFT, depth=6.0),
)
PATHS = ["a.diameter", "a.profile.end_radius", "b.diameter", "b.depth", "b.material.modulus", "a.material.modulus"]


def solved(contact, edges, **given):
    with without_accuracy_warnings():
        return nh.solve(contact, strips=edges, **given)


def differenced(solution, quantities, holding, change, at, size=None):
    """The derivatives by contacts solved anew on the same strips, with steps that bring no other into contact."""
    size = abs(at) if size is None else size
    for step in (4e-5 * size, 1e-5 * size):
        total = 0.0
        for steps, weight in ((-2, 1 / 12), (-1, -2 / 3), (1, 2 / 3), (2, -1 / 12)):
            given = {name: getattr(solution, name) for name in holding}
            contact, changed = change(at + steps * step)
            again = solved(contact or solution.contact, solution.edges, **given | changed)
            if not np.array_equal(again.half_width > 0.0, solution.half_width > 0.0):
                break
            total += weight / step * np.array([measure_of(each).partials(again).value for each in quantities])
        else:
            return total
    raise AssertionError("other strips come into contact")


def by_path(contact, path):
    family, at = family_of(contact, path)
    return (lambda value: (family(value), {})), at


@pytest.fixture(scope="module")
def crowned():
    return solved(CROWNED, None, load=14e3, tilt=3e-4)


@pytest.mark.parametrize("holding", HOLDING, ids="-".join)
def test_it_is_what_contacts_solved_anew_differ_by(crowned, holding):
    quantities = [*NAMES, *MEASURES]
    gradients = [crowned.gradient(each, holding=holding) for each in quantities]
    sizes = np.maximum([abs(each.value) for each in gradients], 1e-300)
    for path in [*PATHS[:2], PATHS[-1]] if holding != HOLDING[0] else PATHS:
        change, at = by_path(CROWNED, path)
        expected = differenced(crowned, quantities, holding, change, at)
        found = np.array([each.by(path) for each in gradients])
        assert_allclose(found * at / sizes, expected * at / sizes, rtol=1e-6, atol=1e-8, err_msg=path)
    for name in holding:
        at = getattr(crowned, name)
        expected = differenced(crowned, quantities, holding, lambda value, name=name: (None, {name: value}), at)
        found = np.array([each.given[name] for each in gradients])
        assert_allclose(found * at / sizes, expected * at / sizes, rtol=1e-6, atol=1e-8, err_msg=name)


def test_a_maximum_a_half_width_from_a_sharp_end_moves_with_the_half_widths_beside_it():
    straight = nh.Contact(nh.Roller(diameter=15.0, length=10.0, side_faces="none"), nh.Plate(material=SOFT))
    solution = solved(straight, None, load=14e3, tilt=3e-4)
    assert solution.max_pressure_y not in solution.y
    gradients = [solution.gradient(each) for each in NAMES[-2:]]
    change, at = by_path(straight, "a.diameter")
    sizes = np.array([each.value for each in gradients])
    for found, case, start in (
        ([each.by("a.diameter") for each in gradients], change, at),
        ([each.given["load"] for each in gradients], lambda load: (None, {"load": load}), 14e3),
    ):
        expected = differenced(solution, NAMES[-2:], HOLDING[0], case, start)
        assert_allclose(np.array(found) * start / sizes, expected * start / sizes, rtol=1e-5)


def test_relief_at_every_strip(crowned):
    quantities = ["approach", "max_pressure", PowerIntegral(31 / 3, -4 / 3)]
    reliefs = np.array([crowned.gradient(each).relief for each in quantities])
    rng = np.random.default_rng(5)
    y, bump = crowned.y, 1e-3 * rng.normal(size=crowned.strips)

    def change(value):
        places, bumps = np.concatenate([[-10.0], y, [10.0]]), np.concatenate([[0.0], bump, [0.0]])
        profile = nh.profile.tabulated(places, CROWNED.a.relief(places) + value * bumps)
        bare = dataclasses.replace(CROWNED.a, profile=profile, corner_radius=None)
        return dataclasses.replace(CROWNED, a=bare), {}

    expected = differenced(crowned, quantities, HOLDING[0], change, 0.0, size=0.01)
    assert_allclose(reliefs @ bump, expected, rtol=1e-6)
    assert np.all(reliefs[:, crowned.half_width == 0.0] == 0.0)


def test_stiffness_is_one_of_them(crowned):
    holding = ("approach", "tilt")
    by = [crowned.gradient(name, holding=holding).given for name in ("load", "moment")]
    found = [[each["approach"], each["tilt"]] for each in by]
    assert_allclose(found, crowned.stiffness, rtol=1e-9)


def test_a_line_contact_is_that_of_hertz():
    plain = {"side_faces": "mirror", "images": "series", "depth": 10.0}
    material = nh.Material(modulus=200e3, poisson=0.3)
    roller = nh.Roller(diameter=20.0, length=10.0, material=material, **plain)
    ring = nh.Ring(diameter=60.0, length=10.0, material=material, **plain)
    found = solved(nh.Contact(roller, ring), 5, load=10e3).gradient("max_pressure")
    logarithmic = found.given["load"] * 10e3, sum(found.modulus) * 200e3, found.curvature.sum() * (2 / 20 + 2 / 60)
    assert_allclose(np.array(logarithmic) / found.value, 0.5, rtol=2e-6)


def test_an_ellipse_is_that_of_hertz():
    bodies = nh.Body(diameter=20.0, profile=nh.profile.crown(radius=50.0)), nh.Plate()
    solution = solved(nh.Contact(*bodies), None, load=500.0)
    pressure, width, approach = (solution.gradient(name) for name in ("max_pressure", "max_half_width", "approach"))
    assert_allclose([each.given["load"] * 500.0 / each.value for each in (pressure, width)], 1 / 3, rtol=1e-3)
    assert_allclose(approach.given["load"] * 500.0 / approach.value, 2 / 3, rtol=1e-3)


@pytest.mark.parametrize("y", [-9.99, -9.7, -8.8, 0.0, 5.0, 9.3])
@pytest.mark.parametrize("measure", [PressureAt, HalfWidthAt])
def test_places_have_what_the_solution_says(crowned, y, measure):
    value = measure(y).partials(crowned).value
    if measure is PressureAt:
        assert_allclose(value, float(crowned.pressure(0.0, y)), rtol=1e-12, atol=1e-9)
    else:
        assert_allclose(crowned.pressure([0.99 * value, 1.01 * value], y) > 0.0, [value > 0.0, False])


def test_where_a_contact_runs_out_the_end_moves():
    light = solved(CROWNED, None, load=300.0)
    low, high = light.contact_y[0]
    y = high - 0.2 * (high - light.y[np.flatnonzero(light.half_width)[-1]])
    quantities = (PressureAt(y), HalfWidthAt(y))
    found = [light.gradient(each) for each in quantities]
    expected = differenced(light, quantities, HOLDING[0], lambda value: (None, {"load": value}), 300.0)
    assert min(each.value for each in found) > 0.0
    assert_allclose([each.given["load"] for each in found], expected, rtol=1e-5)
    assert low < 0.0


def test_families_of_contacts(crowned):
    found = crowned.gradient("approach")
    family, at = family_of(CROWNED, "a.diameter")
    assert_allclose(found.along(family, at), found.by("a.diameter"), rtol=1e-12)
    assert_allclose(found.along(family, at, step=0.05), found.by("a.diameter"), rtol=1e-6)


def test_gradients_are_written_in_a_line_and_saved_solutions_have_none_in_them(crowned):
    before = len(pickle.dumps(crowned))
    said = repr(crowned.gradient("max_pressure"))
    assert said.startswith("Gradient(of max_pressure = ")
    assert "at a given load and tilt: d/dload " in said
    assert len(pickle.dumps(crowned)) == before


@pytest.mark.parametrize(
    ("ask", "said"),
    [
        (lambda s: s.gradient("pressure"), "quantity = 'pressure' must be one of 'approach', 'load'"),
        (lambda s: s.gradient(3.0), "quantity = 3.0 must be one of"),
        (lambda s: s.gradient("load", holding=("tilt", "load")), "must have approach or load"),
        (lambda s: s.gradient("load", holding=("load",)), "must name two quantities"),
        (lambda s: s.gradient("load").by("a.profil.end_radius"), "did you mean 'profile'"),
        (lambda s: s.gradient("load").by("a.profile"), "go on to one of radius, end_radius"),
        (lambda s: s.gradient("load").by("a.side_faces"), "name one that is a number"),
        (lambda s: s.gradient("load").by("b.position"), "must be finite and not zero"),
        (lambda s: s.gradient("load").by("a.profile.radius"), "must be finite and not zero"),
        (lambda s: s.gradient("load").by(7), "name = 7 must be text"),
        (lambda s: s.gradient("load").along(3, 1.0), "family = 3 must be a function"),
        (lambda s: s.gradient("load").along(lambda value: value, 1.0), "must return a Contact"),
    ],
)
def test_nonsense_is_refused(crowned, ask, said):
    with pytest.raises(nh.InputError, match=said):
        ask(crowned)


@pytest.mark.slow
@pytest.mark.parametrize("model", [nh.life.zaretsky(), nh.life.iso_16281(edge_stress="none")])
def test_damage_changes_with_the_load_as_the_assessed_one(model):
    """From the stress below the surface, or from laminae, at two loads on the same strips."""
    contact = nh.Contact(
        nh.Roller(diameter=15.0, length=20.0, profile=nh.profile.crown(radius=2000.0)), nh.Ring(diameter=80.0)
    )
    loads = 8e3 * np.array([0.98, 1.0, 1.02])
    light, middle, heavy = (solved(contact, 80, load=load, tilt=2e-4) for load in loads)
    light, heavy = (nh.life.assess(each, model, body="b")[0].damage for each in (light, heavy))
    found = middle.gradient(nh.study.damage(model))
    expected = np.log(heavy / light) / np.log(loads[2] / loads[0])
    assert_allclose(found.given["load"] * 8e3 / found.value, expected, rtol=0.02)


def test_models_with_a_limit_have_no_power():
    with pytest.raises(nh.InputError, match=r"model\.fatigue_limit = 300\.0 must be zero"):
        nh.study.damage(nh.life.ioannides_harris(fatigue_limit=300.0))
    with pytest.raises(nh.InputError, match="model = 'lundberg-palmgren' must be a fatigue model"):
        nh.study.damage("lundberg-palmgren")
