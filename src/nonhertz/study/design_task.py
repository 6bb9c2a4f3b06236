"""The task of a design, and the starts of its searches."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nonhertz.errors import InputError, NonhertzError
from nonhertz.files.casefile import Case
from nonhertz.files.free_forms import parse_free_form
from nonhertz.files.planfile import Template, read_design
from nonhertz.files.spreads import parse_bounds
from nonhertz.inputs.checks import one_of, whole
from nonhertz.life import ContactLoadCase, Model, lundberg_palmgren
from nonhertz.life.spectrum import check_cases, refuse_other_than_whole
from nonhertz.result.quantities import QUANTITIES
from nonhertz.study.limits import limits_in
from nonhertz.study.objective import GOALS, LIFE, PRESSURE, Task, Variable

Array = NDArray[np.float64]

STARTS, MOST_STARTS = 5, 100
BEYOND = 1.2  # least ratio of bounds to slopes and curvatures of a start


def check_design(
    case: object,
    bounds: Mapping[str, Any] | None = None,
    goal: str | None = None,
    loads: Sequence[ContactLoadCase] | None = None,
    constraints: Mapping[str, Any] | None = None,
    model: Model | None = None,
    n_starts: int | None = None,
) -> tuple[Task, int]:
    """Return the task of `optimize` and the number of starts; invalid arguments are refused before any solving."""
    plan: dict[str, Any] = {}
    if isinstance(case, str | Path):
        case, plan = read_design(case)
    if not isinstance(case, Case):
        remedy = "read one with nonhertz.read_case; a bearing can only be swept"
        raise InputError("case", case, "be a case of a single contact", remedy)
    arguments: dict[str, Any] = {
        "bounds": bounds,
        "goal": goal,
        "loads": loads,
        "constraints": constraints,
        "model": model,
        "n_starts": n_starts,
    }
    plan |= {name: value for name, value in arguments.items() if value is not None}
    template = Template(case.document, case.path, is_bearing=False)
    chosen = plan.get("goal", PRESSURE)
    one_of("goal", chosen, GOALS, "choose one of them")
    fatigue = lundberg_palmgren() if plan.get("model") is None else plan["model"]
    if chosen == LIFE or model is not None:
        from nonhertz.study.lives import damage

        damage(fatigue)  # refuses models with a limit
    task = Task(
        template,
        _variables(template, plan.get("bounds", {})),
        _loads(case, plan.get("loads")),
        chosen,
        fatigue,
        limits_in(_check_mapping("constraints", plan.get("constraints", {})), QUANTITIES),
    )
    return task, whole("n_starts", plan.get("n_starts", STARTS), 1, MOST_STARTS, "give the number of searches")


def _check_mapping(name: str, value: object) -> Mapping[str, Any]:
    if not isinstance(value, Mapping) or not all(isinstance(key, str) for key in value):
        raise InputError(name, value, "be a dictionary", "map paths or names to their limits")
    return value


def _variables(template: Template, bounds: object) -> tuple[Variable, ...]:
    variables: list[Variable] = []
    for path, text in _check_mapping("bounds", bounds).items():
        which = template.find_varied(path, text)
        form = parse_free_form(path, text)
        if form is not None:
            variables += [Variable(path, 0.0, 1.0, form)] * form.knots
            continue
        variables.append(Variable(path, *parse_bounds(which, text)))
        for end in (variables[-1].low, variables[-1].high):
            try:
                template.case({path: end})
            except NonhertzError as error:
                condition = f"be valid in the case (at {end:.6g}: {str(error).rstrip('.')})"
                remedy = "change these bounds, or related inputs of the case"
                raise InputError(path, text, condition, remedy) from None
    if not variables:
        raise InputError("bounds", bounds, "name a path", 'write for example {"body.a.profile.drop": "2 um : 60 um"}')
    return tuple(variables)


def _loads(case: Case, loads: Any) -> tuple[ContactLoadCase, ...]:
    if loads is None:
        if case.life.spectrum:
            return case.life.spectrum
        prescribed = case.prescribed
        if prescribed.load is None or prescribed.moment is not None:
            remedy = "give loads, each with a tilt"
            raise InputError("case", sorted(prescribed.keywords), "have a load, and no moment, for a design", remedy)
        return (ContactLoadCase(load=prescribed.load, share=1.0, tilt=prescribed.tilt or 0.0),)
    cases = check_cases("loads", loads, ContactLoadCase)
    refuse_other_than_whole("loads", cases, "give each its share")
    return tuple(cases)


def shares_of(task: Task, values: Mapping[str, Any]) -> list[float]:
    """Return the variables at these values."""
    remaining = {path: iter(value) if isinstance(value, list) else iter([value]) for path, value in values.items()}
    return [variable.share(next(remaining[variable.path])) for variable in task.variables]


def find_starts(task: Task, starts: int) -> list[Array]:
    """Return the starts of the searches: the original case, if within the bounds, and others spread between these."""
    from scipy.stats import qmc

    now = _shares_as_is(task)
    begins = [] if now is None else [now]
    count = math.ceil(math.log2(starts + 1))
    spread = qmc.Sobol(len(task.variables), rng=np.random.default_rng(1)).random_base2(count)
    for point in spread[: starts - len(begins)]:
        x = 0.05 + 0.9 * point
        for path in {variable.path for variable in task.variables if variable.form is not None}:
            at = [k for k, variable in enumerate(task.variables) if variable.path == path]
            # Increasing towards the ends, as profiles do, and between a tenth and half of the largest relief in all.
            x[at] = (0.3 + x[at]) * np.linspace(0.1, 1.0, len(at)) ** 2
            x[at] *= math.sqrt(0.1 + 0.4 * float(point[at[0]])) / np.linalg.norm(x[at])
        for mine, margins, _ in task.of_forms(x):
            # Free profiles must start within their bounds; margins are 1 minus a term that grows with the squares.
            x[mine] /= math.sqrt(max(1.0, BEYOND * (1.0 - float(margins.min()))))
        begins.append(x)
    return begins


def _shares_as_is(task: Task) -> Array | None:
    """Return the original case; None if it lies outside the bounds, or leaves values out."""
    from nonhertz.inputs.units import to_unit

    point = []
    for variable in task.variables:
        parameter = task.template.known[variable.path]
        value = parameter.value_in(task.template.document)
        number = to_unit(variable.path, value, parameter.unit or "") if variable.form is None else None
        if not isinstance(number, float) or not variable.low <= number <= variable.high:
            return None
        point.append(variable.share(number))
    return np.array(point)
