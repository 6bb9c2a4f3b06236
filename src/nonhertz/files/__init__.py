"""Reading and writing files: case files, quantities with units, and results."""

from typing import TYPE_CHECKING

from nonhertz.lazy import attach

if TYPE_CHECKING:
    from nonhertz.files.bearingfile import BearingCase as BearingCase
    from nonhertz.files.bearingfile import read_bearing as read_bearing
    from nonhertz.files.casefile import Case as Case
    from nonhertz.files.casefile import read_case as read_case
    from nonhertz.files.planfile import Plan as Plan
    from nonhertz.files.planfile import read_plan as read_plan
    from nonhertz.files.resultfile import Result as Result
    from nonhertz.files.resultfile import read_result as read_result
    from nonhertz.files.rexs import read_rexs as read_rexs
    from nonhertz.files.rexs import write_rexs as write_rexs
    from nonhertz.files.traces import read_trace as read_trace

__getattr__, __dir__ = attach(
    __name__,
    {
        "bearingfile": ("BearingCase", "read_bearing"),
        "casefile": ("Case", "read_case"),
        "planfile": ("Plan", "read_plan"),
        "resultfile": ("Result", "read_result"),
        "rexs": ("read_rexs", "write_rexs"),
        "traces": ("read_trace",),
    },
)
