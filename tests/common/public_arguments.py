"""Every public function and method with arguments that it takes and the sort of each; what they need is solved here."""

from __future__ import annotations

import atexit
import shutil
import tempfile
import warnings
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

import nonhertz as nh
from nonhertz import bearing, hertz, life, measured, profile, strength, subsurface
from nonhertz.files.results import as_object, key_by_key
from nonhertz.files.sections import Life
from nonhertz.files.title_block import TitleBlock

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
    MAP = nh.map(CONTACT, load=(0, 1e3), accuracy=0.1, checks=20)
    PALMGREN = life.lundberg_palmgren()
    LIFE = life.assess(SOLUTION, "iso-16281", body="b")[0]
    EXPOSURE = life.exposure(SOLUTION, body="b")
    DENT = nh.patch.Dent(depth=0.002, diameter=0.4)
    COARSELY = {"cell": 0.05, "station": 1.0, "reach": 0.5}
    OVERROLLED = life.overrolled(SOLUTION, DENT, **COARSELY)
SWEPT = nh.sweep(nh.Case(CONTACT, {"load": 6e3}, {"strips": 11}), over={"load.load": [6e3]})
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
CASES = [life.LoadCase(load=1e3, share=1.0)]
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


@dataclass(frozen=True)
class Entry:
    """A function with arguments that it takes, and the sort of each."""

    call: Callable[..., Any]
    good: dict[str, Any]
    sorts: dict[str, str]
    raises: tuple[type[Exception], ...] = ()


def entry(call: Callable[..., Any], *, raises: tuple[type[Exception], ...] = (), **arguments: tuple[Any, str]) -> Entry:
    return Entry(
        call,
        {name: good for name, (good, _) in arguments.items()},
        {name: sort for name, (_, sort) in arguments.items()},
        raises,
    )


STEEL = nh.MATERIALS["steel"]
RUNNING = {"threads": (1, "whole?"), "announce": (None, "function?")}
WITHIN = {"solution": (SOLUTION, "thing"), "body": ("a", "word"), **RUNNING}
STRESS = {**WITHIN, "displacement": (False, "flag")}
BODY = {
    "material": (STEEL, "thing"),
    "diameter": (20.0, "diameter"),
    "bore": (None, "optional"),
    "length": (20.0, "positive?"),
    "profile": (nh.profile.crown(100.0), "thing"),
    "effective_length": (10.0, "positive?"),
    "corner_radius": (None, "positive?"),
    "chamfer": (None, "optional"),
    "position": (0.0, "number"),
    "side_faces": ("mirror", "rule"),
    "images": (1, "images"),
    "depth": ("none", "depth"),
    "case_depth": (None, "positive?"),
}
PRESCRIBED = {
    "approach": (None, "number?"),
    "load": (6e3, "load"),
    "tilt": (0.0, "number?"),
    "moment": (None, "number?"),
}
DESIGN = {
    "load": (1e3, "positive"),
    "length": (20.0, "positive"),
    "radius": (10.0, "positive"),
    "compliance": (2.8e-6, "positive?"),
}
PARTS = {
    "roller": (ROW.roller, "thing"),
    "inner": (ROW.inner, "thing"),
    "outer": (ROW.outer, "thing"),
    "rollers": (13, "whole"),
    "pitch_diameter": (None, "positive?"),
    "inner_shape": (None, "optional"),
    "outer_shape": (None, "optional"),
    "density": (None, "positive?"),
}
TAPER = PARTS | {
    "roller": (CONE, "thing"), "inner": (nh.Ring(diameter=37.3), "thing"), "outer": (nh.Ring(diameter=-55.7), "thing")
}  # fmt: skip
FIT = {"shift": (True, "flag"), "tilt": (False, "flag")}

RIBBED = {
    "clearance": (0.0, "number"),
    "design": ("NJ", "word"),
    "rib": (None, "optional"),
    "axial_clearance": (0.0, "not negative"),
}
ENTRIES: dict[str, Entry] = {
    "Chamfer": entry(nh.Chamfer, length=(1.0, "positive"), angle=(0.3, "angle"), blend_radius=(0.0, "not negative")),
    "Chamfer.drop": entry(nh.Chamfer(1.0, 0.3).drop, distance=(0.5, "numbers")),
    "solve": entry(
        nh.solve, contact=(CONTACT, "thing"), **PRESCRIBED, element=(nh.SEMI_ELLIPTIC, "thing"), strips=(11, "strips"),
        accuracy=(None, "optional"),
    ),
    "solve_many": entry(
        nh.solve_many, contacts=(CONTACT, "several"), approach=(None, "many?"), load=([6e3], "many"),
        tilt=(0.0, "many?"), moment=(None, "many?"), element=(nh.SEMI_ELLIPTIC, "thing"), strips=(11, "strips"),
        accuracy=(None, "optional"), **RUNNING,
    ),
    "Solutions.read": entry(nh.Solutions.read, path=(FOLDER / "many.npz", "file"), contacts=(CONTACT, "several")),
    "Solutions.line_load": entry(MANY.line_load, number=(0, "index"), raises=(IndexError,)),
    "map": entry(
        nh.map, contact=(CONTACT, "thing"), load=((0.0, 1e3), "all"), approach=(None, "optional"), tilt=(0.0, "tilts"),
        accuracy=(0.1, "all"), element=(nh.SEMI_ELLIPTIC, "thing"), stations=(5, "stations"), checks=(20, "all"),
        **RUNNING,
    ),
    "ContactMap.at": entry(MAP.at, approach=(1e-3, "numbers"), tilt=(0.0, "numbers")),
    "ContactMap.under": entry(MAP.under, load=(500.0, "numbers"), tilt=(0.0, "numbers")),
    "ContactMap.strip_loads": entry(MAP.strip_loads, point=(MAP.under(load=500.0), "thing"), stations=(None, "row?")),
    "ContactMap.grid": entry(MAP.grid, rows=(3, "whole"), tilts=(3, "whole")),
    "ContactMap.csv": entry(MAP.csv, point=(None, "optional")),
    "Solutions.__getitem__": entry(MANY.__getitem__, number=(0, "index"), raises=(IndexError,)),
    "read_case": entry(nh.read_case, path=(EXAMPLE, "file"), changes=({}, "given options"), raises=(nh.CaseError,)),
    "read_bearing": entry(
        nh.read_bearing, path=(BEARING, "file"), changes=({}, "given options"), raises=(nh.CaseError,),
    ),
    "BearingCase": entry(
        nh.BearingCase, bearing=(ROW, "thing"), prescribed=({}, "options"), solver=({}, "options"),
        life=({}, "options"), spectrum=((), "thing"), fit=({}, "options"), title=("one", "name"),
        path=(Path("bearing.toml"), "thing"), title_block=(TitleBlock(), "thing"),
    ),
    "BearingCase.solve": entry(
        nh.BearingCase(ROW).solve, method=("slices", "optional"), interpolated=(False, "flag"),
        raises=(nh.CaseError,),
    ),
    "BearingCase.assess": entry(nh.BearingCase(ROW).assess, solution=(LOADED, "thing")),
    "BearingCase.contact_case": entry(
        nh.BearingCase(ROW).contact_case, solution=(LOADED, "thing"), roller=(0, "count"), ring=("inner", "word"),
    ),
    "read_result": entry(nh.read_result, path=(FOLDER / "result.json", "file")),
    "Case": entry(
        nh.Case, contact=(CONTACT, "thing"), prescribed=({"load": 1e3}, "thing"), solver=({"strips": 11}, "options"),
        life=(Life(), "thing"), title=("one", "name"), path=(Path("case.toml"), "thing"),
        title_block=(TitleBlock(), "thing"),
    ),
    "Solution.pressure": entry(SOLUTION.pressure, x=(0.0, "numbers"), y=([0.0, 1.0], "numbers")),
    "Solution.plot": entry(SOLUTION.plot, what=("profile", "word"), ax=(None, "optional")),
    "Solution.at_nodes": entry(SOLUTION.at_nodes, x=(0.0, "numbers"), y=([0.0, 1.0], "numbers")),
    "Solution.gradient": entry(SOLUTION.gradient, quantity=("load", "word"), holding=(("load", "tilt"), "all")),
    "Gradient.by": entry(SOLUTION.gradient("load").by, name=("a.diameter", "word")),
    "Gradient.along": entry(
        SOLUTION.gradient("load").along, family=(lambda value: CONTACT, "thing"), at=(1.0, "number"),
        step=(0.1, "positive?"),
    ),
    "read_plan": entry(
        nh.read_plan, path=(FOLDER / "plan.toml", "file"), table=("over", "word"), raises=(nh.CaseError,),
    ),
    "Plan": entry(
        nh.Plan, case=(UPRIGHT, "thing"), over=({}, "options"), samples=(nh.study.Sampling(), "thing"),
        quantities=((), "any names"), title=("one", "name"), path=(Path("plan.toml"), "thing"),
    ),
    "Plan.changed": entry(
        nh.Plan(UPRIGHT).changed, over=({}, "given options"), samples=(None, "optional"),
        quantities=(None, "given any names"),
    ),
    "Plan.tried": entry(nh.Plan(UPRIGHT).tried, path=("load.load", "word"), given=([1e3], "spread")),
    "sweep": entry(
        nh.sweep, plan=(nh.Plan(UPRIGHT, over={"load.load": [1e3]}), "thing"), over=(None, "optional"),
        samples=(None, "whole?"), quantities=(None, "given names"), out=(None, "directory"), workers=(1, "whole?"),
        scheduler=(None, "optional"), announce=(None, "function?"), raises=(nh.CaseError,),
    ),
    "study.Sweep.__getitem__": entry(SWEPT.__getitem__, name=("load.load", "word"), raises=(KeyError,)),
    "study.Sweep.extremes": entry(SWEPT.extremes, name=("approach", "word"), raises=(KeyError,)),
    "study.Sweep.unit": entry(SWEPT.unit, name=("approach", "word"), raises=(KeyError,)),
    "tolerance": entry(
        nh.tolerance, plan=(UPRIGHT, "thing"), over=({"load.load": "uniform(1 kN, 2 kN)"}, "optional"),
        samples=(3, "whole?"), seed=(0, "seed?"), quantities=(None, "given names"), out=(None, "directory"),
        workers=(1, "whole?"), scheduler=(None, "optional"), announce=(None, "function?"), raises=(nh.CaseError,),
    ),
    "study.Tolerance.samples": entry(TOLERANCE.samples, name=("load", "word"), raises=(KeyError,)),
    "study.Tolerance.quantiles": entry(
        TOLERANCE.quantiles, name=("load", "word"), shares=(0.5, "open shares"), raises=(KeyError,),
    ),
    "study.Tolerance.indices": entry(TOLERANCE.indices, name=("load", "word"), raises=(KeyError,)),
    "study.Sampling.blocks": entry(nh.study.Sampling(30).blocks, dimensions=(2, "whole")),
    "study.Sampling.size": entry(nh.study.Sampling(30, "saltelli").size, dimensions=(2, "whole")),
    "study.Sampling": entry(nh.study.Sampling, count=(10, "whole"), method=("sobol", "word"), seed=(0, "count")),
    "study.Sampling.shares": entry(nh.study.Sampling(3).shares, dimensions=(2, "whole")),
    "study.Distribution": entry(
        nh.study.Distribution, kind=("normal", "word"), numbers=((0.0, 1.0), "table"), within=(None, "optional"),
    ),
    "study.Distribution.quantile": entry(nh.study.Distribution("uniform", (0.0, 1.0)).quantile, share=(0.5, "shares")),
    "study.damage": entry(nh.study.damage, model=(nh.life.lundberg_palmgren(), "thing")),
    "study.PressureAt": entry(nh.study.PressureAt, y=(0.0, "number")),
    "study.HalfWidthAt": entry(nh.study.HalfWidthAt, y=(0.0, "number")),
    "study.PressureNorm": entry(nh.study.PressureNorm, power=(20.0, "positive")),
    "study.PowerIntegral": entry(
        nh.study.PowerIntegral, pressure_power=(4.5, "positive"), half_width_power=(0.0, "number"),
    ),
    "Solutions.column": entry(MANY.column, name=("load", "word")),
    "compare": entry(
        nh.compare, contact=(CONTACT, "thing"), **PRESCRIBED, cells=((12, 16), "cells"), strips=(11, "strips"),
        accuracy=(None, "optional"), **RUNNING,
    ),
    "Comparison.quantity": entry(COMPARISON.quantity, name=("load", "word"), raises=(KeyError,)),
    "Comparison.along": entry(COMPARISON.along, solution=(COMPARISON.semi_elliptic, "thing")),
    "PatchSolution.across": entry(PATCH.across, y=(0.0, "number")),
    "EdgePressure.at": entry(SHARP.at, distance=(0.1, "positive numbers")),
    "Material": entry(
        nh.Material, modulus=(2e5, "positive"), poisson=(0.3, "number"), yield_strength=(None, "positive?"),
        core_yield_strength=(None, "positive?"), hardness=(None, "optional"), pressure_limit=(None, "positive?"),
    ),
    "Contact": entry(nh.Contact, a=(ROLLER, "thing"), b=(RING, "thing"), interpolated=(False, "flag")),
    "Body": entry(nh.Body, **BODY),
    "Roller": entry(nh.Roller, **BODY | {"length": (20.0, "positive")}),
    "Ring": entry(nh.Ring, **BODY),
    "Plate": entry(nh.Plate, **BODY | {"diameter": (None, "optional"), "depth": (1.0, "depth")}),
    "Body.relief": entry(ROLLER.relief, y=(0.0, "numbers")),
    "Body.curvature": entry(ROLLER.curvature, y=(0.0, "numbers")),
    "Contact.separation": entry(CONTACT.separation, y=(0.0, "numbers")),
    "Contact.curvature": entry(CONTACT.curvature, y=(0.0, "numbers")),
    "TabulatedDiameter": entry(nh.TabulatedDiameter, y=((-1.0, 1.0), "table"), diameter=((10.0, 12.0), "table")),
    "TabulatedDiameter.__call__": entry(nh.TabulatedDiameter((-1.0, 1.0), (10.0, 12.0)), y=(0.0, "numbers")),
    "hertz.point_contact": entry(
        hertz.point_contact, radius_x=(10.0, "positive"), radius_y=(100.0, "positive"), compliance=(2.8e-6, "positive"),
        angle=(0.0, "number"), load=(1e3, "positive"), approach=(None, "positive?"),
    ),
    "hertz.line_contact": entry(
        hertz.line_contact, line_load=(1e3, "positive"), radius=(10.0, "positive"), compliance=(2.8e-6, "positive"),
    ),
    "hertz.plane_strain_cylinder_compression": entry(
        hertz.plane_strain_cylinder_compression, contact=(LINE, "thing"), diameter=(20.0, "positive"),
        material=(STEEL, "thing"),
    ),
    "hertz.half_space_line_compression": entry(
        hertz.half_space_line_compression, contact=(LINE, "thing"), length=(20.0, "positive"),
    ),
    "hertz.PointContact.pressure": entry(POINT.pressure, y=(0.0, "numbers"), x=(0.0, "numbers")),
    "hertz.PointContact.half_width_at": entry(POINT.half_width_at, y=(0.0, "numbers")),
    "hertz.PointContact.line_load_at": entry(POINT.line_load_at, y=(0.0, "numbers")),
    "hertz.LineContact.pressure": entry(LINE.pressure, x=(0.0, "numbers")),
    "hertz.LineContact.stress": entry(LINE.stress, x=(0.0, "numbers"), z=(0.1, "numbers"), poisson=(0.3, "number")),
    "subsurface.stress": entry(subsurface.stress, **STRESS, **dict.fromkeys("xyz", (0.0, "numbers"))),
    "subsurface.axial_plane": entry(
        subsurface.axial_plane, **STRESS, y=([0.0], "row?"), z=([0.1], "row?"), x=(0.0, "number"),
    ),
    "subsurface.cross_section": entry(
        subsurface.cross_section, **STRESS, station=(0.0, "number"), x=([0.0], "row?"), z=([0.1], "row?"),
    ),
    "subsurface.volume": entry(subsurface.volume, **STRESS, **dict.fromkeys("xyz", ([0.0], "row"))),
    "subsurface.memory": entry(subsurface.memory, points=(10, "count"), displacement=(False, "flag")),
    "subsurface.passage": entry(subsurface.passage, **WITHIN, y=(0.0, "numbers"), z=(0.1, "numbers")),
    "subsurface.extremes": entry(subsurface.extremes, **WITHIN, station=(0.0, "number?"), depths=((0.0, 1.0), "table")),
    "bearing.RollerBearing": entry(bearing.RollerBearing, **PARTS),
    "bearing.CylindricalRollerBearing": entry(bearing.CylindricalRollerBearing, **PARTS, **RIBBED),
    "bearing.NeedleRollerBearing": entry(bearing.NeedleRollerBearing, **PARTS, **RIBBED),
    "bearing.TaperedRollerBearing": entry(
        bearing.TaperedRollerBearing, **TAPER, contact_angle=(0.2, "angle"), clearance=(0.0, "number"),
        rib=(None, "optional"),
    ),
    "bearing.SphericalRollerBearing": entry(
        bearing.SphericalRollerBearing, **PARTS, contact_angle=(0.1, "angle"), profile_radius=(30.0, "positive"),
        inner_groove=(31.0, "positive"), outer_groove=(31.0, "positive"), clearance=(0.0, "number"),
    ),
    "bearing.CylindricalThrustBearing": entry(
        bearing.CylindricalThrustBearing,
        **PARTS
        | {"inner": (nh.Plate(depth=4.0), "thing"), "outer": (nh.Plate(depth=4.0), "thing")}
        | {"pitch_diameter": (60.0, "positive")},
    ),
    "bearing.Paired": entry(
        bearing.Paired, bearings=((ROW,), "several"), x=((0.0,), "table"), turned=((False,), "several"),
        clearance=(0.0, "number"),
    ),
    "bearing.paired": entry(
        bearing.paired, bearing=(ROW, "thing"), arrangement=("O", "word"), distance=(20.0, "positive"),
        clearance=(0.0, "number"),
    ),
    "bearing.Rib": entry(
        bearing.Rib, end_radius=(100.0, "positive"), height=(4.0, "not negative"), crown_radius=(None, "positive?"),
        edge=(None, "edge?"),
    ),
    "bearing.Rib.of_flank": entry(
        bearing.Rib.of_flank, end_radius=(100.0, "positive"), angle=(0.01, "not negative"),
        crown_radius=(None, "positive?"), edge=(None, "edge?"),
    ),
    "bearing.solve": entry(
        bearing.solve, bearing=(ROW, "thing"), radial=(1e3, "number?"), axial=(None, "number?"),
        moment=(None, "number?"), radial_displacement=(None, "optional"), axial_displacement=(None, "number?"),
        tilt=(None, "number?"), speed=(0.0, "not negative"), turning=("inner", "word"), method=("slices", "word"),
        laminae=(30, "whole"), maps=(None, "optional"),
    ),
    "bearing.solve_many": entry(
        bearing.solve_many, bearing=(ROW, "thing"), radial=([1e3], "many?"), axial=(None, "many?"),
        moment=(None, "many?"), radial_displacement=(None, "optional"), axial_displacement=(None, "many?"),
        tilt=(None, "many?"), displacement=(None, "optional"), speed=(0.0, "not negative"), turning=("inner", "word"),
        method=("slices", "word"), laminae=(30, "whole"), maps=(None, "optional"), threads=(None, "whole?"),
    ),
    "bearing.table": entry(
        bearing.table, bearing=(ROW, "thing"), x=(0.0, "many"), y=([0.0, 0.01], "many"), z=(0.0, "many"),
        about_y=(0.0, "many"), about_z=(0.0, "many"), speed=(0.0, "not negative"), turning=("inner", "word"),
        method=("slices", "word"), laminae=(30, "whole"), maps=(None, "optional"), checks=(1, "count"),
    ),
    "bearing.ForceTable.interpolated": entry(
        FORCES.interpolated, x=(None, "optional"), y=(0.005, "numbers"), z=(None, "optional"),
        about_y=(None, "optional"), about_z=(None, "optional"), kind=("linear", "word"),
    ),
    "bearing.ForceTable.sampled_error": entry(FORCES.sampled_error, kind=("linear", "word")),
    "bearing.maps": entry(
        bearing.maps, bearing=(ROW, "thing"), load=(1e3, "positive"), tilt=(1e-4, "positive"), accuracy=(0.1, "all"),
    ),
    "bearing.BearingSolutions.__getitem__": entry(
        bearing.solve_many(ROW, radial=[1e3], method="slices").__getitem__, number=(0, "index"), raises=(IndexError,),
    ),
    "bearing.CylindricalThrustBearing.load_by_speed": entry(
        bearing.CylindricalThrustBearing(
            roller=ROW.roller, inner=nh.Plate(depth=4.0), outer=nh.Plate(depth=4.0), rollers=13, pitch_diameter=60.0
        ).load_by_speed,
        speed=(100.0, "number"), turning=("inner", "word"),
    ),
    "bearing.SphericalRollerBearing.load_by_speed": entry(
        BARRELS.load_by_speed, speed=(100.0, "number"), turning=("inner", "word"),
    ),
    "bearing.RollerBearing.load_by_speed": entry(ROW.load_by_speed, speed=(100.0, "number"), turning=("inner", "word")),
    "bearing.rating": entry(
        bearing.rating, bearing=(ROW, "thing"), dynamic=(None, "positive?"), static=(None, "positive?"),
        material_factor=(None, "positive?"),
    ),
    "bearing.assess": entry(
        bearing.assess, solution=(bearing.solve(ROW, radial=3e3, method="slices"), "thing"), speed=(1e3, "positive"),
        viscosity=(20.0, "positive"), contamination=(0.5, "positive?"), cleanliness=("high", "word"),
        reliability=(0.9, "positive"), edge_stress=(None, "optional"), laminae=(30, "whole"), turning=("inner", "word"),
        dynamic=(None, "positive?"), static=(None, "positive?"),
    ),
    "bearing.reference_viscosity": entry(
        bearing.reference_viscosity, speed=(1e3, "positive"), pitch_diameter=(50.0, "positive"),
    ),
    "bearing.life_factor": entry(
        bearing.life_factor, viscosity_ratio=(1.0, "positive"), relative_limit=(0.3, "positive"),
    ),
    "bearing.reliability_factor": entry(bearing.reliability_factor, reliability=(0.95, "positive")),
    "bearing.contamination_factor": entry(
        bearing.contamination_factor, viscosity_ratio=(1.0, "positive"), pitch_diameter=(50.0, "positive"),
        cleanliness=("high", "word"),
    ),
    "bearing.Shaft": entry(
        bearing.Shaft, diameter=(30.0, "positive"), interference=(0.01, "number"), smoothing=(0.0, "not negative"),
        bore=(0.0, "not negative"), material=(STEEL, "thing"), expansion=(12e-6, "number?"),
        density=(7.85e-9, "positive?"), temperature=(20.0, "number"),
    ),
    "bearing.Housing": entry(
        bearing.Housing, diameter=(62.0, "positive"), interference=(0.01, "number"), smoothing=(0.0, "not negative"),
        outside_diameter=(90.0, "endless"), material=(STEEL, "thing"), expansion=(12e-6, "number?"),
        temperature=(20.0, "number"),
    ),
    "bearing.Mounting": entry(
        bearing.Mounting, shaft=(bearing.Shaft(diameter=30.0, interference=0.01), "thing"),
        housing=(bearing.Housing(diameter=62.0), "thing"),
        **dict.fromkeys(("inner_temperature", "roller_temperature", "outer_temperature"), (50.0, "number")),
        ring_expansion=(12e-6, "number?"), roller_expansion=(12e-6, "number?"), ring_density=(7.85e-9, "positive?"),
    ),
    "bearing.Mounting.operating": entry(MOUNTING.operating, bearing=(ROW, "thing"), speed=(1e3, "not negative")),
    "bearing.Mounting.mounted": entry(MOUNTING.mounted, bearing=(ROW, "thing"), speed=(1e3, "not negative")),
    "bearing.Mounting.expansion": entry(MOUNTING.expansion, bearing=(bearing.paired(ROW, "X", 20.0), "thing")),
    "bearing.OperatingClearance.axial": entry(MOUNTING.operating(ROW).axial, contact_angle=(0.2, "angle")),
    "bearing.from_catalogue": entry(
        bearing.from_catalogue, bore=(30.0, "positive"), outside_diameter=(62.0, "positive"), width=(16.0, "positive"),
        dynamic=(44e3, "positive"), static=(36.5e3, "positive"), kind=("cylindrical", "word"),
        inner_raceway=(None, "positive?"), outer_raceway=(None, "positive?"),
        **dict.fromkeys(("contact_angle", "limiting_ratio", "axial_factor"), (None, "optional")),
        clearance=(None, "number?"),
    ),
    "bearing.fourier_shape": entry(bearing.fourier_shape, terms=({2: 0.005}, "options")),
    "bearing.tabulated_shape": entry(
        bearing.tabulated_shape, angle=([0.0, 1.0, 2.0], "row"), deviation=([0.0, 0.01, 0.0], "row"),
        curve=("linear", "word"),
    ),
    "bearing.RingShape.__call__": entry(bearing.fourier_shape({2: 0.005}), angle=([0.0], "numbers")),
    "bearing.RingShape.turned": entry(bearing.fourier_shape({2: 0.005}).turned, by=(0.1, "number")),
    "bearing.RingShape.scaled": entry(bearing.fourier_shape({2: 0.005}).scaled, by=(-1.0, "number")),
    "bearing.BearingSolution.plot": entry(LOADED.plot, what=("relief", "word"), ax=(None, "optional")),
    "bearing.BearingSolution.contact": entry(LOADED.contact, roller=(0, "count"), ring=("inner", "word")),
    "bearing.BearingSolution.rib_contact": entry(LOADED.rib_contact, roller=(0, "count"), ring=("inner", "word")),
    "bearing.BearingSolution.place_of": entry(LOADED.place_of, roller=(0, "count")),
    "bearing.BearingSolution.rollers_of": entry(LOADED.rollers_of, row=(0, "count")),
    "bearing.BearingSolution.unrolled_pressure": entry(
        LOADED.unrolled_pressure, ring=("inner", "word"), row=(0, "count"), y=([0.0, 1.0], "row?"),
    ),
    "bearing.oil_viscosity": entry(
        bearing.oil_viscosity, temperature=(70.0, "number"), viscosities=((46.0, 6.8), "numbers"),
        temperatures=((40.0, 100.0), "numbers"),
    ),
    "bearing.LoadCase": entry(
        bearing.LoadCase, share=(0.5, "positive"), radial=(1e3, "number?"), axial=(None, "number?"),
        moment=(None, "number?"), radial_displacement=(None, "number?"), axial_displacement=(None, "number?"),
        tilt=(0.0, "number?"), speed=(1e3, "not negative"),
    ),
    "bearing.solve_spectrum": entry(
        bearing.solve_spectrum, bearing=(ROW, "thing"), cases=([bearing.LoadCase(share=1.0, radial=3e3)], "several"),
        turning=("inner", "word"), method=("slices", "word"), laminae=(30, "whole"), maps=(None, "optional"),
    ),
    "bearing.shares_of_revolutions": entry(
        bearing.shares_of_revolutions, times=([0.5, 0.5], "numbers"), speeds=([1e3, 2e3], "numbers"),
    ),
    "bearing.volume_life": entry(
        bearing.volume_life, solution=(LOADED, "thing"), model=("zaretsky", "word"), turning=("inner", "word"),
        field=("sections", "word"), dynamic=(None, "positive?"),
    ),
    "bearing.pressure_safety": entry(bearing.pressure_safety, solution=(LOADED, "thing"), limit=(4e3, "positive")),
    "strength.assess": entry(strength.assess, **WITHIN, criterion=("tresca", "word"), largest=(None, "optional")),
    "life.assess": entry(
        life.assess, **WITHIN, models=("iso-16281", "models"), rollers=(10, "whole?"), contact_angle=(None, "number?"),
    ),
    "life.exposure": entry(life.exposure, **WITHIN),
    "life.overrolled": entry(
        life.overrolled, solution=(SOLUTION, "thing"), dent=(DENT, "thing"), body=("b", "word"),
        cell=(COARSELY["cell"], "positive?"), station=(COARSELY["station"], "share"),
        reach=(COARSELY["reach"], "positive"), announce=(None, "function?"),
    ),
    "life.Overrolled.excess": entry(OVERROLLED.excess, model=(PALMGREN, "thing"), within=(0.2, "endless")),
    "life.Overrolled.density": entry(OVERROLLED.density, model=(PALMGREN, "thing"), dented=(True, "flag")),
    "life.Overrolled.relative_life": entry(
        OVERROLLED.relative_life, model=(PALMGREN, "thing"), dents=(2, "count"), per_area=(None, "number?"),
        raceway_diameter=(None, "positive?"),
    ),
    "life.Exposure.density": entry(EXPOSURE.density, model=(PALMGREN, "thing")),
    "life.Exposure.damage": entry(EXPOSURE.damage, model=(PALMGREN, "thing")),
    "life.Life.over": entry(LIFE.over, other=(LIFE, "thing")),
    "life.model": entry(life.model, name=("weibull", "word"), exponent=(9.0, "positive")),
    "life.lundberg_palmgren": entry(
        life.lundberg_palmgren, slope=(1.1, "positive"), exponent=(10.0, "positive"),
        depth_exponent=(2.0, "not negative"),
    ),
    "life.ioannides_harris": entry(
        life.ioannides_harris, fatigue_limit=(300.0, "not negative"), slope=(1.1, "positive"),
        exponent=(10.0, "positive"), depth_exponent=(2.0, "not negative"), stress=("orthogonal_shear", "word"),
    ),
    "life.zaretsky": entry(
        life.zaretsky, slope=(1.1, "positive"), stress_life_exponent=(9.0, "positive"), stress=("shear", "word"),
    ),
    "life.weibull": entry(life.weibull, slope=(1.1, "positive"), exponent=(9.0, "positive"), stress=("shear", "word")),
    "life.iso_16281": entry(
        life.iso_16281, laminae=(60, "thing"), edge_stress=("pressure", "word"), line_loads=("solution", "word"),
    ),
    "life.VolumeModel": entry(
        life.VolumeModel, name=("own", "name"), stress=("shear", "word"), exponent=(9.0, "positive"),
        depth_exponent=(0.0, "not negative"), slope=(1.0, "positive"), fatigue_limit=(0.0, "not negative"),
        source=("own", "name"),
    ),
    "life.LaminaModel": entry(
        life.LaminaModel, name=("own", "name"), laminae=(60, "thing"), edge_stress=("pressure", "word"),
        line_loads=("solution", "word"), source=("own", "name"),
    ),
    "life.LoadCase": entry(life.LoadCase, load=(1e3, "unbounded"), share=(0.5, "share"), tilt=(0.0, "number")),
    "life.solve_spectrum": entry(
        life.solve_spectrum, contact=(CONTACT, "several"), cases=(CASES, "thing"), element=(nh.SEMI_ELLIPTIC, "thing"),
        strips=(11, "strips"), accuracy=(None, "optional"), threads=(1, "whole?"),
    ),
    "life.Raceway": entry(
        life.Raceway, roller_diameter=(10.0, "positive"), length=(9.6, "positive"), pitch_diameter=(65.0, "positive"),
        inner=(True, "flag"), body=("b", "word"), contact_angle=(0.2, "not negative"),
    ),
    "life.Raceway.capacity_of": entry(
        RACEWAY.capacity_of, load_rating=(5e4, "positive"), rollers=(14, "whole"), rows=(2, "whole"),
    ),
    "life.Raceway.load_rating": entry(
        RACEWAY.load_rating, rollers=(14, "whole"), rows=(2, "whole"), material_factor=(None, "positive?"),
    ),
    "life.Raceway.capacity": entry(RACEWAY.capacity, rollers=(14, "whole")),
    "life.raceway": entry(life.raceway, contact=(CONTACT, "thing"), contact_angle=(0.2, "number?")),
    "profile.straight": entry(profile.straight),
    "profile.crown": entry(profile.crown, radius=(100.0, "number"), centre=(0.0, "number")),
    "profile.partial_crown": entry(
        profile.partial_crown, radius=(500.0, "positive"), straight=(5.0, "not negative"), blended=(True, "flag"),
    ),
    "profile.two_radius": entry(
        profile.two_radius, radius=(500.0, "positive"), end_radius=(100.0, "positive"), middle=(4.0, "positive"),
    ),
    "profile.logarithmic": entry(
        profile.logarithmic, amplitude=(0.01, "not negative"), length=(20.0, "positive"), fraction=(0.5, "share"),
        straight=(5.0, "not negative"),
    ),
    "profile.lundberg": entry(profile.lundberg, **DESIGN),
    "profile.johns_gohar": entry(profile.johns_gohar, **DESIGN),
    "profile.fujiwara_kawase": entry(
        profile.fujiwara_kawase, **DESIGN | {"radius": (10.0, "positive?")}, k1=(1.0, "positive"), k2=(0.5, "share"),
        zm=(0.03, "positive?"),
    ),
    "profile.iso_logarithmic": entry(profile.iso_logarithmic, diameter=(10.0, "positive"), length=(20.0, "positive")),
    "profile.iso_tapered": entry(profile.iso_tapered, diameter=(10.0, "positive"), length=(20.0, "positive")),
    "profile.iso_thrust": entry(profile.iso_thrust, diameter=(10.0, "positive"), length=(20.0, "positive")),
    "profile.conical": entry(profile.conical, angle=(0.01, "number")),
    "profile.tapered_ends": entry(profile.tapered_ends, straight=(5.0, "not negative"), angle=(0.01, "not negative")),
    "profile.chamfer": entry(
        profile.chamfer, length=(20.0, "positive"), width=(1.0, "positive"), angle=(0.01, "not negative"),
    ),
    "profile.tabulated": entry(
        profile.tabulated, y=([-1.0, 1.0], "table"), relief=([0.0, 1.0], "table"), interpolation=("pchip", "word"),
    ),
    "profile.with_drop": entry(profile.with_drop, kind=("crown", "word"), drop=(0.02, "number"), at=(9.5, "number")),
    "profile.from_file": entry(
        profile.from_file, path=(FOLDER / "profile.csv", "thing"), interpolation=("pchip", "word"),
    ),
    "profile.Profile.shifted": entry(TABLE.shifted, by=(0.0, "number")),
    "profile.Profile.scaled": entry(TABLE.scaled, by=(1.0, "number")),
    "measured.Points": entry(
        measured.Points, y=(Y, "table"), height=(Y, "table"), gaps=((), "intervals"), land=(None, "optional"),
    ),
    "measured.Trace": entry(
        measured.Trace, y=(Y, "table"), height=(Y, "table"), gaps=((), "intervals"), land=(None, "optional"),
        name=("a", "name"), notes=((), "lines"),
    ),
    "measured.Measured": entry(measured.Measured, trace=(TRACE, "thing"), steps=((), "names")),
    "measured.Level": entry(measured.Level, slope=(0.05, "positive")),
    "measured.Align": entry(measured.Align, by=("ends", "word"), slope=(0.05, "positive")),
    "measured.Trim": entry(measured.Trim, length=(5.0, "positive?"), slope=(0.05, "positive"), corner=("keep", "word")),
    "measured.Outliers": entry(measured.Outliers, threshold=(5.0, "positive")),
    "measured.Smooth": entry(measured.Smooth, cutoff=(0.8, "positive"), method=("gaussian", "word")),
    "measured.Thin": entry(measured.Thin, count=(201, "whole")),
    "measured.prepare": entry(
        measured.prepare, trace=(TRACE, "thing"), level=(True, "flag"), align=(True, "prepared"),
        trim=("auto", "prepared"), corner=("keep", "word"), outliers=(True, "prepared"),
        smooth=("gaussian", "prepared"), cutoff=(0.8, "positive?"), slope=(0.05, "positive?"),
        points=("auto", "prepared"),
    ),
    "measured.fit": entry(
        measured.fit, points=(TRACE, "thing"), kind=("crown", "word"), highest=(0.0, "number?"), **FIT,
    ),
    "measured.fit_best": entry(
        measured.fit_best, points=(TRACE, "thing"), kinds=(["crown"], "optional"), highest=(0.0, "number?"), **FIT,
    ),
}  # fmt: skip
for _kind in ("crown(100)", "straight()", "conical(.01)", "tapered_ends(5, .01)", "iso_logarithmic(10, 20)"):
    ENTRIES[f"profile.{_kind}.relief"] = entry(eval(f"profile.{_kind}").relief, y=(0.0, "numbers"))
ENTRIES["profile.lundberg().relief"] = entry(profile.lundberg(1e3, 20.0, 10.0).relief, y=(0.0, "numbers"))
ENTRIES["profile.tabulated().relief"] = entry(TABLE.relief, y=(0.0, "numbers"))
ENTRIES["profile.sum.relief"] = entry((TABLE.shifted(1.0) + TABLE.scaled(2.0)).relief, y=(0.0, "numbers"))
