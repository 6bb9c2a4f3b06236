"""Operating clearance: thick rings against closed forms, numerical solutions and published examples."""

import dataclasses
import math

import numpy as np
import pytest
from crowned_rows import row
from scipy.integrate import solve_bvp

import nonhertz as nh
from nonhertz.bearing.thick_rings import ThickRing
from nonhertz.files.bearing_results import as_object
from nonhertz.model.materials import STEEL_EXPANSION as EXPANSION
from nonhertz.show.bearing import summary_rows

STEEL = nh.Material(modulus=207e3, poisson=0.3)
IRON = nh.Material(modulus=110e3, poisson=0.26)
DENSITY = 7.85e-9
ROW = row(clearance=0.0325, radius=4000.0, ends={})
CONE = nh.Roller(diameter=nh.TabulatedDiameter((-5.0, 5.0), (9.4, 8.6)), length=10.0, profile=nh.profile.crown(4000))
TAPER = nh.bearing.TaperedRollerBearing(
    roller=CONE, inner=nh.Ring(diameter=37.3), outer=nh.Ring(diameter=-55.7), rollers=13, contact_angle=0.2
)
# Parts at rest in the cold, beside rings that are warm where a test says so.
SHAFT, HOUSING = nh.bearing.Shaft(diameter=30.0, temperature=20.0), nh.bearing.Housing(diameter=62.0, temperature=20.0)


def found(bearing=ROW, *, shaft=SHAFT, housing=HOUSING, speed=0.0, **temperatures):
    temperatures = {"roller_temperature": 20.0} | temperatures
    return nh.bearing.Mounting(shaft=shaft, housing=housing, **temperatures).operating(bearing, speed)


def on_shaft(interference, **changes):
    return nh.bearing.Shaft(diameter=30.0, interference=interference, **({"temperature": 20.0} | changes))


def test_a_bearing_that_is_as_warm_everywhere_keeps_its_clearance():
    # It grows as a whole: the clearance, zero by its diameters, stays zero. Cones that meet in a point, with an outer
    # angle of 30 degrees and half of it at the apex of the rollers of 5 degrees.
    outer, half, apex = math.radians(30.0), math.radians(5.0), 60.0
    pitch, axis = 2.0 * apex * math.sin(outer - half), math.tan(outer - half)
    ends = [2.0 * (apex + y) * math.tan(half) for y in (7.0, -7.0)]
    cone = nh.Roller(diameter=nh.TabulatedDiameter((-7.0, 7.0), ends), length=14.0)
    sizes = [pitch * math.tan(angle) / axis for angle in (outer - 2.0 * half, outer)]
    tapered = nh.bearing.TaperedRollerBearing(
        roller=cone, inner=nh.Ring(diameter=sizes[0]), outer=nh.Ring(diameter=-sizes[1]), rollers=10,
        contact_angle=outer, pitch_diameter=pitch, bore=20.0, outside_diameter=100.0,
    )  # fmt: skip
    seats = {"shaft": nh.bearing.Shaft(), "housing": nh.bearing.Housing()}
    warm = nh.bearing.Mounting(**seats, inner_temperature=80, outer_temperature=80)
    assert warm.operating(tapered).lost_to_temperatures == pytest.approx(0.0, abs=1e-12)


# Rings by themselves
@pytest.mark.parametrize(
    "loads",
    [{"inside": 40.0}, {"outside": 25.0}, {"speed": 3000.0}, {"inside": 10.0, "outside": 30.0, "speed": 2000.0}],
)
def test_a_ring_solves_its_differential_equation(loads):
    # u'' + u' / r - u / r^2 = -(1 - nu^2) / E rho omega^2 r with the stresses of plane stress at both faces.
    inner, outer, nu = 15.0, 27.0, IRON.poisson
    plate = IRON.modulus / (1.0 - nu**2)
    body = DENSITY * loads.get("speed", 0.0) ** 2

    def slopes(r, y):
        return np.vstack([y[1], -y[1] / r + y[0] / r**2 - body * r / plate])

    def faces(low, high):
        at_low = plate * (low[1] + nu * low[0] / inner) + loads.get("inside", 0.0)
        at_high = plate * (high[1] + nu * high[0] / outer) + loads.get("outside", 0.0)
        return np.array([at_low, at_high]) / plate

    r = np.linspace(inner, outer, 41)
    solved = solve_bvp(slopes, faces, r, np.zeros((2, r.size)), tol=1e-9)
    ring = ThickRing(inner, outer, IRON, DENSITY)
    for radius in (inner, 20.0, outer):
        u, slope = solved.sol(radius)
        assert ring.growth(radius, **loads) == pytest.approx(u, rel=1e-6)
        hoop = plate * (u / radius + nu * slope)
        assert ring.hoop_stress(radius, **loads) == pytest.approx(hoop, rel=1e-6)
        assert ring.radial_stress(radius, **loads) == pytest.approx(plate * (slope + nu * u / radius), abs=1e-5)


def test_a_thin_ring_is_a_hoop():
    # p r^2 / (E t) and rho omega^2 r^3 / E, to the thickness over the radius.
    ring = ThickRing(99.99, 100.01, STEEL, DENSITY)
    assert ring.growth(100.0, inside=0.1) == pytest.approx(0.1 * 100.0**2 / (207e3 * 0.02), rel=1e-3)
    assert ring.growth(100.0, speed=500.0) == pytest.approx(DENSITY * 500.0**2 * 100.0**3 / 207e3, rel=1e-3)
    assert ring.hoop_stress(100.0, speed=500.0) == pytest.approx(DENSITY * (500.0 * 100.0) ** 2, rel=1e-3)


def test_a_disc_and_a_hole_in_a_plate():
    # -(1 - nu) b q / E under pressure all around, and (1 + nu) a p / E (Lame).
    disc = ThickRing(0.0, 15.0, STEEL, DENSITY)
    assert disc.growth(15.0, outside=20.0) == pytest.approx(-0.7 * 15.0 * 20.0 / 207e3)
    assert disc.hoop_stress(7.0, outside=20.0) == disc.radial_stress(3.0, outside=20.0) == -20.0
    assert disc.growth(15.0, speed=3000.0) == pytest.approx(0.7 * DENSITY * 3000.0**2 * 15.0**3 / (4.0 * 207e3))
    plate = ThickRing(31.0, math.inf, STEEL, DENSITY)
    assert plate.growth(31.0, inside=20.0) == pytest.approx(1.3 * 31.0 * 20.0 / 207e3)
    assert plate.growth(31.0, inside=20.0) == pytest.approx(
        ThickRing(31.0, 31e4, STEEL, DENSITY).growth(31.0, inside=20.0), rel=1e-7
    )


def test_a_textbook_disc_on_a_shaft():
    # A steel disc of 0.1 and 0.5 m that comes loose at 6900/min; E = 200 GPa, nu = 0.3, 7.8 t/m^3 (an exercise in
    # many collections). Its published answers, to three figures: 52.6 um on the radius, 109.2 MPa at rest and 212 MPa
    # turning. The first was rounded on the way: 52.5 um are exact.
    steel = nh.Material(modulus=200e3, poisson=0.3)
    disc, shaft = ThickRing(50.0, 250.0, steel, 7.8e-9), ThickRing(0.0, 50.0, steel, 7.8e-9)
    speed = 6900.0 * math.pi / 30.0
    allowance = disc.growth(50.0, speed=speed) - shaft.growth(50.0, speed=speed)
    assert 1e3 * allowance == pytest.approx(52.6, abs=0.15)
    pressure = allowance / (disc.growth(50.0, inside=1.0) - shaft.growth(50.0, outside=1.0))
    assert disc.hoop_stress(50.0, inside=pressure) == pytest.approx(109.2, abs=0.05)
    assert disc.hoop_stress(50.0, speed=speed) == pytest.approx(212.0, abs=0.5)


# Fits
def test_fits_of_one_steel_are_those_of_bearing_makers():
    # NSK's technical report (recalled): k (1 - k0^2) / (1 - k^2 k0^2) of the interference reaches the raceway.
    k, k0, h, h0 = 30.0 / 37.5, 12.0 / 30.0, 55.5 / 62.0, 62.0 / 90.0
    housing = nh.bearing.Housing(diameter=62.0, interference=0.008, outside_diameter=90.0)
    fitted = found(shaft=on_shaft(0.015, bore=12.0), housing=housing)
    assert fitted.lost_to_inner_fit == pytest.approx(0.015 * k * (1.0 - k0**2) / (1.0 - (k * k0) ** 2))
    assert fitted.lost_to_outer_fit == pytest.approx(0.008 * h * (1.0 - h0**2) / (1.0 - (h * h0) ** 2))
    assert fitted.clearance == pytest.approx(0.0325 - fitted.lost_to_inner_fit - fitted.lost_to_outer_fit)
    # On a solid shaft the pressure is I E / (2 d) (1 - k^2), and the hoop stress at the bore p (1 + k^2) / (1 - k^2).
    solid = found(shaft=on_shaft(0.015))
    pressure = 0.015 * 207e3 / 60.0 * (1.0 - k**2)
    assert solid.inner.pressure == solid.inner.mounted_pressure == pytest.approx(pressure)
    assert solid.inner.seat_stress == pytest.approx(pressure * (1.0 + k**2) / (1.0 - k**2))
    assert solid.inner.raceway_stress == pytest.approx(pressure * 2.0 * k**2 / (1.0 - k**2))


def test_a_ring_on_a_hollow_shaft_needs_more_interference():
    # SKF's example of a 6208 on a hollow shaft: c_i = 0.8 and c_e = 0.77 ask for 1.7 times as much (the factor is read
    # off a diagram, to two figures, and recalled).
    row = nh.bearing.CylindricalRollerBearing(
        roller=nh.Roller(diameter=8.0, length=8.0, profile=nh.profile.crown(4000)),
        inner=nh.Ring(diameter=40.0 / 0.77), outer=nh.Ring(diameter=-(40.0 / 0.77 + 16.0)), rollers=15,
    )  # fmt: skip
    housing = nh.bearing.Housing(diameter=80.0)
    solid, hollow = (
        found(row, shaft=nh.bearing.Shaft(diameter=40.0, interference=0.01, bore=bore), housing=housing).inner.pressure
        for bore in (0.0, 32.0)
    )
    assert solid / hollow == pytest.approx(1.7, abs=0.05)


def test_roughness_takes_from_an_interference_alone():
    assert found(shaft=on_shaft(0.012, smoothing=0.002)).lost_to_inner_fit == pytest.approx(
        found(shaft=on_shaft(0.01)).lost_to_inner_fit
    )
    assert found(shaft=on_shaft(0.001, smoothing=0.002)).inner.pressure == 0.0
    # A loose fit that closes by heat is as loose at first with or without roughness.
    loose = [found(shaft=on_shaft(-0.001, smoothing=each, temperature=60.0)).inner.pressure for each in (0.0, 0.002)]
    assert loose[0] == loose[1] > 0.0


def raceway_by_finite_elements(radii, materials, strains, interference, speed):
    """Return by how much the outermost radius of a ring on a hollow shaft grows, from least energy.

    Linear elements along the radius share the node at the seat, where the ring is moved by half of the interference
    more than the shaft.
    """
    count = 400
    inner, seat, outer = radii
    nodes = np.concatenate([np.linspace(inner, seat, count + 1), np.linspace(seat, outer, count + 1)[1:]])
    stiffness, force = np.zeros((nodes.size, nodes.size)), np.zeros(nodes.size)
    for k in range(2 * count):
        material, strain = materials[k // count], strains[k // count]
        middle, length = 0.5 * (nodes[k] + nodes[k + 1]), nodes[k + 1] - nodes[k]
        strained = np.array([[-1.0 / length, 1.0 / length], [0.5 / middle, 0.5 / middle]])
        nu = material.poisson
        law = material.modulus / (1.0 - nu**2) * np.array([[1.0, nu], [nu, 1.0]]) * middle * length
        element = strained.T @ law @ strained
        moved_by_fit = np.array([0.5 * interference, 0.0]) if k == count else np.zeros(2)
        stiffness[k : k + 2, k : k + 2] += element
        force[k : k + 2] += strained.T @ law @ np.full(2, strain) - element @ moved_by_fit
        force[k : k + 2] += 0.5 * DENSITY * speed**2 * middle**2 * length
    return float(np.linalg.solve(stiffness, force)[-1])


def test_a_warm_and_turning_fit_is_that_of_least_energy():
    hot, fast = {"expansion": 11e-6, "temperature": 70.0}, 20000.0
    fitted = found(
        shaft=on_shaft(0.02, bore=12.0, material=IRON, density=7.85e-9, **hot),
        inner_temperature=80.0,
        ring_expansion=12e-6,
        speed=fast,
    )
    assert fitted.inner.pressure > 1.0
    strains = 11e-6 * 50.0, 12e-6 * 60.0
    grown = raceway_by_finite_elements((6.0, 15.0, 18.75), (IRON, STEEL), strains, 0.02, fast * math.pi / 30.0)
    # 400 elements a part: errors of their square.
    assert fitted.unmounted - fitted.clearance == pytest.approx(2.0 * grown, rel=1e-6)


def test_losses_are_those_of_mounting_then_of_heat_then_of_speed():
    shaft = on_shaft(0.015, temperature=60.0)
    warm = {"inner_temperature": 70.0, "roller_temperature": 65.0, "outer_temperature": 50.0}
    mounted, warmed, turning = (
        found(shaft=on_shaft(0.015)),
        found(shaft=shaft, **warm),
        found(shaft=shaft, **warm, speed=3e4),
    )
    assert mounted.lost_to_inner_fit == warmed.lost_to_inner_fit == turning.lost_to_inner_fit
    assert warmed.clearance == pytest.approx(mounted.clearance - warmed.lost_to_temperatures)
    assert turning.clearance == pytest.approx(warmed.clearance - turning.lost_to_speed)
    assert turning.lost_to_speed > 0.0


def test_one_temperature_everywhere_takes_nothing_but_its_share_of_the_clearance():
    hot = {f"{name}_temperature": 120.0 for name in ("inner", "roller", "outer")}
    loose = found(
        housing=dataclasses.replace(HOUSING, temperature=120.0), shaft=on_shaft(0.0, temperature=120.0), **hot
    )
    # E - F - 2 D_w, which is 0 by the diameters of the example: what is left is rounding.
    assert loose.lost_to_temperatures == pytest.approx(0.0, abs=1e-12)
    tight = found(
        housing=dataclasses.replace(HOUSING, temperature=120.0, interference=0.01),
        shaft=on_shaft(0.01, temperature=120.0),
        **hot,
    )
    assert tight.inner.pressure == pytest.approx(tight.inner.mounted_pressure)


@pytest.mark.parametrize(("inner", "outer"), [(75.0, 60.0), (40.0, 55.0), (-20.0, -20.0)])
def test_parts_without_a_temperature_have_that_of_what_they_touch(inner, outer):
    shaft, housing = (
        nh.bearing.Shaft(diameter=30.0, interference=0.012),
        nh.bearing.Housing(diameter=62.0, interference=-0.01),
    )
    left = nh.bearing.Mounting(shaft=shaft, housing=housing, inner_temperature=inner, outer_temperature=outer)
    left_out = left.operating(ROW)
    # The fit of one steel at one temperature keeps its pressure, but for what the seat grows.
    assert left_out.inner.pressure == pytest.approx(left_out.inner.mounted_pressure, rel=5e-3)
    assert left_out.inner.temperature_step == left_out.outer.temperature_step == 0.0
    # alpha (T_i F + 2 T_w D_w - T_o E): rings and rollers by themselves.
    by_hand = (inner - 20.0) * 37.5 + (0.5 * (inner + outer) - 20.0) * 18.0 - (outer - 20.0) * 55.5
    assert left_out.lost_to_temperatures == pytest.approx(EXPANSION * by_hand, abs=1e-5)
    same = found(
        shaft=dataclasses.replace(shaft, temperature=inner),
        housing=dataclasses.replace(housing, temperature=outer),
        inner_temperature=inner, roller_temperature=0.5 * (inner + outer), outer_temperature=outer,
    )  # fmt: skip
    assert left_out == same
    assert left_out.findings == ()


@pytest.mark.parametrize("degrees", [49.0, 51.0, -11.0])
def test_a_step_of_temperature_across_an_interference_fit_is_doubted(degrees):
    warm, doubtful = {"inner_temperature": degrees, "outer_temperature": degrees}, abs(degrees - 20.0) > 30.0
    tight = {"shaft": on_shaft(0.02), "housing": dataclasses.replace(HOUSING, interference=0.02)}
    way = "warmer" if degrees > 20.0 else "colder"
    doubted = found(**tight, **warm)
    assert [each.kind for each in doubted.findings] == ["temperature-step"] * (2 * doubtful)
    if doubtful:
        step = f"{abs(degrees - 20.0):.3g} K {way}"
        assert doubted.warnings[0].startswith(f"The inner ring is {step} than the shaft it is pressed together with")
        assert doubted.warnings[1].startswith(f"The outer ring is {step} than the housing it is pressed together with")
        assert doubted.warnings[0] in repr(doubted)
    # A loose fit transmits no heat.
    loose = {"shaft": on_shaft(-0.02), "housing": dataclasses.replace(HOUSING, interference=-0.02)}
    assert found(**loose, **warm).findings == ()


def test_a_warmer_inside_takes_what_a_makers_formula_says():
    # IKO's catalogue of needle roller bearings, formula 29: alpha Delta t E, with rollers and inner ring as one.
    loose = {"shaft": on_shaft(-0.05), "housing": dataclasses.replace(HOUSING, interference=-0.05)}
    taken = found(**loose, inner_temperature=30.0, roller_temperature=30.0).lost_to_temperatures
    assert taken == pytest.approx(12.5e-6 * 10.0 * 55.5)


def test_a_ring_comes_loose_at_its_speed_and_is_free_from_there_on():
    # With one steel, the ring outgrows a solid shaft on the radius by rho omega^2 a b^2 (3 + nu) / (4 E).
    interference, a, b = 0.004, 15.0, 18.75
    speed = math.sqrt(0.5 * interference * 4.0 * 207e3 / (DENSITY * a * b**2 * 3.3)) * 30.0 / math.pi
    at_rest = found(shaft=on_shaft(interference))
    assert at_rest.inner.loosening_speed == pytest.approx(speed)
    below, above = (found(shaft=on_shaft(interference), speed=share * speed) for share in (0.999, 1.001))
    assert 0.0 < below.inner.pressure < 0.003 * at_rest.inner.pressure
    assert not below.inner.loosened
    assert above.inner.loosened
    assert above.inner.pressure == 0.0
    far = found(shaft=on_shaft(interference), speed=2.0 * speed)
    omega = 2.0 * speed * math.pi / 30.0
    free = 2.0 * DENSITY * omega**2 * b / (4.0 * 207e3) * (3.3 * a**2 + 0.7 * b**2)
    assert far.lost_to_inner_fit + far.lost_to_speed == pytest.approx(free)
    bore = DENSITY * omega**2 / 4.0 * (3.3 * b**2 + 0.7 * a**2)
    assert far.inner.seat_stress == pytest.approx(bore)


def test_a_fit_comes_loose_by_heat_and_a_loose_one_closes():
    cold = found(shaft=on_shaft(0.005), inner_temperature=80.0)
    assert cold.inner.loosened
    assert cold.inner.loosening_speed == 0.0
    # The ring by itself: 60 K of its raceway's diameter, of which the fit had 4 um.
    assert cold.lost_to_inner_fit + cold.lost_to_temperatures == pytest.approx(EXPANSION * 60.0 * 37.5)
    aluminium = nh.bearing.Housing(
        diameter=62.0, interference=0.01, outside_diameter=90.0, material=nh.MATERIALS["aluminium"], expansion=23e-6,
        temperature=80.0,
    )  # fmt: skip
    assert found(housing=aluminium, outer_temperature=80.0).outer.loosened
    closed = found(shaft=on_shaft(-0.005, temperature=80.0))
    assert closed.inner.mounted_pressure == 0.0 < closed.inner.pressure
    assert closed.lost_to_inner_fit == 0.0


def test_a_warmer_bearing_in_a_cold_housing_is_pressed():
    # Outer ring 30 K warmer than a steel housing without end: the interference is alpha Delta t D.
    pressed = found(outer_temperature=50.0).outer
    mounted = found(housing=dataclasses.replace(HOUSING, interference=EXPANSION * 30.0 * 62.0)).outer
    assert pressed.pressure == pytest.approx(mounted.pressure)
    assert pressed.seat_stress < pressed.raceway_stress * 0.5 < 0.0
    assert pressed.loosening_speed == math.inf


# Bearings in operation
def test_a_tapered_row_closes_by_as_much_as_its_raceways_grow():
    fitted = found(TAPER, shaft=on_shaft(0.015))
    row = dataclasses.replace(TAPER, clearance=fitted.axial(TAPER.contact_angle))
    assert fitted.unmounted == 0.0
    # What both contacts are short of touching: along the normal, half of the diameter's growth times cos(alpha).
    assert 2.0 * row.gap == pytest.approx(-0.5 * fitted.lost_to_inner_fit * math.cos(0.2))
    open_row = dataclasses.replace(TAPER, clearance=0.03)
    assert found(open_row).axial(0.2) == pytest.approx(0.03)


def test_rollers_of_a_tapered_row_take_what_cones_around_them_would_grow():
    # The raceways touch the rollers on cones through the apex of these; both radii are on the line through the middle.
    taken = found(TAPER, roller_temperature=60.0).lost_to_temperatures
    half = math.atan(0.04)
    along = 4.5 / math.tan(half) * math.cos(0.2 - half)  # of the bearing's axis, from the apex to the middle
    across = 2.0 * along * (math.tan(0.2) - math.tan(0.2 - 2.0 * half))
    assert taken == pytest.approx(across * EXPANSION * 40.0)


def test_it_prints_in_um():
    said = repr(found(shaft=on_shaft(0.005), speed=1e5))
    # The raceway of the free ring grows by 38.54 um.
    assert "radial clearance -6.043 µm of 32.50 µm unmounted" in said
    assert "loosened" in said


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: on_shaft(0.01, expansion=12.5), "expansion = 12.5 must not exceed 0.001 per kelvin"),
        (lambda: on_shaft(0.01, temperature=-300.0), "temperature = -300.0 must lie between -273.15 and 1000 degC"),
        (
            lambda: nh.bearing.Housing(diameter=62.0, outside_diameter=60.0),
            "outside_diameter = 60.0 must exceed the diameter ",
        ),
        (lambda: found(ROW.roller), "must be a radial roller bearing"),
        (lambda: nh.bearing.Mounting(shaft=on_shaft(0.01)), "housing must be given: give a class such as 'H7'"),
        (lambda: found(shaft=nh.bearing.Shaft()), "shaft.diameter must be given where the bearing has no bore"),
        (lambda: found().axial(2.0), "contact_angle = 2.0 must be less than a right angle"),
    ],
)
def test_what_cannot_be_ends_in_a_sentence(make, message):
    with pytest.raises(nh.InputError) as raised:
        make()
    assert message in str(raised.value)


@pytest.mark.parametrize(("arrangement", "given"), [("O", 7.5), ("X", -7.5), ("tandem", 0.0)])
def test_warm_inner_rings_move_the_rows_of_a_pair_apart(arrangement, given):
    """12.5e-6 / K * 15 K * 40 mm. The ring moves by half of it more or less before a row of an O or X pair holds it."""
    cone = nh.Roller(diameter=nh.TabulatedDiameter((-6, 6), (11, 10)), length=12.0, profile=nh.profile.crown(2000))
    rings = {"inner": nh.Ring(diameter=41.0), "outer": nh.Ring(diameter=-62.5)}
    row = nh.bearing.TaperedRollerBearing(roller=cone, **rings, rollers=14, contact_angle=0.2)
    pair = nh.bearing.paired(row, arrangement, 40.0, clearance=0.1)
    fit = {"shaft": nh.bearing.Shaft(diameter=30.0), "housing": nh.bearing.Housing(diameter=72.0)}
    apart, even = (
        nh.BearingCase(pair, {"axial": 1e3}, fit=fit | {"inner_temperature": inner, "outer_temperature": 45.0})
        for inner in (60.0, 45.0)
    )
    assert 1e3 * (apart.mounted.clearance - even.mounted.clearance) == pytest.approx(given)
    assert 1e3 * as_object(apart.solve("slices"), apart, None, "")["operating_clearance"]["expansion"] == (
        pytest.approx(given)
    )
    said = {remark: value for _, value, remark in summary_rows(apart, apart.solve("slices"))}
    assert float(said["increase by temperatures between the rows"].split()[0]) == pytest.approx(given)


def test_parts_of_other_materials_are_not_taken_for_steel():
    aluminium, other = nh.MATERIALS["aluminium"], nh.Material(72e3, 0.3)
    light = nh.bearing.Housing(diameter=62.0, outside_diameter=90.0, material=aluminium)
    seats = {"shaft": on_shaft(0.0), "housing": light}
    assert found(**seats).lost_to_temperatures == 0.0
    warm = dataclasses.replace(light, temperature=70.0, interference=EXPANSION * 50.0 * 62.0)
    with pytest.raises(
        nh.InputError, match=r"housing\.expansion must be given for a part of 72000 MPa at 70 degC, of which"
    ):
        found(**seats | {"housing": dataclasses.replace(warm, material=other)})
    # That of the library is that of the material: 23e-6 (EN 1999-1-1).
    assert found(**seats | {"housing": warm}) == found(
        **seats | {"housing": dataclasses.replace(warm, expansion=23e-6)}
    )
    # The density of the library is that of the material.
    hollow = {"interference": -0.01, "bore": 12.0, "material": aluminium}
    known, given = (
        found(**seats | {"shaft": on_shaft(**hollow, **more)}, speed=2e4) for more in ({}, {"density": 2.7e-9})
    )
    assert known == given
    with pytest.raises(nh.InputError, match=r"shaft\.density must be given for a turning part of 90000 MPa"):
        found(**seats | {"shaft": on_shaft(0.0, material=nh.Material(9e4, 0.3))}, speed=2e4)
