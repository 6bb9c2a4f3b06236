"""Arguments that public functions and methods take, by their names; what they need is solved here."""

import atexit
import shutil
import tempfile
import warnings
from pathlib import Path
from typing import Any

import numpy as np

import nonhertz as nh
from nonhertz import bearing, hertz, life, measured, profile
from nonhertz.files.contact_results import as_object
from nonhertz.files.results import key_by_key

EXAMPLE = Path(__file__).parents[2] / "examples" / "crowned-roller.toml"
BEARING = EXAMPLE.with_name("nu206.toml")
UPRIGHT = nh.read_case(EXAMPLE)
RING = nh.Ring(diameter=80)
ROLLER = nh.Roller(diameter=20, length=20, profile=nh.profile.crown(2000))
CONTACT = nh.Contact(ROLLER, RING)
with warnings.catch_warnings():  # as coarse as it may be: nothing is read off these
    warnings.simplefilter("ignore", nh.AccuracyWarning)
    SOLUTION = nh.solve(CONTACT, load=6e3, strips=5)
    PATCH = nh.patch.solve(CONTACT, load=6e3, cells=(12, 16))
    SHARP = nh.solve(nh.Contact(nh.Roller(diameter=20, length=20), nh.Plate()), load=2e4).edge_pressure[0]
    COMPARISON = nh.compare(CONTACT, load=6e3, cells=(12, 16), strips=11)
    MANY = nh.solve_many(CONTACT, load=[1e3, 2e3], strips=11)
    MAP = nh.contact_map(CONTACT, load=(0, 1e3), accuracy=0.1, checks=20)
    PALMGREN = life.lundberg_palmgren()
    LIFE = life.assess(SOLUTION, "iso-16281", body="b")[0]
    EXPOSURE = life.exposure(SOLUTION, body="b")
    DENT = nh.patch.Dent(depth=0.002, diameter=0.4)
    SHORT = nh.Contact(nh.Roller(diameter=20, length=20, profile=nh.profile.crown(60)), RING)
    COARSELY = {"solution": nh.solve(SHORT, load=1500, strips=5), "dent": nh.patch.Dent(depth=0.002, diameter=0.2)}
    COARSELY |= {"cell": 0.04, "reach": 0.5}
    OVERROLLED = life.overrolled(**COARSELY, body="b")
SWEPT = nh.sweep(nh.Case(CONTACT, {"load": 6e3}, {"strips": 11}), over={"load.load": [6e3]})
SLICED_CASE = nh.read_bearing(BEARING, {"solver.method": "slices"})
DIAGRAM = nh.study.diagram(SLICED_CASE, "clearance", "0 : 20 um : 2")
TOLERANCE = nh.tolerance(
    nh.Case(CONTACT, {"load": 6e3}, {"strips": 11}), over={"load.load": "uniform(6 kN, 7 kN)"}, samples=3
)
POINT = hertz.point_contact(load=1e3, radius_x=10.0, radius_y=100.0, compliance=2.8e-6)
LINE = hertz.line_contact(line_load=1e3, radius=10.0, compliance=2.8e-6)
ROW = bearing.CylindricalRollerBearing(
    roller=nh.Roller(diameter=9.0, length=10.0, profile=nh.profile.crown(1000)),
    inner=nh.Ring(diameter=37.5),
    outer=nh.Ring(diameter=-55.5),
    rollers=13,
)
BARRELS = bearing.SphericalRollerBearing(
    roller=nh.Roller(diameter=10.0, length=10.0),
    inner=nh.Ring(diameter=90.0),
    outer=nh.Ring(diameter=-110.4),
    rollers=14,
    contact_angle=0.2,
    profile_radius=53.0,
    inner_groove=55.0,
    outer_groove=55.0,
)
MOUNTING = bearing.Mounting(
    shaft=bearing.Shaft(diameter=30.0, interference=0.01), housing=bearing.Housing(diameter=62.0)
)
LOADED = bearing.solve(ROW, radial=3e3)
FORCES = bearing.table(ROW, y=[0.0, 0.01], method="slices", checks=1)
CONE = nh.Roller(diameter=nh.TabulatedDiameter((-5.0, 5.0), (9.4, 8.6)), length=10.0, profile=nh.profile.crown(1000))
RACEWAY = life.Raceway(10.0, 9.6, 65.0, True)
CASES = [life.ContactLoadCase(load=1e3, share=1.0)]
Y = np.linspace(-10.0, 10.0, 401)
TRACE = measured.Trace(Y, -(Y**2) / 4000.0)
MEASURED = measured.Measured(TRACE)
TABLE = profile.tabulated([-10.0, 0.0, 10.0], [0.01, 0.0, 0.01])


#: Files that are there until the tests end.
FOLDER = Path(tempfile.mkdtemp())
atexit.register(shutil.rmtree, FOLDER, ignore_errors=True)
MANY.save(FOLDER / "many.npz")
for _name, _text in {
    "plan.toml": f'case = "{EXAMPLE.as_posix()}"\n[over]\n"load.load" = ["1 kN"]\n',
    "profile.csv": "-1, 0\n1, 0\n",
    "result.json": key_by_key(as_object(SOLUTION, nh.Case(CONTACT, {"load": 6e3}))),
}.items():
    (FOLDER / _name).write_text(_text, encoding="utf-8")


STEEL = nh.MATERIALS["steel"]
THRUST = bearing.CylindricalThrustBearing(
    roller=ROW.roller, inner=nh.Plate(depth=4.0), outer=nh.Plate(depth=4.0), rollers=13, pitch_diameter=60.0
)
#: Of each class with methods that take arguments, something that has them.
INSTANCES = {
    "": [
        nh.BearingCase(ROW), COMPARISON, MAP, CONTACT, PATCH, ROLLER, nh.Plan(UPRIGHT), SHARP, SOLUTION, MANY,
        nh.Chamfer(1.0, 0.3), nh.TabulatedDiameter((-1.0, 1.0), (10.0, 12.0)),
    ],
    "bearing.": [
        ROW, BARRELS, bearing.Rib(100.0, 4.0), THRUST, FORCES, LOADED,
        MOUNTING, MOUNTING.operating(ROW), bearing.paired(ROW, "X", 20.0), bearing.seat_limits("k5", 30.0),
        ROW.kinematics(inner_speed=1e3), bearing.fourier_shape({2: 0.005}),
        bearing.solve_many(ROW, radial=[1e3], method="slices"),
    ],
    "hertz.": [POINT, LINE],
    "life.": [EXPOSURE, LIFE, OVERROLLED, RACEWAY],
    "profile.": [
        profile.crown(100), profile.conical(0.01), profile.straight(), profile.tapered_ends(5, 0.01),
        profile.iso_logarithmic(10, 20), profile.lundberg(1e3, 20.0, 10.0), TABLE,
        TABLE.shifted(1.0) + TABLE.scaled(2.0),
    ],
    "study.": [
        SWEPT, TOLERANCE, DIAGRAM, SOLUTION.gradient("load"), nh.study.Sampling(30, "saltelli"),
        nh.study.Distribution("uniform", (0.0, 1.0)),
    ],
}  # fmt: skip
#: What is taken by arguments of these names, in place of any default, so that nothing takes long.
GOOD: dict[str, Any] = {
    "a": ROLLER, "amplitude": 0.01, "angle": 0.01, "approach": 1e-3, "arrangement": "O", "at": 9.5, "b": RING,
    "bearing": ROW, "by": 1.0, "inner_speed": 1e3, "outer_speed": 0.0,
    "cases": CASES, "compliance": 2.8e-6, "contact": CONTACT, "contact_angle": 0.2,
    "contacts": CONTACT, "deviation": [0.0, 0.01, 0.0], "dent": DENT, "depth_exponent": 0.0, "diameter": 20.0,
    "dimensions": 2, "distance": 0.5, "drop": 0.02, "edge_stress": "none", "end_radius": 100.0, "exponent": 9.0,
    "fatigue_limit": 0.0, "height": 4.0, "housing": MOUNTING.housing, "inner": ROW.inner, "inner_groove": 31.0,
    "kind": "crown", "laminae": 30, "length": 20.0, "limit": 4e3, "material": STEEL, "line_load": 1e3,
    "line_loads": "solution", "load": 1e3, "load_rating": 5e4, "middle": 4.0,
    "model": PALMGREN, "modulus": 2e5, "name": "load", "number": 0,
    "numbers": (0.0, 1.0),
    "other": LIFE, "outer": ROW.outer, "outer_groove": 31.0, "points": TRACE, "poisson": 0.3,
    "profile_radius": 30.0, "radius": 500.0, "radius_x": 10.0, "radius_y": 100.0, "relative_limit": 0.3,
    "reliability": 0.95, "roller": ROW.roller, "roller_diameter": 10.0, "rollers": 13, "row": 0, "samples": 3,
    "share": 0.5, "probability": 0.5, "probabilities": 0.5,
    "shaft": MOUNTING.shaft, "slope": 1.0, "solution": SOLUTION, "source": "own", "speed": 1e3, "station": 0.0,
    "straight": 5.0, "stress": "shear", "strips": 11, "terms": {2: 0.005}, "threads": 1, "trace": TRACE,
    "viscosity_ratio": 1.0, "width": 1.0, "workers": 1, "x": 0.0, "y": 0.0, "z": 0.1,
}  # fmt: skip
SLICED = {"method": "slices"}
SPAN = {"y": [-1.0, 1.0]}
RADIUS = {"body.a.profile.radius": (1e3, 3e3)}
DESIGN = {"load": 1e3, "radius": 10.0}
GRID = {"x": [0.0], "z": [0.1]}
HEIGHTS = {"y": Y, "height": -(Y**2) / 4000.0}
#: What functions take otherwise.
OTHERWISE: dict[str, dict[str, Any]] = {
    "BearingCase.assess": {"solution": LOADED},
    "BearingCase.contact_case": {"solution": LOADED, "roller": 0},
    "BearingCase.solve": SLICED,
    "Case": {"prescribed": {"load": 1e3}},
    "Comparison.along": {"solution": COMPARISON.semi_elliptic},
    "ContactMap.at": {"tilt": 0.0},
    "ContactMap.grid": {"rows": 3, "tilts": 3},
    "ContactMap.strip_loads": {"point": MAP.under(load=500.0)},
    "study.Gradient.along": {"family": lambda value: CONTACT, "at": 1.0, "step": 0.1},
    "study.Gradient.by": {"name": "a.diameter"},
    "Plan": {"case": UPRIGHT, "samples": nh.study.Sampling()},
    "Plan.changed": {"samples": None},
    "Plan.read_spread": {"path": "load.load", "values": [1e3]},
    "Plate": {"diameter": None, "depth": 1.0},
    "Solution.gradient": {"quantity": "load"},
    "Solution.plot": {"what": "profile"},
    "Solutions.read": {"path": FOLDER / "many.npz"},
    "TabulatedDiameter": SPAN | {"diameter": (10.0, 12.0)},
    "bearing.BearingSolution.contact": {"roller": 0},
    "bearing.BearingSolution.place_of": {"roller": 0},
    "bearing.BearingSolution.plot": {"what": "relief"},
    "bearing.BearingSolution.rib_contact": {"roller": 0},
    "bearing.BearingSolution.unrolled_pressure": {"y": [0.0, 1.0]},
    "bearing.CylindricalThrustBearing": {"inner": THRUST.inner, "outer": THRUST.outer, "pitch_diameter": 60.0},
    "bearing.contamination_factor": {"pitch_diameter": 50.0, "cleanliness": "high"},
    "bearing.reference_viscosity": {"pitch_diameter": 50.0},
    "bearing.ForceTable.interpolated": {"x": None, "y": 0.005, "z": None, "kind": "linear"},
    "bearing.ForceTable.sampled_error": {"kind": "linear"},
    "bearing.Mounting.expansion": {"bearing": bearing.paired(ROW, "X", 20.0)},
    "bearing.Paired": {"bearings": (ROW,), "x": (0.0,), "turned": (False,)},
    "bearing.Shaft": {"diameter": 30.0},
    "bearing.TaperedRollerBearing": {
        "roller": CONE, "inner": nh.Ring(diameter=37.3), "outer": nh.Ring(diameter=-55.7)
    },
    "BearingCase.films": {"solution": LOADED},
    "BearingCase.friction": {"solution": LOADED},
    "BearingCase.limits": {"solution": LOADED},
    "BearingCase.verdict": {"solution": LOADED, "life": None},
    "BearingCase.tolerances": {"solution": LOADED, "life": None},
    "bearing.clearance_limits": {"group": "C3", "bore": 30.0, "kind": "cylindrical"},
    "bearing.ring_limits": {"ring": "inner", "size": 30.0, "tolerance_class": "Normal"},
    "bearing.seat_limits": {"fit": "k5", "size": 30.0},
    "bearing.films": {"speed": 1e3, "lubrication": bearing.Lubrication(viscosity=20.0), "solution": LOADED},
    "bearing.assess": {"solution": LOADED, "viscosity": 20.0, "cleanliness": "high", "edge_stress": None},
    "bearing.from_catalogue": {
        "kind": "cylindrical", "bore": 30.0, "outside_diameter": 62.0, "width": 16.0, "dynamic": 44e3, "static": 36.5e3,
        "contact_angle": None,
    },
    "bearing.maps": {"tilt": 1e-4, "accuracy": 0.1},
    "bearing.oil_viscosity": {"temperature": 70.0, "viscosities": (46.0, 6.8)},
    "bearing.paired": {"distance": 20.0},
    "bearing.pressure_safety": {"solution": LOADED},
    "bearing.shares_of_revolutions": {"times": [0.5, 0.5], "speeds": [1e3, 2e3]},
    "bearing.solve": SLICED | {"radial": 1e3},
    "bearing.solve_many": SLICED | {"radial": [1e3]},
    "bearing.solve_spectrum": SLICED | {"cases": [bearing.BearingLoadCase(share=1.0, radial=3e3)]},
    "bearing.table": SLICED | {"x": 0.0, "y": [0.0, 0.01], "z": 0.0, "checks": 1},
    "bearing.tabulated_shape": {"angle": [0.0, 1.0, 2.0], "curve": "linear"},
    "bearing.volume_life": {"solution": LOADED, "model": "zaretsky"},
    "compare": {"load": 6e3, "cells": (12, 16), "approach": None},
    "hertz.half_space_line_compression": {"contact": LINE},
    "hertz.plane_strain_cylinder_compression": {"contact": LINE},
    "hertz.point_contact": {"approach": None, "angle": 0.0},
    "life.LaminaModel": {"name": "own"},
    "life.Overrolled.excess": {"within": 0.2},
    "life.Raceway": {"length": 9.6, "pitch_diameter": 65.0, "inner": True},
    "life.assess": {"models": "iso-16281", "rollers": 10},
    "life.model": {"name": "weibull", "exponent": 9.0},
    "life.overrolled": COARSELY | {"body": "b"},
    "contact_map": {"load": (0.0, 1e3), "approach": None, "accuracy": 0.1, "stations": 5, "checks": 20},
    "measured.Points": HEIGHTS,
    "measured.Trace": HEIGHTS,
    "measured.fit_best": {"kinds": ["crown"]},
    "measured.Align": {"by": "ends", "slope": 0.05},
    "measured.prepare": {"slope": 0.05, "points": "auto"},
    "profile.from_file": {"path": FOLDER / "profile.csv"},
    "profile.fujiwara_kawase": DESIGN,
    "profile.johns_gohar": DESIGN,
    "profile.lundberg": DESIGN,
    "profile.tabulated": SPAN | {"relief": [0.0, 1.0]},
    "read_bearing": {"path": BEARING},
    "read_case": {"path": EXAMPLE},
    "read_plan": {"path": FOLDER / "plan.toml"},
    "read_result": {"path": FOLDER / "result.json"},
    "solve": {"approach": None},
    "solve_many": {"load": [6e3], "approach": None},
    "study.Distribution": {"kind": "normal"},
    "study.Sweep.__getitem__": {"name": "load.load"},
    "study.Sweep.extremes": {"name": "approach"},
    "study.Sweep.unit": {"name": "approach"},
    "study.PowerIntegral": {"pressure_power": 4.5},
    "study.Sampling": {"method": "sobol"},
    "subsurface.axial_plane": {"x": 0.0, "y": [0.0], "z": [0.1]},
    "subsurface.cross_section": GRID,
    "subsurface.memory": {"points": 10},
    "subsurface.volume": GRID | {"y": [0.0]},
    "study.diagram": {"case": SLICED_CASE, "over": "clearance", "values": "0 : 20 um : 2"},
    "sweep": {"plan": nh.Plan(UPRIGHT, over={"load.load": [1e3]}), "samples": None},
    "optimize": {"case": UPRIGHT, "bounds": RADIUS, "n_starts": 1},
    "pareto": {"case": UPRIGHT, "bounds": RADIUS, "n_starts": 1, "first": CASES, "second": CASES, "points": 3},
    "tolerance": {"plan": UPRIGHT, "over": {"load.load": "uniform(1 kN, 2 kN)"}},
}  # fmt: skip
