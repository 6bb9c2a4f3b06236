"""Plan files: a case or a bearing, and what of it is varied.

All mistakes in a file are found at once and raised together.
"""

from __future__ import annotations

import warnings
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import Any

from nonhertz.errors import AccuracyWarning, CaseError, InputError
from nonhertz.inputs.checks import one_line, one_of
from nonhertz.inputs.files import legible
from nonhertz.io.bearingfile import BearingCase, bearing_in, bearing_schema
from nonhertz.io.casefile import Case, case_in, case_text, holds_bearing, named, parsed, schema, starting_text
from nonhertz.io.forms import with_form
from nonhertz.io.mistakes import Mistake, TableError, case_error, in_order
from nonhertz.io.paths import FORM, Parameter, drops_first, parameter, parameters
from nonhertz.io.plan_document import PlanDocument
from nonhertz.io.reading import read, schema_of_file
from nonhertz.io.sampling import Sampling
from nonhertz.io.spreads import Distribution, Spread, spread_in
from nonhertz.life import model
from nonhertz.result.numerals import digits

#: The tables of a plan that say what is varied: in a sweep, and within tolerances.
LOAD = "load.load"
TABLES = ("over", "tolerance")
DESIGN = "vary"
_WAY_OUT = "change these values, or what the case holds beside them"
TRIED = 50  # values of a list that are tried before the work starts


@dataclass(frozen=True)
class Template:
    """The document of a case file or a bearing file, from which cases with other values are made.

    Attributes
    ----------
    document : dict
        What the file holds.
    path : Path
        Where it is; the names of other files are relative to it.
    is_bearing : bool
        Whether it holds a bearing rather than a single contact.
    forms : mapping
        The random forms of profiles, by path.
    """

    document: dict[str, Any]
    path: Path
    is_bearing: bool
    forms: Mapping[str, Distribution] = field(default_factory=dict)

    @cached_property
    def known(self) -> Mapping[str, Parameter]:
        """All values that it holds or could hold, by path."""
        return parameters(self.document, bearing_schema() if self.is_bearing else schema())

    def put(self, values: Mapping[str, Any]) -> dict[str, Any]:
        """Return the document with other values, by path."""
        document = self.document
        for path, value in drops_first(values):
            parameter = self.known[path]
            if parameter.unit == FORM:
                value = with_form(document, parameter.keys, self.forms[path], value)  # noqa: PLW2901
            document = parameter.put(document, value)
        return document

    def case(self, values: Mapping[str, Any]) -> Case | BearingCase:
        """Return the case with other values, by path; notes on its files are not repeated.

        Raises
        ------
        CaseError
            If a file could not hold them.
        """
        return self.of_document(self.put(values))

    def is_unloaded(self, values: Mapping[str, Any]) -> bool:
        """Return whether the load is among the values, and zero: what no file may hold, but rows may come down to."""
        return not self.is_bearing and values.get(LOAD) == 0.0

    def of_document(self, document: dict[str, Any]) -> Case | BearingCase:
        """Return the case of a document that has been made of this one.

        Raises
        ------
        CaseError
            If a file could not hold it.
        """
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", AccuracyWarning)
            return (bearing_in if self.is_bearing else case_in)(document, self.path)


@dataclass(frozen=True)
class Plan:
    """A case or a bearing, and what of it is varied.

    Parameters
    ----------
    case : Case or BearingCase
        What is varied.
    over : mapping
        What each path of its file runs over, such as ``{"load.load": "5 kN : 40 kN : 8"}``: a range, a list or an array
        of values, or a distribution to draw samples from. All combinations are rows, the last path changing fastest;
        samples of all distributions are drawn together and come last.
    samples : Sampling
        How samples are drawn.
    quantities : tuple of str
        Names of the numbers that a row holds; the usual ones if empty.
    title : str
        What the study is called.
    path : Path
        The file it was read from.

    Raises
    ------
    InputError
        If a path leads nowhere, or what it runs over is empty, not in its unit, or more than the case allows.

    Examples
    --------
    >>> import tempfile
    >>> from nonhertz.io.casefile import starting_case
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     path = Path(folder, "case.toml")
    ...     _ = path.write_text(starting_case())
    ...     case = read_any(path)
    >>> plan = Plan(case, over={"load.load": "5 kN : 40 kN : 8", "load.tilt": [0.0, "0.5 mrad"]})
    >>> plan.spreads["load.tilt"]
    (0.0, 0.0005)
    """

    case: Case | BearingCase
    over: Mapping[str, Any] = field(default_factory=dict)
    samples: Sampling = field(default_factory=Sampling)
    quantities: tuple[str, ...] = ()
    title: str = ""
    path: Path = field(default=Path("plan.toml"), compare=False)

    def __post_init__(self) -> None:
        if not isinstance(self.case, Case | BearingCase):
            remedy = "read one with nonhertz.read_case or nonhertz.read_bearing"
            raise InputError("case", self.case, "be a case or a bearing case", remedy)
        if not isinstance(self.title, str) or not isinstance(self.path, Path):
            name, kind = ("path", "a Path") if isinstance(self.title, str) else ("title", "text")
            raise InputError(name, getattr(self, name), f"be {kind}", "make the plan with one")
        if not isinstance(self.over, Mapping) or not all(isinstance(path, str) for path in self.over):
            raise InputError("over", self.over, "be a dictionary", "map paths to what they run over")
        if not isinstance(self.samples, Sampling):
            raise InputError("samples", self.samples, "be a Sampling", "make one with nonhertz.study.Sampling")
        names = self.quantities
        if (
            isinstance(names, str)
            or not isinstance(names, Sequence)
            or not all(isinstance(each, str) for each in names)
        ):
            raise InputError("quantities", names, "be names", "give a list of names, such as ['max_pressure']")
        object.__setattr__(self, "quantities", tuple(names))
        object.__setattr__(self, "title", self.title or self.case.title)
        one_line("title", self.title, "give a short name")
        template = Template(self.case.document, self.case.path, isinstance(self.case, BearingCase))
        object.__setattr__(self, "template", template)
        spreads = {path: self.tried(path, given) for path, given in self.over.items()}
        object.__setattr__(self, "spreads", spreads)
        forms = {path: each for path, each in spreads.items() if isinstance(each, Distribution) and each.kind == "form"}
        object.__setattr__(self, "template", replace(template, forms=forms))

    #: What each path runs over: values in its base unit, or a distribution.
    spreads: Mapping[str, Spread] = field(init=False, repr=False, compare=False)
    #: The case's file, with other values wherever a row has them.
    template: Template = field(init=False, repr=False, compare=False)

    def changed(
        self,
        *,
        over: Mapping[str, Any] | None = None,
        samples: Sampling | None = None,
        quantities: tuple[str, ...] | None = None,
    ) -> Plan:
        """Return the plan with other parts; those that are None stay.

        Raises
        ------
        InputError
            As the class does.
        """
        given = {"over": over, "samples": samples, "quantities": quantities}
        changes: dict[str, Any] = {name: value for name, value in given.items() if value is not None}
        return replace(self, **changes) if changes else self

    def tried(self, path: str, given: Any) -> Spread:
        """Return what a path runs over, if the case allows its ends.

        Raises
        ------
        InputError
            As the class does.
        """
        which = parameter(path, self.template.known)
        spread = spread_in(which, given, self.template.document)
        template = replace(self.template, forms={path: spread} if isinstance(spread, Distribution) else {})
        for value in _extremes(spread):
            if self.template.is_unloaded({path: value}):
                continue
            try:
                template.case({path: value})
            except InputError as error:  # of a form
                raise InputError(path, given, f"have a {error.field} to {error.condition}", error.remedy) from None
            except CaseError as error:
                shown = value if isinstance(value, str | bool) else f"{digits(float(value))} {which.unit}".rstrip()
                condition = f"stay within what the case allows (at {shown}: {error.mistakes[0].rstrip('.')})"
                raise InputError(path, given, condition, _WAY_OUT) from None
        return spread


def _extremes(spread: Spread) -> Iterator[Any]:
    """Yield the values of a spread that are tried before the work starts."""
    if isinstance(spread, Distribution):
        yield from spread.ends
    elif len(spread) <= TRIED or any(isinstance(value, str) for value in spread):
        yield from spread
    else:
        yield from (min(spread), max(spread))


def holds_plan(document: Mapping[str, Any]) -> bool:
    """Return whether a document is meant as a plan rather than as a case.

    Examples
    --------
    >>> holds_plan({"case": "roller.toml", "over": {}}), holds_plan({"body": {}, "load": {}})
    (True, False)
    """
    return "case" in document or any(name in document for name in (*TABLES, DESIGN))


def read_any(path: str | Path, changes: Mapping[str, Any] | None = None) -> Case | BearingCase:
    """Return the case or the bearing in a file, whichever it holds, with other values by path.

    Raises
    ------
    CaseError
        With every mistake in the file.
    """
    path = Path(path)
    text = case_text(path, "case file or bearing file")
    return case_or_bearing_in(parsed(text, str(path)), path, text, changes)


def case_or_bearing_in(
    document: dict[str, Any], path: Path, text: str, changes: Mapping[str, Any] | None = None
) -> Case | BearingCase:
    """Return the case or the bearing in a document that has been parsed from a text, with other values by path.

    Raises
    ------
    CaseError
        With every mistake in the document.
    """
    return (bearing_in if holds_bearing(document) else case_in)(document, path, text, changes=changes)


def read_plan(path: str | Path, table: str = "over") -> Plan:
    """Return the plan in a file.

    Parameters
    ----------
    path : str or Path
        A TOML file; see docs/reference/plan-file.md.
    table : {"over", "tolerance"}
        Which of its tables says what is varied: that of sweeps or that of tolerances.

    Raises
    ------
    CaseError
        With every mistake in the file, one sentence each; those of the case it names, with that file's name.
    InputError
        If ``path`` is not the name of a file.
    """
    if not isinstance(path, str | Path):
        raise InputError("path", path, "be the name of a plan file", "give a string or a Path")
    one_of("table", table, TABLES, "name the one that is meant")
    path = Path(path)
    return plan_in(parsed(case_text(path, "plan file", "nonhertz new --plan"), str(path)), path, table)


def plan_in(
    document: dict[str, Any], path: Path, table: str = "over", changes: Mapping[str, Any] | None = None
) -> Plan:
    """Return the plan in a document that has already been parsed; names of files are relative to ``path``.

    All of its tables are read, whichever says what is varied. ``changes`` are values in place of those in the file of
    its case, by path.

    Raises
    ------
    CaseError
        With every mistake in the document.
    """
    held = next((kind for kind, table in (("case", "body"), ("bearing", "bearing")) if table in document), "")
    if held and not holds_plan(document):
        remedy = f"begin with one from 'nonhertz new --plan', and name the {held} file in it"
        raise CaseError([f"{path} must be a plan, and holds a {held}: {remedy}."], [""])
    try:
        found = read(PlanDocument, document)
    except TableError as error:
        raise case_error(in_order(error.mistakes, document)) from None
    file = path.parent / found.case
    with named(file):
        case = read_any(file, changes)
    bare, mistakes = Plan(case), []
    for section in TABLES:
        for varied in getattr(found, section).items():
            mistakes += _mistake(section, bare, *varied)
    try:
        plan = Plan(case, {}, found.samples, found.quantities, found.title or legible(path.stem), path)
    except InputError as error:
        mistakes.append(Mistake((error.field,), error))
    if mistakes:
        raise case_error(mistakes)
    return plan.changed(over=getattr(found, table))


def starting_plan() -> str:
    """Return a commented plan to start from, with a table for each command."""
    return starting_text("starting_plan.toml")


def plan_schema() -> dict[str, Any]:
    """Return the JSON schema of a plan file, with the meaning of every key."""
    return schema_of_file(PlanDocument)


def _mistake(section: str, plan: Plan, path: str, given: Any) -> list[Mistake]:
    """Return what is wrong with what a path runs over."""
    try:
        plan.tried(path, given)
    except InputError as error:
        return [Mistake((section, *path.split(".")), InputError(path, given, error.condition, error.remedy))]
    return []


def read_design(path: str | Path, changes: Mapping[str, Any] | None = None) -> tuple[Case, dict[str, Any]]:
    """Return the case of a plan and what it says about a design: keywords for `nonhertz.design.best`.

    ``changes`` are values in place of those in the file of its case, by path.

    Raises
    ------
    CaseError
        With every mistake in the file.
    InputError
        If ``path`` is not the name of a file.
    """
    if not isinstance(path, str | Path):
        raise InputError("path", path, "be the name of a plan file", "give a string or a Path")
    path = Path(path)
    return design_in(parsed(case_text(path, "plan file", "nonhertz new --plan"), str(path)), path, changes)


def design_in(
    document: dict[str, Any], path: Path, changes: Mapping[str, Any] | None = None
) -> tuple[Case, dict[str, Any]]:
    """Return the case of a plan in a document and what it says about a design.

    Raises
    ------
    CaseError
        With every mistake in the document.
    """
    # All that is wrong with the rest of the plan is said, too.
    case = plan_in(document, path, changes=changes).case
    if not isinstance(case, Case):
        raise CaseError(["case must be that of a single contact for a design: a bearing is swept over."], ["case"])
    found = read(PlanDocument, document)
    given: dict[str, Any] = {"vary": found.vary, "where": found.design.where}
    for name in ("goal", "starts"):
        if getattr(found.design, name) is not None:
            given[name] = getattr(found.design, name)
    if found.design.model is not None:
        given["model"] = model(found.design.model)
    if found.design.loads:
        given["loads"] = found.design.cases
    return case, given
