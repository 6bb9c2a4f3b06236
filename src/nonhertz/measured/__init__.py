"""Measured profiles: from what a measuring machine wrote to a profile to solve with.

A `Trace` is what was measured. `prepare` returns it with the usual steps, `Measured` is any trace with any steps, and
each step (`Level`, `Align`, `Trim`, `Outliers`, `Smooth`, `Thin`) can be seen, changed or left out; the raw trace stays
what it is. `Measured.profile()` is a profile as any other, `Measured.fit` the nearest one of the catalogue,
`Measured.warnings` what has to be known before solving with it. Files are read by `nonhertz.io.traces.read_trace`.
"""

from nonhertz.measured.chain import Measured as Measured
from nonhertz.measured.chain import prepare as prepare
from nonhertz.measured.fit import Fit as Fit
from nonhertz.measured.fit import fit as fit
from nonhertz.measured.fit import fit_best as fit_best
from nonhertz.measured.roughness import Roughness as Roughness
from nonhertz.measured.steps import Align as Align
from nonhertz.measured.steps import Level as Level
from nonhertz.measured.steps import Outliers as Outliers
from nonhertz.measured.steps import Smooth as Smooth
from nonhertz.measured.steps import State as State
from nonhertz.measured.steps import Thin as Thin
from nonhertz.measured.steps import Trim as Trim
from nonhertz.measured.trace import Points as Points
from nonhertz.measured.trace import Trace as Trace
