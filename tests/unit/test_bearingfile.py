"""Bearing files: what is read, how it is written, and every mistake in a sentence."""

import dataclasses
import math
import re
import tomllib
from pathlib import Path

import numpy as np
import pytest
from few_rollers import SPHERICAL, THRUST, changed
from numpy.testing import assert_array_equal

import nonhertz as nh
from nonhertz.errors import without_accuracy_warnings
from nonhertz.files.bearingfile import BearingCase, read_bearing
from nonhertz.files.casefile import read_case
from nonhertz.files.schemas import schema_of
from nonhertz.files.starting import starting_bearing
from nonhertz.files.toml import parse

KINDS = nh.bearing.RollerBearing.kinds
ROLLER = nh.Roller(diameter=9, length=10, corner_radius=0.3, profile=nh.profile.crown(radius=1200))
NU206 = nh.bearing.CylindricalRollerBearing(
    roller=ROLLER,
    inner=nh.Ring(diameter=37.5, depth=3.75),
    outer=nh.Ring(diameter=-55.5, depth=3.25),
    rollers=13,
    clearance=0.0184,
)
HARD = nh.MATERIALS["100Cr6"]
OF_100CR6 = dataclasses.replace(
    NU206, **{name: dataclasses.replace(getattr(NU206, name), material=HARD) for name in ("roller", "inner", "outer")}
)
RING = "[inner]\ndiameter = 37.5\n"
PLAIN = f"""
[bearing]
kind = "cylindrical"
rollers = 13
[roller]
diameter = 9.0
length = 10.0
profile = {{ kind = "crown", radius = 1200 }}
{RING}[outer]
diameter = -55.5
[load]
radial = "10 kN"
"""
TAPERED = """
[bearing]
kind = "tapered"
rollers = 14
contact_angle = "11.859 deg"
[roller]
diameter = { y = [-5.825, 5.825], diameter = [10.94, 10.12] }
length = 11.65
profile = { kind = "crown", radius = 8000 }
[inner]
diameter = 40.8
[outer]
diameter = -62.32
[load]
radial = "30 kN"
axial = "9 kN"
"""


def read(text: str) -> BearingCase:
    return BearingCase.of(parse(text, "bearing.toml"), Path("bearing.toml"))


def mistakes(text: str) -> list[str]:
    with pytest.raises(nh.CaseError) as caught:
        read(text)
    return list(caught.value.mistakes)


# What is read


def test_the_starting_file_is_the_bearing_of_the_how_to():
    case = read(starting_bearing())
    assert case.bearing == OF_100CR6
    assert (case.lubrication.cleanliness, case.assumed[0].kind) == ("-/17/14", "assumed")
    assert case.prescribed.keywords == {"radial": 10e3, "tilt": 3e-4, "speed": 3000.0}
    assert case.solver.method == "strips"
    assert case.lubrication.viscosity == 20.0
    assert case.title == "NU 206"


def test_the_file_of_the_reference_is_the_same_bearing():
    page = Path(__file__).parents[2] / "docs" / "reference" / "bearing-file.md"
    whole, spectrum = re.findall(r"```toml\n(.*?)```", page.read_text(encoding="utf-8"), re.DOTALL)
    assert read(whole).bearing == OF_100CR6
    assert [case.share for case in read(whole + spectrum).spectrum] == [0.1, 0.9]


def test_what_is_commented_out_in_the_starting_file_is_as_good():
    """Every key that a comment offers is a known one, with a value that is taken in a bearing of its kind."""
    offered = dict(re.findall(r"^# (\w+) = (.*?)(?:  .*)?$", starting_bearing(), re.MULTILINE))
    tables = schema_of("bearing")["$defs"]
    known = {name for table in tables.values() for name in table["properties"]}
    assert len(offered) > 8
    assert set(offered) <= known
    for value in offered.values():
        tomllib.loads(f"key = {value.partition('   #')[0]}")


def test_the_fits_that_the_starting_file_offers_leave_a_clearance_and_stay_tight():
    text = starting_bearing()
    fits = text[text.index("# [fit]") : text.index("[solver]")]
    case = read(text.replace(fits, re.sub(r"^# ", "", fits, flags=re.MULTILINE)))
    found = case.operating_clearance
    (said,) = re.findall(r"reduced by these to ([\d.]+) um", text)
    # NSK's formula of the fit (recalled), and 12.5e-6 a kelvin.
    by_hand = 18.4 - 5.0 * 30.0 / 37.5 - 12.5e-3 * (37.5 * 40.0 + 18.0 * 35.0 - 55.5 * 30.0)
    assert 1e3 * found.clearance == pytest.approx(by_hand, abs=0.05)
    assert 1e3 * found.clearance == pytest.approx(float(said), abs=0.1)
    assert found.inner.pressure > 0.0
    assert found.findings == ()


def test_a_tapered_pair_with_a_rib_and_a_preload():
    text = changed(
        TAPERED,
        ("rollers = 14", 'rollers = 14\npair = { arrangement = "O", distance = "2 cm", clearance = "-10 um" }'),
        ('kind = "tapered"', 'kind = "tapered"\nclearance = 0.02\nrib = { end_radius = 100, height = 4.9 }'),
    )
    case = read(text)
    row = nh.bearing.TaperedRollerBearing(
        roller=nh.Roller(
            diameter=nh.TabulatedDiameter((-5.825, 5.825), (10.94, 10.12)),
            length=11.65,
            profile=nh.profile.crown(radius=8000),
        ),
        inner=nh.Ring(diameter=40.8),
        outer=nh.Ring(diameter=-62.32),
        rollers=14,
        contact_angle=math.radians(11.859),
        clearance=0.02,
        rib=nh.bearing.Rib(100.0, 4.9),
    )
    assert case.bearing == nh.bearing.paired(row, "O", 20.0, clearance=-0.01)


def test_washers_are_plates_and_rows_of_barrels_are_paired():
    thrust, spherical = read(THRUST).bearing, read(SPHERICAL)
    assert isinstance(thrust, nh.bearing.CylindricalThrustBearing)
    assert isinstance(thrust.inner, nh.Plate)
    assert isinstance(spherical.bearing, nh.bearing.Paired)
    assert spherical.bearing.turned == (True, False)
    assert spherical.prescribed.radial == (20e3, 5e3)


@pytest.mark.parametrize("kind", KINDS)
def test_every_kind_of_bearing_has_a_word(kind):
    assert getattr(nh.bearing, KINDS[kind].__name__) is KINDS[kind]
    assert set(KINDS.values()) == set(nh.bearing.RollerBearing.__subclasses__()) | {nh.bearing.NeedleRollerBearing}


def test_the_file_says_how_it_is_solved_and_assessed():
    text = (
        PLAIN
        + 'speed = 1000\n[solver]\nmethod = "slices"\nlaminae = 35\n[lubrication]\nviscosity = "20 cSt"\n'
        + '[life]\nstatic = "30 kN"\n'
    )
    case = read(text)
    found = case.solve()
    direct = nh.bearing.solve(case.bearing, radial=10e3, speed=1000, method="slices", laminae=35)
    assert_array_equal(found.load, direct.load)
    assert case.assess(found) == nh.bearing.assess(
        direct, speed=1000, viscosity=case.lubrication.viscosity, static=30e3
    )
    assert case.assess(found).static_safety == pytest.approx(3.0, rel=1e-9)


@pytest.mark.parametrize(
    ("written", "speed"),
    [("3000", 3000.0), ('"3000 rpm"', 3000.0), ('"3000 r/min"', 3000.0), ('"50 Hz"', 3000.0), ('"50 1/s"', 3000.0)],
)
def test_speeds(written, speed):
    assert read(f"{PLAIN}speed = {written}\n").prescribed.speed == pytest.approx(speed, rel=1e-15)


def test_an_angular_speed_is_one_of_turns_and_a_density_has_a_unit():
    case = read(changed(PLAIN, ("rollers = 13", 'rollers = 13\ndensity = "3.2 g/cm^3"')) + 'speed = "100 rad/s"\n')
    assert case.prescribed.speed == pytest.approx(3000.0 / math.pi, rel=1e-12)
    assert case.bearing.density == pytest.approx(3.2e-9, rel=1e-12)


def test_profiles_know_their_body_and_for_a_design_load_the_inner_ring():
    lundberg = changed(PLAIN, ('kind = "crown", radius = 1200', 'kind = "lundberg", load = 3000'))
    radius = 1.0 / (2.0 / 9.0 + 2.0 / 37.5)
    expected = nh.profile.lundberg(load=3000, length=10, radius=radius)
    y = np.array([-4.5, 0.0, 2.0])
    np.testing.assert_allclose(read(lundberg).bearing.roller.profile.relief(y), expected.relief(y), rtol=1e-12)


def test_the_radius_of_cones_is_not_guessed():
    lundberg = changed(TAPERED, ('kind = "crown", radius = 8000', 'kind = "lundberg", load = 3000'))
    (mistake,) = mistakes(lundberg)
    assert mistake.startswith("roller.profile.radius must be given")


def test_a_profile_in_a_file_beside_it_is_attached(tmp_path):
    (tmp_path / "points.csv").write_text("-5, 0.01\n0, 0\n5, 0.01\n", encoding="utf-8")
    text = changed(PLAIN, ('kind = "crown", radius = 1200', 'kind = "tabulated", file = "points.csv"'))
    (tmp_path / "bearing.toml").write_text(text, encoding="utf-8")
    case = read_bearing(tmp_path / "bearing.toml")
    assert case.attachments == {"points.csv": b"-5, 0.01\n0, 0\n5, 0.01\n"}
    assert case.text == text
    assert case.title == "bearing"


# What is written


HARDENED = changed(
    PLAIN,
    ("[roller]", '[roller]\ncase_depth = "0.8 mm"\nmaterial = "18CrNiMo7-6"'),
    (RING, RING + "material = { modulus = 210000, poisson = 0.3, yield_strength = 1800 }\n"),
)
RIBBED = changed(
    TAPERED,
    ("rollers = 14", 'rollers = 14\npair = { arrangement = "tandem", distance = 20, clearance = -0.02 }'),
    ('kind = "tapered"', 'kind = "tapered"\nclearance = 0.01\nrib = { end_radius = 100, height = 4 }\ndensity = 7e-9'),
)


@pytest.mark.parametrize(
    "text", [starting_bearing(), PLAIN, TAPERED, THRUST, SPHERICAL, HARDENED, RIBBED], ids=range(7)
)
def test_what_is_written_is_read_back(text, tmp_path):
    case = read(text)
    case.write(tmp_path / "again.toml")
    again = read_bearing(tmp_path / "again.toml")
    assert again == dataclasses.replace(case, title=again.title)
    assert read(dataclasses.replace(case).text) == again


@pytest.mark.parametrize(
    ("bearing", "field"),
    [
        (dataclasses.replace(NU206, outer_shape=lambda angle: 0.0 * angle), "outer_shape"),
        (nh.bearing.Paired(bearings=(NU206,) * 3, x=(-20, 0, 20), turned=(False,) * 3), "bearings"),
        (nh.bearing.Paired(bearings=(NU206,) * 2, x=(0, 20), turned=(False,) * 2), "bearings"),
        (dataclasses.replace(NU206, roller=nh.Roller(diameter=lambda y: 9.0 + 0.0 * y, length=10)), "roller.diameter"),
        (nh.bearing.RollerBearing(roller=ROLLER, inner=NU206.inner, outer=NU206.outer, rollers=3), "bearing"),
    ],
)
def test_what_no_file_can_hold_is_refused_and_nothing_is_written(bearing, field, tmp_path):
    with pytest.raises(nh.InputError) as caught:
        BearingCase(bearing).write(tmp_path / "no.toml")
    assert caught.value.field == field
    assert list(tmp_path.iterdir()) == []


# Mistakes

MISTAKE = [
    (PLAIN, "rollers = 13", "rollers = 30", "bearing.rollers = 30 must fit on a pitch circle of 46.5 mm with a dia"),
    (PLAIN, "rollers = 13", 'rollers = 13\nclearance = "-5 mm"', "bearing.clearance = '-5 mm' must lie between -0.465"),
    (PLAIN, "rollers = 13", "rollers = 13\nrib = { end_radius = 100, height = 3 }", "bearing.design = 'NU' must have"),
    (TAPERED, "rollers = 14", "rollers = 14\nrib = { end_radius = 100 }", "bearing.rib.height must be given"),
    (TAPERED, "rollers = 14", "rollers = 14\nrib = { end_radius = 10, height = 20 }", "bearing.rib.height = 20.0 must"),
    (
        PLAIN,
        "[load]",
        "[load]\naxial = 500",
        "load.axial = 500.0 must be zero for a bearing whose inner ring is free to",
    ),
    (
        TAPERED,
        "9 kN",
        "500 N",
        "load.axial = 500.0 must exceed 6.3 kN along +x, the tangent of the contact angle times",
    ),
    (PLAIN, '"cylindrical"', '"cylindric"', "bearing.kind = 'cylindric' must be a known kind of bearing"),
    (PLAIN, '"cylindrical"', "[]", "bearing.kind = [] must be a known kind of bearing"),
    (PLAIN, "[load]", '[load]\nspeed = "3000 m/s"', "load.speed = '3000 m/s' must have a unit of speed"),
    (PLAIN, '"10 kN"', "[1, 2, 3]", "load.radial = [1, 2, 3] must be one value or two"),
    (
        PLAIN,
        "[load]",
        "[load]\nradial_displacement = 0.01",
        "load.radial_displacement = 0.01 must not be given together",
    ),
    (PLAIN, "[load]", "[load]\ntilt = 3", "load.tilt = 3.0 must be a small angle, of at most 0.3 rad"),
    (PLAIN, "-55.5", "55.5", "outer.diameter = 55.5 must be negative"),
    (THRUST, "[inner]", "[inner]\ndiameter = 40", "inner.diameter = 40.0 must be left out"),
    (PLAIN, "diameter = 9.0", "diameter = 9.5", "roller.diameter = 9.5 must fill the 9 mm between raceways of 37.5"),
    (
        TAPERED,
        "[10.94, 10.12]",
        "[10.12, 10.94]",
        "roller.diameter must be a table of y and diameter that is larger at",
    ),
    (TAPERED, "11.859 deg", "60 deg", "bearing.contact_angle = '60 deg' must not exceed 0.7854 rad, 45 degrees"),
    (SPHERICAL, "inner_groove = 61.5", "inner_groove = 59", "bearing.inner_groove = 59.0 must exceed the radius of"),
    (SPHERICAL, '"X"', '"Y"', "bearing.pair.arrangement = 'Y' must be one of 'X', 'O', 'tandem'"),
    (
        PLAIN,
        "[load]",
        "[lubrication]\nviscosity = 20\n[load]",
        "lubrication.viscosity = 20.0 must be given with a speed above zero",
    ),
    (
        PLAIN,
        "[load]",
        "[lubrication]\ncontamination = 0.5\n[load]",
        "lubrication.contamination = 0.5 must be given with a viscosity",
    ),
    (PLAIN, "[load]", "[life]\nviscosity = 20\n[load]", "life.viscosity = 20 must be in [lubrication]: move it"),
    (PLAIN, "[load]", "[life]\nreliability = 0.5\n[load]", "life.reliability = 0.5 must lie between 0.9 and 0.9995"),
    (PLAIN, "[bearing]", "format = 7\n[bearing]", "format = 7 must be 1, the newest format this release reads"),
    (PLAIN, RING, RING + "length = 5\nposition = 100\n", "inner.position = 100.0 must let the bodies overlap along y"),
]
MISTAKES = [
    *((changed(text, (old, new)), said) for text, old, new, said in MISTAKE),
    (changed(PLAIN, ("[outer]", "[outr]")), "Unknown key outr. Did you mean outer?"),
    (
        f'{PLAIN}[solver]\nmethod = "slices"\n[life]\nedge_stress = "pressure"\n',
        "life.edge_stress = 'pressure' must be 'standard' or 'none' for slices",
    ),
    (
        "[bearing]\nkind = 'thrust'\n",
        "bearing.rollers must be given",
        "bearing.pitch_diameter must be given",
        "roller must be given",
        "inner must be given",
        "outer must be given",
        "load must be given",
    ),
    (
        "bearing = 3\nroller = 'x'\n[inner]\n[outer]\n[load]\n",
        "bearing = 3 must be a section",
        "roller = 'x' must be a section",
    ),
    (
        changed(
            PLAIN,
            ("rollers = 13", "rollers = 0\nclearance = '1 N'\ngirth = 3"),
            ("length = 10.0", "length = -1"),
            ("-55.5", "nan"),
            ("10 kN", "10"),
        )
        + "[solver]\nmethod = 3\n[life]\nspeed = 3\n",
        "bearing.rollers = 0 must be a whole number from 1 to 1000",
        "bearing.clearance = '1 N' must have a unit of length",
        "Unknown key bearing.girth: ",
        "roller.length = -1.0 must be positive",
        "outer.diameter = nan must be a finite number",
        "load.radial = '10' must have a unit",
        "solver.method = 3 must be one of 'strips', 'slices'",
        "Unknown key life.speed: ",
    ),
    (
        changed(PLAIN, ("rollers = 13", "rollers = 30")) + "tilt = '1 m'\n",
        "bearing.rollers = 30 must fit on a pitch circle of 46.5 mm with a diameter of 9 mm",
        "load.tilt = '1 m' must have a unit of angle",
    ),
    (
        f"{PLAIN}axial = 500\n[life]\nreliability = 2\n",
        "load.axial = 500.0 must be zero for a bearing whose inner ring is free to move along the axis",
        "life.reliability = 2.0 must lie between 0.9 and 0.9995",
    ),
]


def test_a_case_file_and_a_bearing_file_are_told_apart(tmp_path):
    (tmp_path / "bearing.toml").write_text(PLAIN, encoding="utf-8")
    (tmp_path / "case.toml").write_text("[body.a]\n[body.b]\n[load]\nload = 1.0\n", encoding="utf-8")
    with pytest.raises(nh.CaseError, match=r"single contact, not a bearing: use nonhertz\.read_bearing"):
        read_case(tmp_path / "bearing.toml")
    with pytest.raises(nh.CaseError, match=r"a bearing, not a single contact: use nonhertz\.read_case"):
        read_bearing(tmp_path / "case.toml")


def test_what_the_solver_refuses_names_the_key():
    case = read(PLAIN)
    with pytest.raises(nh.CaseError, match=r"^load\.axial = 5\.0 must be zero"):
        dataclasses.replace(case, prescribed={"radial": 1e3, "axial": 5}).solve()
    with pytest.raises(nh.CaseError, match=r"^load\.speed must be given with a viscosity"):
        dataclasses.replace(case, lubrication={"viscosity": 20.0}).assess(case.solve("slices"))
    with pytest.raises(nh.CaseError, match=r"^solver\.method = 'maps' must be one of"):
        case.solve("maps")
    thin = {"viscosity": 0.1, "contamination": 1}
    fast = dataclasses.replace(case, prescribed={"radial": 1e3, "speed": 1e3}, lubrication=thin)
    with pytest.raises(nh.CaseError, match=r"^lubrication\.viscosity = 0\.0\d+ must be at least 0\.1"):
        fast.assess(fast.solve("slices"))


SPECTRUM = """
[[life.spectrum]]
share = 0.1
radial = "20 kN"
speed = 500
[[life.spectrum]]
share = 0.6
radial = 6e3
tilt = "0.2 mrad"
"""


def test_a_spectrum_is_assessed_in_place_of_the_load(tmp_path):
    text = f'{PLAIN}speed = 1000\n[solver]\nmethod = "slices"\n[lubrication]\nviscosity = 60\n'
    text += f'[life]\nturning = "outer"\n{SPECTRUM}'
    case = read(text)
    cases = [
        nh.bearing.BearingLoadCase(share=0.1, radial=20e3, speed=500.0),
        nh.bearing.BearingLoadCase(share=0.6, radial=6e3, tilt=2e-4, speed=1000.0),
    ]
    pairs = nh.bearing.solve_spectrum(case.bearing, cases, turning="outer", method="slices")
    expected = nh.bearing.assess(pairs, viscosity=60.0, speed=[500.0, 1000.0])
    assert case.assess(case.solve()) == expected
    case.write(tmp_path / "again.toml")
    again = read_bearing(tmp_path / "again.toml")
    assert again.spectrum == case.spectrum
    assert again.life == case.life


def test_the_verdict_is_that_of_the_worst_load_of_a_spectrum():
    """Under a tilt the pressure exceeds the limit though the load in its place and C0 over P0 are moderate."""
    part = '[roller]\nmaterial = "100Cr6"\ncorner_radius = 0.3\n'
    text = PLAIN.replace("[roller]\n", part).replace("diameter = 37.5", 'diameter = 37.5\nmaterial = "100Cr6"')
    text = text.replace("diameter = -55.5", 'diameter = -55.5\nmaterial = "100Cr6"')
    loads = [{"share": 0.9, "radial": 5e3}, {"share": 0.1, "radial": 10e3, "tilt": 4e-3}]
    case = read(text + "[life]\n" + "".join(
        "[[life.spectrum]]\n" + "".join(f"{name} = {value}\n" for name, value in load.items()) for load in loads
    ))  # fmt: skip
    solution = case.solve()
    life = case.assess(solution)
    worst = nh.bearing.solve(case.bearing, radial=10e3, tilt=4e-3)
    assert solution.max_pressure.max() < 3e3
    assert worst.max_pressure.max() > 4e3
    assert life.static_safety > 1.0
    assert case.verdict(solution).words.startswith("Static pressure below its limit")
    verdict = case.verdict(solution, life)
    assert verdict.words == "Limits not met under load 2 of the spectrum."
    assert dict(verdict.findings[0].numbers)["pressure"].values == pytest.approx([worst.max_pressure.max()])


def test_gaps_in_a_measured_profile_are_noted(tmp_path):
    y = np.concatenate([np.linspace(-5, -1, 801), np.linspace(1, 5, 801)])
    lines = "\n".join(f"{a:.5f} {-(a**2) / 2400.0:.7f}" for a in y)
    (tmp_path / "trace.txt").write_text(lines, encoding="utf-8")
    text = changed(PLAIN, ('{ kind = "crown", radius = 1200 }', '{ kind = "measured", file = "trace.txt" }'))
    (tmp_path / "bearing.toml").write_text(text, encoding="utf-8")
    with without_accuracy_warnings():
        case = read_bearing(tmp_path / "bearing.toml")
    assert case.notes == ("Nothing was measured between y = -1 and 1 mm; the profile bridges it with a curve.",)


# Rings that are not round


def shaped(value: str, text: str = PLAIN) -> BearingCase:
    return read(changed(text, ("rollers = 13", f"rollers = 13\nouter_shape = {value}")))


def test_waves_deviations_and_sums_are_shapes():
    oval = shaped('{ terms = [{ waves = 2, amplitude = "5 um", phase = "90 deg" }] }').bearing.outer_shape
    # A crest at 90 degrees leaves 5 um less room there, and 5 um more a quarter of a turn on.
    assert oval([0.0, 0.5 * math.pi]).tolist() == pytest.approx([-0.005, 0.005])
    row = '{ angle = ["0 deg", "90 deg", "180 deg"], deviation = ["1 um", 0, "2 um"], curve = "linear" }'
    assert shaped(row).bearing.outer_shape([0.25 * math.pi]).tolist() == pytest.approx([0.0005])
    both = shaped(f'[{{ terms = [{{ waves = 0, amplitude = "5 um" }}] }}, {row}]').bearing.outer_shape
    assert both([0.0, math.pi]).tolist() == pytest.approx([0.006, 0.007])


def test_a_file_of_a_shape_is_read_beside_the_bearing_file(tmp_path):
    (tmp_path / "oval.txt").write_text("0 4\n90 -4\n180 4\n270 -4\n", encoding="utf-8")
    value = '{ file = "oval.txt", angle_unit = "deg", deviation_unit = "um", curve = "linear" }'
    text = changed(PLAIN, ("rollers = 13", f"rollers = 13\ninner_shape = {value}"))
    path = tmp_path / "bearing.toml"
    path.write_text(text, encoding="utf-8")
    case = read_bearing(path)
    assert case.bearing.inner_shape([0.0, 0.25 * math.pi]).tolist() == pytest.approx([0.004, 0.0])
    assert set(case.attachments) == {"oval.txt"}
    with pytest.raises(nh.CaseError) as caught:
        BearingCase.of(parse(text, "bearing.toml"), path, files=False)
    assert caught.value.mistakes == (
        "bearing.inner_shape.file = 'oval.txt' must not be read here: write the angles and deviations into the file.",
    )


def test_shapes_are_written_and_read_back(tmp_path):
    waves = nh.bearing.fourier_shape({2: (0.005, 0.3), 3: 0.001})
    numbers = nh.bearing.tabulated_shape([0.0, 1.0, 2.5, 5.0], [0.0, 0.002, 0.0, -0.001])
    bearing = dataclasses.replace(NU206, inner_shape=waves + numbers, outer_shape=numbers)
    BearingCase(bearing, {"radial": 1e3}).write(tmp_path / "shaped.toml")
    assert read_bearing(tmp_path / "shaped.toml").bearing == bearing
    turned = dataclasses.replace(NU206, outer_shape=numbers.turned(0.7))
    BearingCase(turned, {"radial": 1e3}).write(tmp_path / "turned.toml")
    at = np.linspace(0.0, 6.0, 30)
    back = read_bearing(tmp_path / "turned.toml").bearing.outer_shape(at)
    np.testing.assert_allclose(back, turned.outer_shape(at), atol=1e-15)
    function = dataclasses.replace(NU206, outer_shape=lambda angle: 0.01 * np.cos(angle))
    with pytest.raises(nh.InputError, match="must be made by fourier_shape or tabulated_shape"):
        BearingCase(function, {"radial": 1e3}).write(tmp_path / "function.toml")


# Fits

FIT = """
[fit.shaft]
diameter = 30
interference = "12 um"
[fit.housing]
diameter = 62
"""
LOOSE = PLAIN.replace("rollers = 13", 'rollers = 13\nclearance = "32.5 um"')


def test_a_fit_leaves_less_clearance():
    case = read(LOOSE + FIT)
    # On a solid shaft of the same steel a raceway grows by d / F of the interference (NSK).
    left = 0.0325 - 30.0 / 37.5 * 0.012
    assert case.bearing.clearance == 0.0325
    assert case.mounted.clearance == pytest.approx(left)
    assert case.operating_clearance.lost_to_inner_fit == pytest.approx(30.0 / 37.5 * 0.012)
    by_hand = nh.bearing.solve(dataclasses.replace(case.bearing, clearance=left), radial=10e3, method="slices")
    np.testing.assert_allclose(case.solve("slices").load, by_hand.load, rtol=1e-9)
    assert case.solve("slices").bearing == case.mounted
    assert read(LOOSE).mounted.clearance == 0.0325
    assert read(LOOSE).operating_clearance is None


def test_needles_of_group_c4_are_judged_by_their_pitch_circle():
    text = """
[bearing]
kind = "needle"
rollers = 24
clearance = "65 um"
[roller]
diameter = 3.0
length = 16
corner_radius = 0.2
profile = [{ kind = "logarithmic", drop = "6 um", fraction = 0.95 }]
[inner]
diameter = 30
depth = 2.5
[outer]
diameter = -36
depth = 3
[load]
radial = "5 kN"
[solver]
method = "slices"
[fit.shaft]
diameter = 25
interference = "25 um"
smoothing = "4 um"
[fit.housing]
diameter = 42
interference = "10 um"
smoothing = "3 um"
outside_diameter = 70
"""
    case = read(text)
    # NSK's formulas for rings of one steel (recalled), as in test_bearing_clearance.py.
    h, h0 = 36.0 / 42.0, 42.0 / 70.0
    left = 0.065 - 25.0 / 30.0 * 0.021 - h * (1.0 - h0**2) / (1.0 - (h * h0) ** 2) * 0.007
    assert case.mounted.clearance == pytest.approx(left)
    assert case.solve().force[1] == pytest.approx(5e3)


def test_tapered_rows_lose_axial_clearance():
    fit = FIT.replace("62", "72")
    text = changed(
        TAPERED,
        ('kind = "tapered"', 'kind = "tapered"\nclearance = "100 um"'),
        ("rollers = 14", 'rollers = 14\npair = { arrangement = "O", distance = 20 }'),
    )
    case = read(text + fit)
    radial = 30.0 / 40.8 * 0.012
    left = 0.1 - radial / (2.0 * math.tan(math.radians(11.859)))
    assert [row.clearance for row in case.mounted.bearings] == pytest.approx([left, left])
    assert case.mounted.clearance == case.bearing.clearance


def test_fits_are_written_and_read_back(tmp_path):
    shaft = nh.bearing.Shaft(diameter=30, interference=0.012, bore=10, material=nh.Material(2e5, 0.29), temperature=60)
    housing = nh.bearing.Housing(diameter=62, outside_diameter=90, expansion=2.3e-5)
    fit = {"shaft": shaft, "housing": housing, "inner_temperature": 70.0}
    case = BearingCase(NU206, {"radial": 1e3}, fit=fit)
    case.write(tmp_path / "fit.toml")
    back = read_bearing(tmp_path / "fit.toml")
    assert back.fit == nh.bearing.Mounting(**fit)
    assert back.mounted == case.mounted


def test_a_case_with_half_a_fit_is_refused():
    with pytest.raises(nh.InputError, match=r"fit\.housing must be given"):
        BearingCase(NU206, fit={"shaft": nh.bearing.Shaft(diameter=30)})
    with pytest.raises(nh.InputError, match=r"Unknown name fit\.axle: "):
        BearingCase(NU206, fit={"axle": 1})


def test_what_is_prescribed_may_be_text_with_units():
    case = BearingCase(
        NU206, {"radial": "10 kN", "speed": "1500 rpm"}, {"method": "slices"}, lubrication={"viscosity": "20 mm^2/s"}
    )
    assert case.prescribed.keywords == {"radial": 10e3, "speed": 1500.0}
    assert case.lubrication.viscosity == 20.0
    assert case.own_document["load"] == case.prescribed.keywords
    with pytest.raises(nh.InputError, match="radial = '10 mm' must have a unit of force"):
        BearingCase(NU206, {"radial": "10 mm"})


# Mistakes of tables within tables

OF_SHAPES = [
    ("3", " = 3 must be a table: "),
    ("[]", " = [] must hold 1 to 100 shapes: "),
    ("{ waves = 2 }", " must have terms, or angle and deviation, or a file: "),
    ("{ terms = [] }", ".terms = [] must be a list of tables: "),
    ("{ terms = [{ waves = 2 }] }", ".terms[1].amplitude must be given: "),
    ("{ terms = [{ waves = -1, amplitude = 0 }] }", ".terms[1].waves = -1 must be a whole numb"),
    ("{ terms = [{ waves = 2, amplitude = 0 }, { waves = 2, amplitude = 0 }] }", ".terms[2].wa"),
    ("{ angle = [0, 9], deviation = [0, 0] }", ".angle = 9.0 must span no more than one turn"),
    ("{ angle = [0, 1], deviation = [0] }", ".deviation = (0.0,) must be a row of 2 lengths"),
    ("{ file = 'no.txt' }", ".file = 'no.txt' must be a file that can be read"),
    ("{ file = 'no.txt', colour = 1 }", ".colour: choose from "),
]
OF_FITS = [
    ("[fit.housing]\ndiameter = 62\n", "", "fit.housing must be given: "),
    ("diameter = 30", "diameter = 40", "fit.shaft.diameter = 40.0 must be less than the diameter of the inner raceway"),
    ("diameter = 62", "diameter = 50", "fit.housing.diameter = 50.0 must exceed the diameter of the outer raceway"),
    ("diameter = 30", "diameter = 30\nbore = 31", "fit.shaft.bore = 31.0 must be less than the diameter"),
    ('"12 um"', '"1 mm"', "fit.shaft.interference = '1 mm' must not exceed 1 % of the diameter of 30 mm"),
    ("diameter = 62", "diameter = 62\nbore = 60", "Unknown key fit.housing.bore: "),
    ("diameter = 30", 'diameter = 30\ntemperature = "70 degC"', "fit.shaft.temperature = '70 degC' must be a plai"),
    ("[fit.shaft]", "[fit]\ninner_temperature = 2000\n[fit.shaft]", "fit.inner_temperature = 2000.0 must lie betw"),
    (
        "[fit.shaft]",
        "[fit]\nroller_temperature = 1000\nroller_expansion = 1e-4\n[fit.shaft]",
        "fit.roller_temperature = 1000.0 must leave a clearance: ",
    ),
]
OF_SPECTRA = [
    ("share = 0.6", "share = 0.95", "life.spectrum.share = 1.05 must add up to 1 at most"),
    ("radial = 6e3", "axial = 6e3", "life.spectrum[2].axial = 6000.0 must be zero for a bearing whose inner"),
    ("radial = 6e3", "radal = 6e3", "Unknown key life.spectrum[2].radal. Did you mean life.spectrum[2].radial?"),
]
MISTAKES += [
    (changed(LOOSE, ("[load]", "[load]\nspeed = 1e9")) + FIT, "load.speed = 1000000000.0 must leave a clearance: "),
    (THRUST + FIT, "fit must be left out: fits are those of cylindrical, needle, tapered and spherical"),
    *((LOOSE + changed(FIT, (old, new)), said) for old, new, said in OF_FITS),
    *((changed(PLAIN + SPECTRUM, (old, new)), said) for old, new, said in OF_SPECTRA),
    *(
        (changed(PLAIN, ("rollers = 13", f"rollers = 13\nouter_shape = {value}")), f"bearing.outer_shape{said}")
        for value, said in OF_SHAPES
    ),
]


@pytest.mark.parametrize("case", MISTAKES)
def test_every_mistake_is_one_sentence_at_its_key(case):
    text, *beginnings = case
    with pytest.raises(nh.CaseError) as caught:
        read(text)
    for said, place, beginning in zip(caught.value.mistakes, caught.value.places, beginnings, strict=True):
        about, unknown = said.removeprefix("Unknown key "), said.startswith("Unknown key ")
        assert about.startswith(place)
        assert beginning in (said if unknown else said[: len(beginning)])
        assert unknown or ": " in said


@pytest.mark.parametrize(
    ("text", "roller", "ring"),
    [
        (PLAIN, 1, "outer"),
        (TAPERED, 0, "inner"),
        (THRUST, 3, "inner"),
        (SPHERICAL, 18, "outer"),
    ],
)
def test_a_contact_of_a_bearing_is_a_case_of_its_own(tmp_path, text, roller, ring):
    found = BearingCase.of(tomllib.loads(text), Path("nu.toml"))
    loaded = found.solve()
    path, at = tmp_path / "contact.toml", (roller, ("inner", "outer").index(ring))
    found.contact_case(loaded, roller, ring).write(path)
    case = read_case(path)
    assert case.title.endswith(f"roller {roller + 1} on the {ring} ring")
    solution = case.solve()
    # The same solve of the same bodies, as a file holds them: all digits but the last ones of a rounding.
    assert solution.load == pytest.approx(loaded.load[at], rel=1e-9)
    assert solution.max_pressure == pytest.approx(loaded.max_pressure[at], rel=1e-9)
    # The balance of the bearing knew neither: to what its own strips are in error, 1e-4 of approach or load.
    assert solution.approach == pytest.approx(loaded.approach[at], rel=1e-4)
    arm = 0.5 * loaded.bearing.rows[0].bearing.roller_length
    assert solution.moment == pytest.approx(loaded.moment[at], abs=1e-4 * arm * loaded.load[at])


def test_a_contact_by_slices_says_so_and_one_without_load_is_refused():
    found = BearingCase.of(tomllib.loads(PLAIN), Path("nu.toml"))
    sliced = found.solve("slices")
    case = found.contact_case(sliced, 0)
    assert case.title == "nu, roller 1 on the inner ring, by slices"
    assert case.prescribed.keywords == {"load": sliced.load[0, 0], "tilt": sliced.tilt[0, 0]}
    assert case.path == Path("nu-1-inner.toml")
    with pytest.raises(nh.InputError, match="must be a roller that the outer ring loads: choose"):
        found.contact_case(sliced, 6, "outer")
