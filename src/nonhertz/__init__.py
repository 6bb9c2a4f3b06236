"""Elastic contact of rollers, raceways, gear teeth and wheels whose shape no Hertz formula fits.

Two bodies (`Roller`, `Ring`, `Plate` or `Body`), each with a relief from `profile`, form a `Contact`; `solve` returns
its `Solution`, `solve_many` many of them. `strength`, `subsurface` and `life` evaluate solutions; `bearing` solves
whole roller bearings; `patch` solves any gap on a plane grid, and `hertz` has closed forms. `sweep`, `tolerance`,
`optimize` and `pareto` vary inputs; `read_case`, `read_bearing` and `read_plan` read the files of the command line.

Units are mm, N, MPa and rad throughout. Positive relief is material removed.

Examples
--------
>>> import nonhertz as nh
>>> roller = nh.Roller(diameter=20, length=20, profile=nh.profile.crown(radius=4000))
>>> solution = nh.solve(nh.Contact(roller, nh.Plate()), load=20e3)
>>> round(solution.approach, 4)
0.0307
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from nonhertz import bearing as bearing
    from nonhertz import files as files
    from nonhertz import hertz as hertz
    from nonhertz import life as life
    from nonhertz import maps as maps
    from nonhertz import measured as measured
    from nonhertz import patch as patch
    from nonhertz import plot as plot
    from nonhertz import strength as strength
    from nonhertz import study as study
    from nonhertz import subsurface as subsurface
    from nonhertz.comparison import Comparison as Comparison
    from nonhertz.comparison import compare as compare
    from nonhertz.errors import AccuracyWarning as AccuracyWarning
    from nonhertz.errors import CaseError as CaseError
    from nonhertz.errors import ConvergenceError as ConvergenceError
    from nonhertz.errors import InputError as InputError
    from nonhertz.errors import Interrupted as Interrupted
    from nonhertz.errors import NonhertzError as NonhertzError
    from nonhertz.files.bearingfile import BearingCase as BearingCase
    from nonhertz.files.bearingfile import new_bearing as new_bearing
    from nonhertz.files.bearingfile import read_bearing as read_bearing
    from nonhertz.files.casefile import Case as Case
    from nonhertz.files.casefile import new_case as new_case
    from nonhertz.files.casefile import read_case as read_case
    from nonhertz.files.planfile import Plan as Plan
    from nonhertz.files.planfile import read_plan as read_plan
    from nonhertz.files.resultfile import Result as Result
    from nonhertz.files.resultfile import read_result as read_result
    from nonhertz.maps.value import ContactMap as ContactMap
    from nonhertz.maps.verb import contact_map as contact_map
    from nonhertz.model import profile as profile
    from nonhertz.model.body import Body as Body
    from nonhertz.model.body import Plate as Plate
    from nonhertz.model.body import Ring as Ring
    from nonhertz.model.body import Roller as Roller
    from nonhertz.model.contact import Contact as Contact
    from nonhertz.model.corner import Chamfer as Chamfer
    from nonhertz.model.diameter import TabulatedDiameter as TabulatedDiameter
    from nonhertz.model.material import Material as Material
    from nonhertz.model.materials import MATERIALS as MATERIALS
    from nonhertz.result.edges import EdgeKind as EdgeKind
    from nonhertz.result.edges import EdgePressure as EdgePressure
    from nonhertz.result.edges import SingularEnd as SingularEnd
    from nonhertz.result.solution import Solution as Solution
    from nonhertz.result.status import ErrorEstimate as ErrorEstimate
    from nonhertz.result.status import Status as Status
    from nonhertz.solver.many import solve_many as solve_many
    from nonhertz.solver.one import solve as solve
    from nonhertz.solver.portions import Chunk as Chunk
    from nonhertz.solver.solutions import Solutions as Solutions
    from nonhertz.strip.element import PARABOLIC as PARABOLIC
    from nonhertz.strip.element import SEMI_ELLIPTIC as SEMI_ELLIPTIC
    from nonhertz.study.design import optimize as optimize
    from nonhertz.study.design import pareto as pareto
    from nonhertz.study.sweeps import sweep as sweep
    from nonhertz.study.tolerances import tolerance as tolerance

__version__ = "0.1.0"

# Where each public name is defined. Nothing is imported until it is accessed, so that `import nonhertz` takes
# milliseconds and the command line answers `--help` without loading numpy.
_HOMES = {
    "AccuracyWarning": "nonhertz.errors",
    "BearingCase": "nonhertz.files.bearingfile",
    "Body": "nonhertz.model.body",
    "Case": "nonhertz.files.casefile",
    "Chamfer": "nonhertz.model.corner",
    "Comparison": "nonhertz.comparison",
    "Contact": "nonhertz.model.contact",
    "CaseError": "nonhertz.errors",
    "ConvergenceError": "nonhertz.errors",
    "EdgeKind": "nonhertz.result.edges",
    "EdgePressure": "nonhertz.result.edges",
    "ErrorEstimate": "nonhertz.result.status",
    "InputError": "nonhertz.errors",
    "Interrupted": "nonhertz.errors",
    "MATERIALS": "nonhertz.model.materials",
    "Material": "nonhertz.model.material",
    "NonhertzError": "nonhertz.errors",
    "PARABOLIC": "nonhertz.strip.element",
    "Plan": "nonhertz.files.planfile",
    "Plate": "nonhertz.model.body",
    "Chunk": "nonhertz.solver.portions",
    "Result": "nonhertz.files.resultfile",
    "Ring": "nonhertz.model.body",
    "Roller": "nonhertz.model.body",
    "SEMI_ELLIPTIC": "nonhertz.strip.element",
    "SingularEnd": "nonhertz.result.edges",
    "Solution": "nonhertz.result.solution",
    "Solutions": "nonhertz.solver.solutions",
    "Status": "nonhertz.result.status",
    "TabulatedDiameter": "nonhertz.model.diameter",
    "ContactMap": "nonhertz.maps.value",
    "compare": "nonhertz.comparison",
    "contact_map": "nonhertz.maps.verb",
    "new_bearing": "nonhertz.files.bearingfile",
    "new_case": "nonhertz.files.casefile",
    "optimize": "nonhertz.study.design",
    "pareto": "nonhertz.study.design",
    "read_bearing": "nonhertz.files.bearingfile",
    "read_case": "nonhertz.files.casefile",
    "read_plan": "nonhertz.files.planfile",
    "read_result": "nonhertz.files.resultfile",
    "solve": "nonhertz.solver.one",
    "solve_many": "nonhertz.solver.many",
    "sweep": "nonhertz.study.sweeps",
    "tolerance": "nonhertz.study.tolerances",
}
_MODULES = {
    "bearing": "nonhertz.bearing",
    "hertz": "nonhertz.hertz",
    "files": "nonhertz.files",
    "life": "nonhertz.life",
    "maps": "nonhertz.maps",
    "measured": "nonhertz.measured",
    "patch": "nonhertz.patch",
    "plot": "nonhertz.plot",
    "profile": "nonhertz.model.profile",
    "strength": "nonhertz.strength",
    "study": "nonhertz.study",
    "subsurface": "nonhertz.subsurface",
}


def __getattr__(name: str) -> Any:
    if name in _MODULES:
        value: Any = importlib.import_module(_MODULES[name])
    elif name in _HOMES:
        value = getattr(importlib.import_module(_HOMES[name]), name)
    else:
        raise AttributeError(f"module 'nonhertz' has no attribute {name!r}")
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted([*_HOMES, *_MODULES, "__version__"])
