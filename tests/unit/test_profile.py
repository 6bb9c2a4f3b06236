"""Profiles: what each kind does at its landmarks, how they combine, and what they refuse."""

import inspect
import math
import pickle
import typing

import numpy as np
import pytest

from nonhertz import SEMI_ELLIPTIC
from nonhertz.errors import InputError
from nonhertz.inputs.descriptions import Quantities, Quantity
from nonhertz.model import profile as catalogue
from nonhertz.model.body import Body
from nonhertz.model.profile import (
    CATALOGUE,
    PARAMETERS,
    Profile,
    Sum,
    chamfer,
    conical,
    crown,
    from_file,
    fujiwara_kawase,
    iso_logarithmic,
    iso_tapered,
    iso_thrust,
    johns_gohar,
    logarithmic,
    lundberg,
    partial_crown,
    straight,
    tabulated,
    tapered_ends,
    two_radius,
    uniform_pressure,
)

DESIGN = {"load": 20e3, "length": 20.0, "radius": 10.0}
ONE_OF_EACH = {
    "straight": straight(),
    "crown": crown(2000.0),
    "hollow": crown(-2000.0),
    "off-centre crown": crown(2000.0, centre=1.5),
    "partial-crown": partial_crown(500.0, 8.0),
    "cut partial-crown": partial_crown(500.0, 8.0, blended=False),
    "two-radius": two_radius(5000.0, 500.0, 10.0),
    "logarithmic": logarithmic(0.004, 20.0, 0.999),
    "lundberg": lundberg(**DESIGN),
    "johns-gohar": johns_gohar(**DESIGN),
    "fujiwara-kawase": fujiwara_kawase(20e3, 20.0, k1=1.5, k2=0.6, zm=0.03),
    "iso-logarithmic": iso_logarithmic(10.0, 20.0),
    "long iso-logarithmic": iso_logarithmic(5.0, 20.0),
    "iso-tapered": iso_tapered(10.0, 20.0),
    "iso-thrust": iso_thrust(10.0, 20.0),
    "conical": conical(1e-3),
    "tapered-ends": tapered_ends(10.0, 1e-3),
    "chamfer": chamfer(20.0, 0.5),
    "pchip": tabulated([-10.0, 0.0, 10.0], [0.02, 0.0, 0.01]),
    "linear": tabulated([-10.0, 0.0, 10.0], [0.02, 0.0, 0.01], "linear"),
    "cubic": tabulated([-10.0, -2.0, 3.0, 10.0], [0.02, 0.0, 0.0, 0.01], "cubic"),
}


def at(profile: Profile, y: float) -> float:
    return float(profile.relief(y))


def slope(profile: Profile, y: float, step: float = 1e-4) -> float:
    return (at(profile, y + step) - at(profile, y - step)) / (2.0 * step)


class TestEveryKind:
    @pytest.mark.parametrize("profile", ONE_OF_EACH.values(), ids=ONE_OF_EACH)
    def test_is_a_number_or_infinity_at_any_places_of_any_shape(self, profile):
        for shape in ((), (0,), (5,), (2, 3)):
            relief = profile.relief(np.zeros(shape))
            assert isinstance(relief, np.ndarray)
            assert relief.shape == shape
            assert relief.dtype == np.float64
        assert np.array_equal(profile.relief([-3, 0, 3]), profile.relief(np.array([-3.0, 0.0, 3.0])))
        relief = profile.relief(
            np.concatenate([np.linspace(-12.0, 12.0, 481), [-1e4, -10.0, 10.0, 1e4], profile.bends])
        )
        assert not np.any(np.isnan(relief))
        assert not np.any(np.isneginf(relief))

    @pytest.mark.parametrize("profile", ONE_OF_EACH.values(), ids=ONE_OF_EACH)
    def test_is_a_value(self, profile):
        before = pickle.loads(pickle.dumps(profile))
        profile.relief(1.0)  # fills the interpolator's cache, which must not count
        after = pickle.loads(pickle.dumps(profile))
        assert before == profile == after
        assert hash(before) == hash(profile) == hash(after)
        assert np.array_equal(after.relief([0.5, 9.9]), profile.relief([0.5, 9.9]))
        with pytest.raises(AttributeError):
            profile.amplitude = 1.0

    @pytest.mark.parametrize("profile", ONE_OF_EACH.values(), ids=ONE_OF_EACH)
    def test_slope_is_steady_away_from_its_bends(self, profile):
        y = np.linspace(-9.0, 9.0, 3601)
        y = y[np.all(np.abs(y[:, None] - np.array([*profile.bends, 99.0])) > 0.02, axis=1)]
        if isinstance(profile, catalogue.Tabulated) and profile.interpolation == "pchip":
            y = y[np.abs(y) > 0.02]  # its curvature jumps at every point, too little to refine for
        step = 1e-3
        curvature = profile.relief(y + step) - 2.0 * profile.relief(y) + profile.relief(y - step)
        assert np.max(np.abs(curvature)) < 0.01 * step  # a kink of 1e-3 rad would show as 1e-3 * step or more


class TestStraight:
    def test_adds_nothing(self):
        assert straight() + crown(1000.0) == crown(1000.0)
        assert crown(1000.0) + straight() == crown(1000.0)
        assert at(straight() + straight(), 4.0) == 0.0


class TestCircularArcs:
    def test_crown_keeps_its_digits_on_a_huge_radius(self):
        # R - sqrt(R^2 - y^2) as written gives 5.005e-08 here; the series y^2/2R (1 + y^2/4R^2) is exact.
        assert at(crown(1e6), 0.31622776601683794) == pytest.approx(5e-8, rel=1e-12)

    @pytest.mark.parametrize("radius", [12.0, -12.0])
    def test_crown_ends_where_its_circle_does(self, radius):
        assert at(crown(radius), 12.0) == radius
        assert at(crown(radius), 12.0 + 1e-9) == math.inf

    @pytest.mark.parametrize("blended", [True, False])
    def test_partial_crown_without_a_straight_part_is_a_crown(self, blended):
        y = np.linspace(-10.0, 10.0, 41)
        np.testing.assert_array_equal(partial_crown(700.0, 0.0, blended).relief(y), crown(700.0).relief(y), strict=True)
        assert partial_crown(700.0, 0.0, blended).bends == ()

    def test_two_radii_meet_without_a_kink(self):
        profile = two_radius(5000.0, 500.0, 10.0)
        before, after = profile.relief(5.0 - 1e-3), profile.relief(5.0 + 1e-3)
        assert (at(profile, 5.0) - before) / 1e-3 == pytest.approx(1e-3, rel=1e-3)
        assert (after - at(profile, 5.0)) / 1e-3 == pytest.approx(1e-3, rel=2e-3)


class TestStraightLines:
    def test_conical_keeps_the_middle(self):
        assert at(conical(2e-3), 0.0) == 0.0
        assert at(conical(2e-3), 5.0) == -at(conical(2e-3), -5.0) > 0.0

    def test_tapered_ends(self):
        profile = tapered_ends(10.0, 0.25 * math.pi)
        np.testing.assert_allclose(profile.relief([-7.0, 0.0, 5.0, 6.0]), [2.0, 0.0, 0.0, 1.0], atol=1e-15)
        assert profile.bends == (-5.0, 5.0)

    def test_tapered_ends_without_a_middle_are_a_roof(self):
        assert tapered_ends(0.0, 1e-3).bends == (0.0,)
        assert tapered_ends(5.0, 0.0).bends == ()

    def test_chamfer_starts_its_width_before_the_end(self):
        profile = chamfer(length=20.0, width=0.5)
        assert profile.bends == (-9.5, 9.5)
        np.testing.assert_allclose(profile.relief([9.5, 9.75, -10.0]), [0.0, 0.25, 0.5], atol=1e-15)


class TestLogarithmic:
    @pytest.mark.parametrize(
        "make",
        [
            lambda length, diameter, straight: (length, iso_logarithmic(length, length)),
            lambda length, diameter, straight: (length, iso_logarithmic(diameter, length)),
            lambda length, diameter, straight: (length, iso_tapered(diameter, length)),
            lambda length, diameter, straight: (length, logarithmic(1e-3, length)),
            lambda length, diameter, straight: (length + straight, logarithmic(1e-3, length, straight=straight)),
        ],
        ids=["short", "any", "tapered", "logarithmic", "with a straight middle"],
    )
    def test_ends_are_infinite_for_any_length(self, make):
        random = np.random.default_rng(14)
        for digits in random.integers(1, 9, 2_000):
            length, diameter = (float(f"{10.0 ** random.uniform(-3, 4):.{digits}g}") for _ in range(2))
            whole, profile = make(length, diameter, random.uniform(0.0, 3.0 * length))
            end = 0.5 * whole
            finite = np.isfinite(profile.relief([-end, np.nextafter(-end, 0.0), np.nextafter(end, 0.0), end]))
            assert finite.tolist() == [False, True, True, False], profile

    def test_fujiwara_kawase_has_its_drop_for_any_length(self):
        random = np.random.default_rng(14)
        for length in 10.0 ** random.uniform(-3, 4, 2_000):
            load, k2 = length * 10.0 ** random.uniform(-6, 3), random.uniform(0.001, 1.0)
            relief = fujiwara_kawase(load, length, k2=k2, zm=0.03).relief([-0.5 * length, 0.5 * length])
            np.testing.assert_array_almost_equal_nulp(relief, np.full(2, 0.03), 1_000_000)

    def test_the_digits_of_the_middle_are_kept(self):
        # ln(1 / (1 - s^2)) is s^2 to rounding, where 1 - s^2 has none of its digits left.
        assert at(logarithmic(0.005, 20.0), 1e-9) == pytest.approx(0.005 * 1e-20, rel=1e-12)

    def test_middle_is_zero_and_not_minus_zero(self):
        assert math.copysign(1.0, at(iso_logarithmic(4.0, 40.0), 0.0)) == 1.0

    def test_iso_branches_divide_at_two_and_a_half_diameters(self):
        assert iso_logarithmic(8.0, 20.0).bends == ()
        assert iso_logarithmic(8.0, 20.001).bends != ()

    def test_fujiwara_kawase_needs_no_radius_for_a_given_drop(self):
        assert fujiwara_kawase(20e3, 20.0, zm=0.03) == fujiwara_kawase(20e3, 20.0, radius=5.0, zm=0.03)

    def test_steel_on_steel_is_the_default(self):
        steel = 2.0 * (1.0 - 0.3**2) / (math.pi * 207000.0)
        for make in (lundberg, johns_gohar, fujiwara_kawase):
            explicit = make(**DESIGN, compliance=steel).relief([3.0, 10.0])
            np.testing.assert_allclose(make(**DESIGN).relief([3.0, 10.0]), explicit, rtol=1e-14)


class TestLundberg:
    def test_end_is_finite_and_goes_on(self):
        profile = lundberg(**DESIGN)
        relief = profile.relief([9.99, 10.0, 10.01, 12.0, 1000.0])
        assert np.all(np.isfinite(relief))
        assert np.all(np.diff(relief) > 0.0)

    def test_is_smooth_where_its_table_hands_over_to_the_series(self):
        # b = 0.1: the arguments (10 +- y) / b pass 64 at y = 3.6 and 1e-5 at 1e-6 before the end.
        profile = lundberg(load=447.0, length=20.0, radius=40.0)
        for y in (3.6, 10.0 - 1e-6 * profile.half_width * 10.0):
            around = profile.relief(y + np.linspace(-1e-7, 1e-7, 41))
            steps = np.diff(around)
            assert np.max(steps) < 1.5 * np.median(steps) + 1e-16
            assert np.min(steps) > 0.5 * np.median(steps) - 1e-16


class TestTabulated:
    def test_passes_through_its_points(self):
        y, relief = [-5.0, -1.0, 2.0, 6.0], [0.03, 0.0, 0.001, 0.02]
        for interpolation in ("pchip", "linear", "cubic"):
            np.testing.assert_allclose(tabulated(y, relief, interpolation).relief(y), relief, atol=1e-17)

    def test_sorts_its_points(self):
        assert tabulated([2.0, -2.0, 0.0], [1.0, 3.0, 2.0]) == tabulated([-2.0, 0.0, 2.0], [3.0, 2.0, 1.0])

    def test_pchip_does_not_overshoot(self):
        y = np.linspace(-5.0, 5.0, 501)
        relief = tabulated([-5.0, -1.0, 1.0, 5.0], [1.0, 0.0, 0.0, 1.0]).relief(y)
        assert np.min(relief) == 0.0
        assert np.min(tabulated([-5.0, -1.0, 1.0, 5.0], [1.0, 0.0, 0.0, 1.0], "cubic").relief(y)) < 0.0

    def test_is_no_body_outside(self):
        profile = tabulated([-1.0, 1.0], [0.0, 0.0])
        assert profile.extent == (-1.0, 1.0)
        np.testing.assert_array_equal(profile.relief([-1.001, -1.0, 1.0, 1.001]), [np.inf, 0.0, 0.0, np.inf])

    def test_bends_are_the_kinks_of_a_polyline(self):
        y, relief = [-10.0, -5.0, 0.0, 5.0, 10.0], [0.01, 0.0, 0.0, 0.0, 0.01]
        assert tabulated(y, relief, "linear").bends == (-5.0, 5.0)
        assert tabulated(y, relief, "pchip").bends == ()

    def test_crests_are_where_the_slope_rises_and_of_very_many_the_lowest(self):
        assert tabulated([0.0, 1.0, 2.0, 3.0], [0.0, 0.0, 1.0, 1.0], "linear").crests == (1.0,)
        y = np.arange(40_000.0)
        relief = np.where(y % 2 == 0, 1.0, 2.0)
        relief[12_344] = 0.0
        crests = tabulated(y, relief, "linear").shifted(0.5).crests
        assert len(crests) <= 5000
        assert 12_344.5 in crests

    def test_smooth_and_rough_data_have_no_bends(self):
        y = np.linspace(-10.0, 10.0, 201)
        assert tabulated(y, y**2 / 2000.0, "linear").bends == ()
        rough = np.random.default_rng(1).normal(0.0, 1e-4, 201)
        assert tabulated(y, rough, "linear").bends == ()
        assert tabulated([0.0, 1.0, 2.0], [0.0, 1.0, 2.0], "linear").bends == ()

    @pytest.mark.parametrize("by", [0.1, -0.1, 1.0 / 3.0, 7.3])
    def test_ends_stay_in_the_body_when_moved(self, by):
        for low, high in np.random.default_rng(14).uniform(-10.0, 10.0, (200, 2)).round(2):
            profile = tabulated([low, high], [0.0, 1.0]).shifted(by)
            assert np.isfinite(profile.relief(profile.extent)).all()
            body = Body(profile=tabulated([low, high], [0.0, 1.0]), position=by)
            assert np.isfinite(body.relief(body.interval)).all()

    @pytest.mark.parametrize("interpolation", ["pchip", "linear", "cubic"])
    @pytest.mark.parametrize("apart", [5e-324, 1e-300, 1e-200, 1e-13])
    def test_points_on_one_another_are_refused(self, interpolation, apart):
        with pytest.raises(InputError, match=r"y = .* must keep its points 1e-12 mm apart"):
            tabulated([0.0, apart, 1.0], [0.0, 1.0, 0.0], interpolation)
        assert np.isfinite(tabulated([0.0, 2e-12, 1.0], [0.0, 1.0, 0.0], interpolation).relief([0.0, 0.5])).all()


class TestFile:
    @pytest.mark.parametrize(
        "text",
        [
            "-1,0.5\n0,0\n1,0.5\n",
            "-1;0.5\n0;0\n1;0.5",
            "-1;0,5;\n0;0;\n1;0,5;\n",
            "-1\t0,5\r\n0\t0\r\n1\t0,5\r\n",
            "-1\t0.5\r0\t0\r1\t0.5\t\r",
            "  -1   0.5\n\n 0 0\n 1 5e-1  \n",
            "# measured in Aachen\ny [mm], relief [mm]\n-1, 0.5  # left end\n0, 0\n1, 0.5,\n",
            "\ufeff1,0.5\n0,0\n-1,0.5\n",
        ],
    )
    def test_separators_decimals_comments_and_header(self, tmp_path, text):
        path = tmp_path / "roller.csv"
        path.write_bytes(text.encode("utf-8"))
        assert from_file(path) == tabulated([-1.0, 0.0, 1.0], [0.5, 0.0, 0.5])
        assert from_file(str(path), "linear").interpolation == "linear"

    @pytest.mark.parametrize(
        ("content", "told"),
        [
            (b"", "at least two points (roller.csv holds no data)"),
            (b"\n# nothing\n\n", "holds no data"),
            (b"y, relief\n", "holds no data"),
            (b"1, 2\n", "holds only one point"),
            (b"1, 2\n3, x\n", "line 2 of roller.csv = '3, x' must hold two finite numbers"),
            (b"1, 2\n\n3\n", "line 3 of roller.csv = '3' must"),
            (b"1, 2, 3\n", "line 1 of roller.csv = '1, 2, 3' must"),
            (b"1,5 0,1\n", "line 1 of roller.csv"),
            (b"y relief\ny relief\n", "line 2 of roller.csv"),
            (b"1, x\n2, 3\n", "line 1 of roller.csv"),
            (b"1, 2\n2, nan\n", "line 2 of roller.csv"),
            (b"1, 2\n2, inf\n", "line 2 of roller.csv"),
            (b"1, 2\n1, 3\n", "roller.csv.y = (1.0, 1.0) must not hold 1.0 twice"),
            ("y [mm]; relief [µm]\n1; 2\n".encode(), "must name mm as the unit"),
            (b"y/mm, relief/um\n1, 2\n", "must name mm as the unit"),
            (b"\xff\xfe1\x00", "must name a text file in UTF-8"),
        ],
    )
    def test_what_is_wrong_is_told_in_one_sentence(self, tmp_path, content, told):
        path = tmp_path / "roller.csv"
        path.write_bytes(content)
        with pytest.raises(InputError) as caught:
            from_file(path)
        sentence = str(caught.value)
        assert told in sentence
        assert sentence.endswith(".")
        assert "\n" not in sentence

    def test_missing_file_folder_and_nonsense(self, tmp_path):
        for path in (tmp_path / "missing.csv", tmp_path, "a\0b", None, 3):
            with pytest.raises(InputError, match=r"^path = "):
                from_file(path)

    def test_words_like_column_or_minimum_are_no_units(self, tmp_path):
        path = tmp_path / "roller.csv"
        path.write_text("column, minimum\n0, 0\n1, 1\n")
        assert from_file(path) == tabulated([0.0, 1.0], [0.0, 1.0])


class TestAlgebra:
    def test_sum_is_flat_and_collects(self):
        total = partial_crown(500.0, 8.0) + chamfer(20.0, 0.5) + tabulated([-9.0, 9.0], [0.0, 0.0])
        assert isinstance(total, Sum)
        assert len(total.parts) == 3
        assert total.bends == (-9.5, -4.0, 4.0, 9.5)
        assert total.extent == (-9.0, 9.0)
        assert at(total, 9.5) == math.inf

    @pytest.mark.parametrize("factor", [-1.0, 0.0, 2.0])
    def test_scaling_leaves_the_end_of_a_body_alone(self, factor):
        assert at(iso_logarithmic(10.0, 10.0).scaled(factor), 5.0) == math.inf
        assert at(tabulated([0.0, 1.0], [0.0, 1.0]).scaled(factor), 2.0) == math.inf

    def test_only_profiles_add(self):
        with pytest.raises(TypeError):
            crown(1000.0) + 1.0


class TestRefusals:
    @pytest.mark.parametrize(
        ("field", "make"),
        [
            ("straight", lambda: partial_crown(500.0, -1.0)),
            ("straight", lambda: partial_crown(5.0, 10.1, blended=False)),
            ("middle", lambda: two_radius(5.0, 500.0, 10.0)),
            ("fraction", lambda: logarithmic(1e-3, 20.0, 1.1)),
            ("load", lambda: lundberg(1e9, 20.0, 10.0)),
            ("load", lambda: johns_gohar(1e9, 20.0, 10.0)),
            ("k2", lambda: fujiwara_kawase(20e3, 20.0, 10.0, k2=1.2)),
            ("k2", lambda: fujiwara_kawase(20e3, 20.0, 10.0, k2=1e-300)),
            ("load", lambda: johns_gohar(1e-320, 20.0, 10.0)),
            ("radius", lambda: crown(1e300)),
            ("relief", lambda: tabulated([0.0, 1.0], [0.0, 1e300])),
            ("zm", lambda: fujiwara_kawase(20e3, 20.0)),
            ("angle", lambda: conical(2.0)),
            ("angle", lambda: chamfer(20.0, 0.5, angle=45.0)),
            ("width", lambda: chamfer(20.0, 10.1)),
            ("y", lambda: tabulated([0.0], [0.0])),
            ("y", lambda: tabulated([0.0, 1.0, 1.0], [0.0, 1.0, 2.0])),
            ("y", lambda: tabulated([[0.0, 1.0]], [0.0, 1.0])),
            ("y", lambda: tabulated([[0.0], [1.0, 2.0]], [0.0, 1.0])),
            ("relief", lambda: tabulated([0.0, 1.0], [0.0, 1.0, 2.0])),
            ("interpolation", lambda: tabulated([0.0, 1.0], [0.0, 1.0], "quintic")),
        ],
    )
    def test_names_the_field_in_one_sentence(self, field, make):
        with pytest.raises(InputError) as caught:
            make()
        sentence = str(caught.value)
        assert sentence.startswith((f"{field} = ", f"{field} must be given"))
        assert " must " in sentence
        assert ": " in sentence
        assert "\n" not in sentence


class TestCatalogue:
    def test_a_name_has_the_same_unit_in_every_kind(self):
        units = {}
        for make, parameters in zip(CATALOGUE.values(), PARAMETERS.values(), strict=True):
            assert typing.get_type_hints(make).pop("return") is Profile
            for name, each in parameters.descriptions.items():
                if isinstance(each, Quantity | Quantities):
                    assert units.setdefault(name, each.unit) == each.unit
        assert set(units.values()) == {"mm", "N", "1/MPa", "rad", ""}


def test_parameters_take_text_with_units_and_an_unknown_one_names_the_nearest():
    assert crown("4 m", centre="100 um") == crown(4000.0, 0.1)
    with pytest.raises(TypeError, match=r"Unknown field radus of crown. Did you mean radius\?"):
        crown(radus=4000)


@pytest.mark.parametrize(
    ("of", "given"), [(crown, "(radius: float, centre: float = 0.0)"), (Body, "length: float | None")]
)
def test_signatures_show_types_without_what_describes_them(of, given):
    assert given in str(inspect.signature(of))
    assert "Quantity" not in str(inspect.signature(of))


def test_the_displacement_of_a_uniform_pressure_is_that_of_the_element_near_and_far():
    t = np.concatenate([np.geomspace(1e-7, 1e4, 301), uniform_pressure.TABLE_RANGE[:2]])
    expected = SEMI_ELLIPTIC.functions(t)[0]
    for sign in (1.0, -1.0):
        np.testing.assert_allclose(uniform_pressure._displacement(sign * t), sign * expected, rtol=1e-10, atol=0.0)


CROWN = catalogue.crown(radius=4000)


@pytest.mark.parametrize(
    ("profile", "typed"),
    [
        (catalogue.iso_logarithmic(20, 20), "iso_logarithmic(diameter=20, length=20)"),
        (CROWN, "crown(radius=4000)"),
        (catalogue.crown(radius=4000, centre=0.5), "crown(radius=4000, centre=0.5)"),
        (CROWN + catalogue.chamfer(length=20, width=0.5), "crown(radius=4000) + chamfer(length=20, width=0.5)"),
        (CROWN.scaled(0.5).shifted(-1).flipped(), "crown(radius=4000).scaled(0.5).shifted(-1).flipped()"),
        ((CROWN + CROWN).shifted(1), "(crown(radius=4000) + crown(radius=4000)).shifted(1)"),
        (catalogue.straight(), "straight()"),
        (
            catalogue.tabulated(range(100), np.linspace(0.0, 0.01, 100)),
            "tabulated(y=(0, ..., 99), relief=(0, ..., 0.01))",
        ),
    ],
    ids=str,
)
def test_a_profile_shows_what_was_typed_and_the_ends_of_many_points(profile, typed):
    assert repr(profile) == typed
    assert repr((profile, Body(position=1.0))) == f"({typed}, Body(position=1))"
