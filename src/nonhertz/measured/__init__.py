"""Measured profiles: from a measuring machine's output to a profile to solve with.

A `Trace` is a raw measurement. `prepare` returns it with the usual steps, `Measured` is any trace with any steps, and
each step (`Level`, `Align`, `Trim`, `Outliers`, `Smooth`, `Thin`) can be inspected, changed or left out; the raw trace
is never modified. `Measured.profile()` is a profile like any other, `Measured.fit` the best fit from the catalogue,
`Measured.warnings` are doubts before solving with it. `nonhertz.files.read_trace` reads files.
"""

from typing import TYPE_CHECKING

from nonhertz.lazy import attach

if TYPE_CHECKING:
    from nonhertz.measured.chain import Measured as Measured
    from nonhertz.measured.chain import prepare as prepare
    from nonhertz.measured.fitting import ProfileFit as ProfileFit
    from nonhertz.measured.fitting import fit as fit
    from nonhertz.measured.fitting import fit_best as fit_best
    from nonhertz.measured.roughness import Roughness as Roughness
    from nonhertz.measured.steps import Align as Align
    from nonhertz.measured.steps import Level as Level
    from nonhertz.measured.steps import Outliers as Outliers
    from nonhertz.measured.steps import Smooth as Smooth
    from nonhertz.measured.steps import StepResult as StepResult
    from nonhertz.measured.steps import Thin as Thin
    from nonhertz.measured.steps import Trim as Trim
    from nonhertz.measured.trace import Points as Points
    from nonhertz.measured.trace import Trace as Trace

__getattr__, __dir__ = attach(
    __name__,
    {
        "chain": ("Measured", "prepare"),
        "fitting": ("ProfileFit", "fit", "fit_best"),
        "roughness": ("Roughness",),
        "steps": ("Align", "Level", "Outliers", "Smooth", "StepResult", "Thin", "Trim"),
        "trace": ("Points", "Trace"),
    },
)
