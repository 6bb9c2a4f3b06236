"""Many cases in one call: each as if it had been solved alone, and none lost."""

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.errors import without_accuracy_warnings

CROWNED = nh.Contact(nh.Roller(diameter=20, length=20, profile=nh.profile.crown(4000)), nh.Plate())
LOGARITHMIC = nh.Contact(
    nh.Roller(diameter=20, length=20, profile=nh.profile.logarithmic(amplitude=0.005, length=20, fraction=0.9999)),
    nh.Ring(diameter=-90, length=24),
)
BALL = nh.Contact(nh.Body(diameter=20, profile=nh.profile.crown(60)), nh.Plate())
LOADS = np.linspace(8e3, 12e3, 150)
# Both meet their equations to 1e-11, which the condition of the system makes into ten times that.
SAME = {"rtol": 1e-9, "atol": 0.0}


def alone(contact, **case):
    with without_accuracy_warnings():
        return nh.solve(contact, **case)


def assert_same(many, number, one, **tolerance):
    for name in ("approach", "load", "max_pressure", "max_pressure_y"):
        np.testing.assert_allclose(getattr(many, name)[number], getattr(one, name), err_msg=name, **tolerance)
    scale = abs(one.load) * np.array([1.0, 1.0])
    np.testing.assert_allclose([many.moment[number]], [one.moment], rtol=0.0, atol=tolerance["rtol"] * scale[0])
    of_stiffness = one.stiffness[0, 0] * np.array([[1.0, 10.0], [10.0, 100.0]])
    # The stiffness is that of the last matrix, which may have been 1e-8 off.
    np.testing.assert_allclose(
        many.stiffness[number] / of_stiffness, one.stiffness / of_stiffness, rtol=0.0, atol=max(tolerance["rtol"], 1e-7)
    )


@pytest.mark.filterwarnings("ignore::nonhertz.AccuracyWarning")
@pytest.mark.parametrize(
    ("contact", "element", "strips"),
    [(CROWNED, nh.SEMI_ELLIPTIC, 41), (LOGARITHMIC, nh.PARABOLIC, 12), (LOGARITHMIC, nh.SEMI_ELLIPTIC, 1)],
    ids=["crowned", "logarithmic", "one strip"],
)
@pytest.mark.slow
def test_a_sweep_on_equal_strips_is_that_of_single_solves(contact, element, strips):
    # Tilted, or two strips would bear the same maximum.
    case = {"tilt": 1e-4 if strips > 1 else 0.0, "element": element, "strips": strips}
    many = nh.solve_many(contact, load=LOADS, **case)
    assert np.all(many.converged)
    for number in (0, 1, 77, 149):
        assert_same(many, number, alone(contact, load=LOADS[number], **case), **SAME)


@pytest.mark.parametrize(
    "case",
    [
        {"load": np.array([9e3, 9.1e3]), "moment": np.array([1e3, -4e3])},
        {"approach": np.array([0.012, 0.0125]), "tilt": np.array([1e-4, 1.2e-4])},
        {"approach": np.array([0.012, 0.0125]), "moment": np.array([1e3, 1.1e3])},
    ],
    ids=["load and moment", "approach and tilt", "approach and moment"],
)
def test_every_pair_of_prescribed_quantities_works(case):
    many = nh.solve_many(CROWNED, **case, strips=21)
    for number in range(2):
        one = alone(CROWNED, **{name: values[number] for name, values in case.items()}, strips=21)
        assert_same(many, number, one, **SAME)


def test_automatic_grids_are_the_same_to_the_bit():
    many = nh.solve_many([CROWNED, LOGARITHMIC, BALL], load=[9e3, 12e3, 800.0], tilt=[3e-4, -5e-4, 0.0])
    for number, (contact, load, tilt) in enumerate(
        zip([CROWNED, LOGARITHMIC, BALL], [9e3, 12e3, 800.0], [3e-4, -5e-4, 0.0], strict=True)
    ):
        one = alone(contact, load=load, tilt=tilt)
        assert many.approach[number] == one.approach
        assert many.max_pressure[number] == one.max_pressure
        assert np.array_equal(many[number].edges, one.edges)
        assert np.array_equal(many[number].centre_pressure, one.centre_pressure)
        assert many[number].error_estimate == one.error_estimate
        assert many[number].warnings == one.warnings


TILTS = np.linspace(-4e-4, 4e-4, 60)


@pytest.mark.parametrize(
    ("cases", "steps"),
    [
        ({"load": LOADS, "tilt": 1e-5}, 1.5),
        ({"load": np.repeat(LOADS[::10], 3), "tilt": 1e-5}, 2.5),
        ({"load": np.geomspace(10.0, 12e3, 150), "tilt": 1e-5}, 2.5),  # strips enter as the load rises
        ({"load": np.concatenate([LOADS[::5], LOADS[::-5], LOADS[:3]]), "tilt": 1e-5}, 2.5),  # to and fro
        ({"load": 1e4, "tilt": TILTS}, 2.0),
        ({"load": np.linspace(9e3, 1e4, 60), "tilt": TILTS}, 2.0),  # along a line in both
        ({"approach": np.linspace(0.02, 0.03, 60), "moment": np.linspace(-2e4, 2e4, 60)}, 3.0),
    ],
)
def test_cases_that_follow_one_another_take_few_steps_to_the_same_answers(cases, steps):
    contact = LOGARITHMIC if np.ndim(cases.get("tilt", 0.0)) else CROWNED
    with without_accuracy_warnings():
        many = nh.solve_many(contact, strips=24, **cases)
    rows = dict(zip(cases, np.broadcast_arrays(*cases.values()), strict=True))
    for number in range(0, len(many.load), 7):
        one = alone(contact, strips=24, **{name: values[number] for name, values in rows.items()})
        assert_same(many, number, one, **SAME)
    assert np.mean([many[number].iterations for number in range(len(many.load))]) < steps


@pytest.mark.filterwarnings("ignore::nonhertz.AccuracyWarning")
def test_given_edges_and_unbounded_bodies_work():
    edges = alone(CROWNED, load=9e3).edges
    on_edges = nh.solve_many(CROWNED, load=[9e3, 9.5e3], strips=edges)
    assert_same(on_edges, 1, alone(CROWNED, load=9.5e3, strips=edges), **SAME)
    unbounded = nh.solve_many(BALL, load=[500.0, 900.0], strips=30)
    assert_same(unbounded, 0, alone(BALL, load=500.0, strips=30), **SAME)


def test_a_solution_comes_whole():
    many = nh.solve_many(CROWNED, load=LOADS[:5], strips=41)
    one = alone(CROWNED, load=LOADS[3], strips=41)
    found = many[3]
    assert isinstance(found, nh.Solution)
    np.testing.assert_allclose(found.contact_y, one.contact_y, **SAME)
    # The estimate compares levels that were solved to 1e-6 only.
    assert found.error_estimate.approach == pytest.approx(one.error_estimate.approach, rel=1e-2)
    assert many.max_pressure[3] == found.max_pressure
    assert [solution.load for solution in many] == pytest.approx(LOADS[:5].tolist(), rel=1e-10)
    assert len(many) == 5


@pytest.mark.parametrize(
    "loads", [["5 kN", "8 kN"], np.array(["5 kN", "8 kN"]), ("5 kN", 8e3), np.array([5e3, "8 kN"], dtype=object)]
)
def test_text_with_a_unit_stands_for_numbers(loads):
    found = nh.solve_many(CROWNED, load=loads, tilt="0.2 mrad", element="parabolic", strips=15)
    same = nh.solve_many(CROWNED, load=[5e3, 8e3], tilt=0.2e-3, element=nh.PARABOLIC, strips=15)
    np.testing.assert_array_equal(found.approach, same.approach)
    np.testing.assert_array_equal(nh.solve_many(CROWNED, load="5 kN", strips=15).load.round(6), [5e3])


def test_arrays_spread_into_a_map():
    many = nh.solve_many(CROWNED, load=np.array([[5e3], [9e3], [15e3]]), tilt=[0.0, 2e-4], strips=15)
    assert many.shape == many.approach.shape == (3, 2)
    assert many.stiffness.shape == (3, 2, 2, 2)
    assert many.max_pressure[1, 1] == many[1, 1].max_pressure
    assert_same(many, (2, 1), alone(CROWNED, load=15e3, tilt=2e-4, strips=15), **SAME)
    with pytest.raises(IndexError, match="one number for each of the 2 axes"):
        many[1]


def test_a_case_that_fails_stops_no_other():
    many = nh.solve_many(CROWNED, approach=[0.01, -0.5, 0.012], tilt=0.0, strips=21)
    assert many.converged.tolist() == [True, False, True]
    assert np.isnan(many.load[1])
    assert set(many.failures) == {1}
    assert str(many.failures[1]).startswith("approach = -0.5 must exceed ")
    with pytest.raises(nh.InputError, match=r"approach = -0\.5 must exceed"):
        many[1]


THIN = nh.Contact(nh.Roller(diameter=20, length=20, profile=nh.profile.crown(1000), depth="none"), nh.Plate(depth=1.0))
EDGED = nh.Contact(
    nh.Roller(diameter=20, length=20, chamfer=nh.Chamfer(length=5.0, angle=0.003), side_faces="mirror"), nh.Plate()
)


@pytest.mark.parametrize(
    ("contact", "strips", "loads", "numbers", "words"),
    [
        (CROWNED, 41, [2e3, 3e6], [1], "The half-width"),
        (THIN, 41, [2e3, 10e3], [1], "The depth of body b is only 2.59 half-widths"),
        (EDGED, None, [5e3, 10e3], [0, 1], "The maximum pressure is at a corner of the profile"),
    ],
    ids=["wide", "thin", "edged"],
)
def test_what_strains_the_model_is_told_once(contact, strips, loads, numbers, words):
    said = f"{len(numbers)} of 2 cases strain the model; number {numbers[0]}, the first: {words}"
    with pytest.warns(nh.AccuracyWarning, match=said):
        many = nh.solve_many(contact, load=loads, strips=strips)
    assert many.warnings == {number: many[number].warnings for number in numbers}


def test_contacts_with_singular_ends_are_told_once_and_apart_from_what_strains_the_model():
    straight = nh.Contact(nh.Roller(diameter=20, length=20, side_faces="mirror", depth="none"), nh.Plate())
    with pytest.warns(nh.AccuracyWarning) as caught:
        many = nh.solve_many(straight, load=[[2e3, 20e3], [3e3, 20e6]])
    said = [str(each.message) for each in caught]
    assert len(said) == 2
    assert "1 of 4 cases strain the model; number (1, 1), the first: " in said[0]
    assert said[1].startswith("4 of 4 contacts have an end with singular pressure; number (0, 0), the first: ")
    assert many.singular.tolist() == [[True, True], [True, True]]
    assert set(many.warnings) == {(0, 0), (0, 1), (1, 0), (1, 1)}
    assert not nh.solve_many(CROWNED, load=[2e3, 3e3], strips=21).singular.any()


@pytest.mark.parametrize(
    "profile",
    [
        nh.profile.straight(),
        nh.profile.crown(4000),
        nh.profile.chamfer(20, 1.0),
        nh.profile.tapered_ends(straight=14, angle=0.015),
        nh.profile.tabulated([-10, -2.1, -2, 2, 2.1, 10], [0, 0, 1, 1, 0, 0]),
    ],
    ids=["straight", "crowned", "chamfered", "tapered", "grooved"],
)
@pytest.mark.parametrize("strips", [60, None])
@pytest.mark.filterwarnings("ignore::nonhertz.AccuracyWarning")
def test_the_largest_pressure_away_from_singular_ends_is_that_of_the_solution(profile, strips):
    contact = nh.Contact(nh.Roller(diameter=20, length=20, profile=profile), nh.Ring(diameter=80))
    many = nh.solve_many(contact, load=[500.0, 5e3, 30e3], tilt=2e-4, strips=strips)
    for number, solution in enumerate(many):
        assert many.max_pressure[number] == solution.max_pressure
        assert many.max_pressure_y[number] == solution.max_pressure_y
        assert many.singular[number] == bool(solution.singular_ends)
        assert many.warnings.get(number, ()) == solution.warnings


@pytest.mark.parametrize(
    ("arguments", "complaint"),
    [
        ({"load": [1e3, -2.0]}, r"case 1\.load = -2\.0 must be positive"),
        ({"load": [1e3, np.nan]}, r"case 1\.load = nan must be"),
        ({"load": [1e3, 2e3], "tilt": [0.0, 1e-4, 2e-4]}, r"shapes = .* must broadcast together"),
        ({"load": "much"}, r"load = 'much' must be a number with a unit"),
        ({"load": []}, r"load = \[\] must hold at least one case"),
        ({"load": [1e3, 1e3], "moment": [0.0, 1e6]}, r"case 1\.moment = 1000000\.0 must keep moment / load between"),
        ({"load": [1e3], "approach": [0.1]}, r"approach = \[0.1\] must not be given together with load"),
        ({}, "load must be given"),
        ({"tilt": [0.0]}, "load must be given"),
        ({"load": [1e3], "strips": 0}, "strips = 0 must lie between"),
        ({"load": [1e3], "threads": 0}, "threads = 0 must be a whole number"),
    ],
    ids=lambda value: value if isinstance(value, str) else "",
)
def test_bad_input_is_refused_before_anything_is_solved(arguments, complaint):
    with pytest.raises(nh.InputError, match=complaint):
        nh.solve_many(CROWNED, **arguments)


LIMITED = nh.Contact(
    nh.Roller(diameter=20, length=20, profile=nh.profile.logarithmic(amplitude=0.005, length=6).shifted(6.5)),
    nh.Plate(),
)


@pytest.mark.filterwarnings("ignore::nonhertz.AccuracyWarning")
@pytest.mark.parametrize("strips", [2, 3])
@pytest.mark.parametrize("case", [{"load": 1e4, "moment": 6.5e4}, {"approach": 0.01, "moment": 3e4}], ids=str)
def test_a_coarser_grid_that_nothing_touches_is_left_out(case, strips):
    many = nh.solve_many(LIMITED, **case, strips=strips)
    if many.failures:
        with pytest.raises(nh.InputError) as refused:
            alone(LIMITED, **case, strips=strips)
        assert str(many.failures[0]) == str(refused.value)
    else:
        assert_same(many, 0, alone(LIMITED, **case, strips=strips), **SAME)


class Holed(nh.profile.Profile):
    def relief(self, y):
        return np.where(np.abs(y) < 0.5, np.nan, y**2 / 8000.0)


@pytest.mark.parametrize("strips", [41, None], ids=["equal", "automatic"])
def test_a_relief_that_is_no_number_is_a_failure(strips):
    holed = nh.Contact(nh.Roller(diameter=20, length=20, profile=Holed()), nh.Plate())
    many = nh.solve_many([CROWNED, holed], load=5e3, strips=strips)
    assert many.converged.tolist() == [True, False]
    assert "profile = nan must not be NaN, but is at y =" in str(many.failures[1])


def test_a_grid_that_resists_is_solved_in_any_order():
    # Strips of very unlike widths on a body 3.7 half-widths deep: used to be called too thin from the sixth load on.
    edges = [
        -12.824067, -12.758449, -12.758297, -12.585469, -11.464628, -10.938946, -10.762218, -10.663915, -10.333312,
        -9.1217152, -8.9410325, -4.1050122, -2.2681584, -2.1487035, 0.084051, 0.4795583,
    ]  # fmt: skip
    hard, soft = nh.Material(modulus=127279.0, poisson=0.03046), nh.Material(modulus=13904.0, poisson=0.47251)
    contact = nh.Contact(
        nh.Body(
            material=hard,
            diameter=89.725365,
            length=27.100189,
            position=-5.4170708,
            side_faces="calibrated",
            depth=3.612311,
        ),
        nh.Plate(material=soft, length=14.124188, position=-6.1372098, side_faces=(1.1601055, "calibrated")),
    )
    sizes = np.exp(np.linspace(-0.06, 0.06, 8))
    case = {"load": 2480.492166 * sizes, "tilt": 7.8563406e-4 * (1.0 + np.linspace(-0.06, 0.06, 8))}
    with without_accuracy_warnings():
        up = nh.solve_many(contact, **case, strips=edges)
        down = nh.solve_many(contact, **{name: values[::-1] for name, values in case.items()}, strips=edges)
    assert np.all(up.converged)
    np.testing.assert_allclose(down.approach[::-1], up.approach, **SAME)


def test_line_loads_of_a_case_are_those_of_its_solution():
    many = nh.solve_many(CROWNED, load=[5e3, 8e3], tilt=1e-4)
    edges, line_load = many.line_load(1)
    np.testing.assert_array_equal(edges, many[1].edges)
    np.testing.assert_array_equal(line_load, many[1].line_load)
    with pytest.raises(IndexError, match="out of range"):
        many.line_load(2)
