"""Plan files: a case or a bearing, and the inputs that are varied.

All mistakes in a file are found at once and raised together.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import Any, ClassVar

from nonhertz.amounts import amount, of_dimension
from nonhertz.errors import CaseError, InputError, without_accuracy_warnings
from nonhertz.files.bearingfile import BearingCase
from nonhertz.files.casefile import Case
from nonhertz.files.document import Document, Origin
from nonhertz.files.mistakes import case_error, path_of, sort_by_place
from nonhertz.files.paths import Parameter, drop_before_parameters, find_parameter, list_parameters
from nonhertz.files.plan_document import PlanDocument
from nonhertz.files.reading import read_input
from nonhertz.files.sampling import Sampling
from nonhertz.files.spreads import Distribution, Spread, parse_spread
from nonhertz.files.starting import starting_text
from nonhertz.files.toml import file_kind, is_plan, load_document, name_file_in_errors
from nonhertz.files.writing import document_of
from nonhertz.inputs.checks import check_list, is_number, one_of
from nonhertz.inputs.files import printable_name, relative_path
from nonhertz.inputs.units import begins_with_digits, to_unit

#: The tables of a plan with the inputs that are varied: in a sweep, and within tolerances.
LOAD = "load.load"
_DESIGN = "# nonhertz design: what may be chosen"
_LOADS = (LOAD, "load.approach", "load.radial", "load.axial")
TABLES = ("over", "tolerance")
DESIGN = "vary"
_WAY_OUT = "change these values, or related inputs of the case"
TRIED = 50  # values of a list that are checked before the work starts


@dataclass(frozen=True)
class Template:
    """The document of a case file or a bearing file, from which cases with other values are made.

    Attributes
    ----------
    document : dict
        Contents of the file.
    path : Path
        The file; the names of other files are relative to it.
    is_bearing : bool
        Whether it is a bearing rather than a single contact.
    """

    document: dict[str, Any]
    path: Path
    is_bearing: bool

    @cached_property
    def known(self) -> Mapping[str, Parameter]:
        """All parameters of the document, by path."""
        return list_parameters(self.document, (BearingCase if self.is_bearing else Case).contents)

    def put(self, values: Mapping[str, Any]) -> dict[str, Any]:
        """Return the document with other values, by path."""
        document = self.document
        for path, value in drop_before_parameters(values):
            document = self.known[path].put(document, value)
        return document

    def find_varied(self, path: str, value: Any) -> Parameter:
        """Return the parameter of a path that is varied.

        Raises
        ------
        InputError
            If there is none, or the drop of a profile replaces it in the case.
        """
        varied = find_parameter(path, self.known)
        drop = varied.drop_beside(self.document)
        if drop:
            condition = f"not be varied beside {drop}, which replaces it in the case"
            raise InputError(path, value, condition, "vary that, or remove it from the case")
        return varied

    def case(self, values: Mapping[str, Any]) -> Case | BearingCase:
        """Return the case with other values, by path; notes on its files are not repeated.

        Raises
        ------
        CaseError
            If the case is not valid with these values.
        """
        return self.of_document(self.put(values))

    def is_unloaded(self, values: Mapping[str, Any]) -> bool:
        """Return whether the load is among the values and zero, which rows allow, but not files."""
        return not self.is_bearing and values.get(LOAD) == 0.0

    def of_document(self, document: dict[str, Any]) -> Case | BearingCase:
        """Return the case of a document derived from this one.

        Raises
        ------
        CaseError
            If the case is not valid.
        """
        with without_accuracy_warnings():
            return (BearingCase if self.is_bearing else Case).of(document, self.path)


@dataclass(frozen=True, repr=False)
class Plan(Document):
    """A case or a bearing, and the inputs that are varied.

    Parameters
    ----------
    case : Case or BearingCase
        The case that is varied.
    over : mapping
        The values of each path of its file, such as ``{"load.load": "5 kN : 40 kN : 8"}``: a range, a list or an array
        of values, or a distribution from which samples are drawn. All combinations are rows, the last path changing
        fastest; samples of all distributions are drawn together and come last.
    samples : Sampling
        How samples are drawn.
    quantities : tuple of str
        Names of the quantities in a row; the usual ones if empty.
    limits : mapping
        Limits of quantities in a tolerance study, such as ``{"max_pressure": "at most 3800 MPa"}``.
    title, path, origin
        As of `Document`; the title of the case if there is none.

    Raises
    ------
    InputError
        If a path does not exist, or its values are missing, not in its unit, or not valid in the case.

    Examples
    --------
    >>> import tempfile
    >>> from nonhertz.files.starting import starting_case
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
    limits: Mapping[str, Any] = field(default_factory=dict)
    path: Path = field(default=Path("plan.toml"), compare=False, kw_only=True)

    kind: ClassVar = "plan"

    def __post_init__(self) -> None:
        if not isinstance(self.case, Case | BearingCase):
            remedy = "read one with nonhertz.read_case or nonhertz.read_bearing"
            raise InputError("case", self.case, "be a case or a bearing case", remedy)
        remedies = {"over": "map paths to values", "limits": "map quantities to limits such as 'at most 3800 MPa'"}
        for name, remedy in remedies.items():
            mapping = getattr(self, name)
            if not isinstance(mapping, Mapping) or not all(isinstance(key, str) for key in mapping):
                raise InputError(name, mapping, "be a dictionary", remedy)
        remedy = "give a list of names, such as ['max_pressure']"
        names = tuple(check_list("quantities", self.quantities, "be names", remedy))
        if not all(isinstance(name, str) for name in names):
            raise InputError("quantities", self.quantities, "be names", remedy)
        object.__setattr__(self, "quantities", names)
        super().__post_init__()
        object.__setattr__(self, "title", self.title or self.case.title)
        template = Template(self.case.document, self.case.path, isinstance(self.case, BearingCase))
        object.__setattr__(self, "template", template)
        spreads = {path: self.read_spread(path, values) for path, values in self.over.items()}
        object.__setattr__(self, "spreads", spreads)

    #: Values in the base unit, or a distribution, by path.
    spreads: Mapping[str, Spread] = field(init=False, repr=False, compare=False)
    #: The file of the case, from which rows are made.
    template: Template = field(init=False, repr=False, compare=False)

    @classmethod
    def of(
        cls,
        document: dict[str, Any],
        path: Path,
        text: str | None = None,
        changes: Mapping[str, Any] | None = None,
        table: str = "over",
    ) -> Plan:
        """Return the plan in a document that has already been parsed.

        All of its tables are read, not only ``table``. ``changes`` are values in place of those in the file of its
        case.

        Raises
        ------
        CaseError
            With every mistake in the document.
        """
        kind = file_kind(document)
        if kind and not is_plan(document):
            remedy = f"write a plan, and name the {kind} file in it"
            raise CaseError([f"{path} must be a plan, and holds a {kind}: {remedy}."], [""])
        try:
            contents = read_input(PlanDocument, document)
        except InputError as error:
            wrong = case_error(sort_by_place(error.each, document))
            if "case" in wrong.places:
                raise wrong from None
            try:
                _read_case(document["case"], path, changes)
            except CaseError as other:
                wrong = CaseError([*wrong.mistakes, *other.mistakes], [*wrong.places, *other.places])
            raise wrong from None
        case = _read_case(contents.case, path, changes)
        bare, mistakes = Plan(case), []
        for section in TABLES:
            for varied, values in getattr(contents, section).items():
                try:
                    bare.read_spread(varied, values)
                except InputError as error:
                    mistakes.append(error.about(path_of(tuple(varied.split("."))), values).within(section))
        try:
            title = contents.title or printable_name(path.stem)
            plan = Plan(case, {}, contents.samples, contents.quantities, contents.limits, title=title, path=path)
        except InputError as error:
            mistakes.append(error)
        if mistakes:
            raise case_error(mistakes)
        return plan.changed(over=getattr(contents, table))._with_origin(Origin(document, text, (), path.parent))

    def sections(self) -> dict[str, Any]:
        """Return the sections of its file."""
        parts = {"over": self.over, "samples": self.samples, "quantities": self.quantities, "limits": self.limits}
        rest = {name: table for name, part in parts.items() if (table := document_of(part, defaults=False))}
        return {"case": relative_path(self.path.parent, self.case.path).as_posix()} | rest

    def _written(self, folder: Path) -> dict[str, Any]:
        """Return its document with all tables of its file, and the path of its case relative to a folder."""
        return self.document_in(folder)

    def changed(
        self,
        *,
        over: Mapping[str, Any] | None = None,
        samples: Sampling | None = None,
        quantities: tuple[str, ...] | None = None,
        limits: Mapping[str, Any] | None = None,
    ) -> Plan:
        """Return the plan with other parts; None keeps a part.

        Raises
        ------
        InputError
            As for the class.
        """
        parts = {"over": over, "samples": samples, "quantities": quantities, "limits": limits}
        changes: dict[str, Any] = {name: value for name, value in parts.items() if value is not None}
        return replace(self, **changes) if changes else self

    def read_spread(self, path: str, values: Any) -> Spread:
        """Return the values or the distribution of a path, if its ends are valid in the case.

        Raises
        ------
        InputError
            As for the class.
        """
        which = self.template.find_varied(path, values)
        spread = parse_spread(which, values, self.template.document)
        for value in _values_to_try(spread):
            if self.template.is_unloaded({path: value}):
                continue
            try:
                self.template.case({path: value})
            except CaseError as error:
                shown = value if isinstance(value, str | bool) else str(amount(value, which.unit or ""))
                condition = f"be valid in the case (at {shown}: {error.mistakes[0].rstrip('.')})"
                raise InputError(path, values, condition, _WAY_OUT) from None
        return spread


def _read_case(name: str, plan: Path, changes: Mapping[str, Any] | None) -> Case | BearingCase:
    """Return the case or the bearing that a plan names; raise ``CaseError`` with every mistake in its file."""
    file = plan.parent / name
    with name_file_in_errors(file):
        return read_any(file, changes)


def _values_to_try(spread: Spread) -> Iterator[Any]:
    """Yield the values of a spread that are checked before the work starts."""
    if isinstance(spread, Distribution):
        yield from spread.ends
    elif len(spread) <= TRIED or any(isinstance(value, str) for value in spread):
        yield from spread
    else:
        yield from (min(spread), max(spread))


def read_any(path: str | Path, changes: Mapping[str, Any] | None = None) -> Case | BearingCase:
    """Return the case or the bearing in a file, with other values by path.

    Raises
    ------
    CaseError
        With every mistake in the file.
    """
    return parse_case_or_bearing(*load_document(path, "case", "bearing"), changes)


def parse_case_or_bearing(
    document: dict[str, Any], path: Path, text: str, changes: Mapping[str, Any] | None = None
) -> Case | BearingCase:
    """Return the case or the bearing in a document that has been parsed from a text, with other values by path.

    Raises
    ------
    CaseError
        With every mistake in the document.
    """
    kind = BearingCase if file_kind(document) == "bearing" else Case
    return kind.of(document, path, text, changes=changes)


def read_plan(path: str | Path, table: str = "over") -> Plan:
    """Return the plan in a file.

    Parameters
    ----------
    path : str or Path
        A TOML file; see docs/reference/plan-file.md.
    table : {"over", "tolerance"}
        Its table with the inputs that are varied: for sweeps or for tolerance studies.

    Raises
    ------
    CaseError
        With every mistake in the file, one sentence each; mistakes in its case with the name of that file.
    InputError
        If ``path`` is not the name of a file.
    """
    one_of("table", table, TABLES, "choose one of them")
    return Plan.of(*load_document(path, "plan"), table=table)


def starting_plan(case: Case | BearingCase | None = None, folder: Path = Path()) -> str:
    """Return a commented plan to start from, with a table for each command.

    For a case it varies the load, a diameter and a number of its profile around their values. ``folder`` is that of the
    plan.
    """
    text = starting_text("starting_plan.toml")
    if case is None:
        return text
    template = Template(case.document, case.path, isinstance(case, BearingCase))
    numbers = dict(_list_numbers(template))
    load = next(filter(numbers.__contains__, (*_LOADS, *numbers)))
    diameter = next((path for path in numbers if path.endswith(".diameter")), "")
    profile = next((path for path in numbers if ".profile" in path and template.known[path].unit == "mm"), "")
    loaded, turned = (
        "load" in case.prescribed.keywords,
        not any((template.is_bearing, "moment" in case.prescribed.keywords)),
    )
    name = relative_path(folder, case.path).as_posix()
    around_load = _range_around(template, load, numbers[load], 0.25, 2.0)
    # Replacements of lines of the text, up to their comments; None removes a line.
    own: dict[str, str | None] = {
        "title": f"title = {json.dumps(case.title, ensure_ascii=False)}",
        "case": f"case = {json.dumps(name, ensure_ascii=False)}",
        '"load.load"': f'"{load}" = "{around_load} : 8"',
        '"body.a.diameter"': f'"{diameter}" = "normal(nominal +- 15 um)"'
        if diameter
        else f'"{load}" = "uniform({around_load.replace(" :", ",")})"',
    }
    if loaded:
        half, whole = _range_around(template, load, numbers[load], 0.5, 1.0).split(" : ")
        own["loads"] = f'loads = [{{ load = "{half}" }}, {{ load = "{whole}", tilt = "0.5 mrad" }}]'
    if profile:
        bounds = _widest_range(Plan(case), profile, numbers[profile])
        own['"body.a.profile.amplitude"'] = f'"{profile}" = "{bounds}"'
    if not turned:
        own['"load.tilt"'] = None
    if not all((profile, turned, loaded)):
        text = text.partition(_DESIGN)[0]
    return _replace_lines(text, own).rstrip() + "\n"


def _replace_lines(text: str, lines: Mapping[str, str | None]) -> str:
    """Return a TOML text with lines replaced, by key, keeping their comments; None removes a line."""
    whole = []
    for line in text.splitlines():
        written, _, comment = line.partition("#")
        key = written.partition(" = ")[0]
        replaced = lines.get(key, line)
        if replaced is not None:
            beside = key in lines and comment
            whole.append(f"{replaced:<45} #{comment.partition('; here')[0]}" if beside else replaced)
    return "\n".join(whole)


def _widest_range(plan: Plan, path: str, value: float) -> str:
    """Return a range around a number that is valid in the case."""
    bounds = _range_around(plan.template, path, value, 0.2, 4.0)
    try:
        plan.read_spread(path, f"{bounds} : 2")
    except InputError:  # such as a barrel, whose radius is nearly that of its ring
        return _range_around(plan.template, path, value, 0.8, 1.2)
    return bounds


def _list_numbers(template: Template) -> Iterator[tuple[str, float]]:
    """Yield path and value of the numbers in a document that have a unit and are not zero."""
    for path, known in template.known.items():
        value = known.value_in(template.document)
        if known.unit and (is_number(value) or (isinstance(value, str) and begins_with_digits(value))):
            number = to_unit(path, value, known.unit)
            if number:
                yield path, number


def _range_around(template: Template, path: str, value: float, low: float, high: float) -> str:
    """Return a range around a number, from the lower to the higher value."""
    unit = template.known[path].unit or ""
    return " : ".join(f"{of_dimension((end,), unit):g}" for end in sorted((low * value, high * value)))


def read_design(path: str | Path, changes: Mapping[str, Any] | None = None) -> tuple[Case, dict[str, Any]]:
    """Return the case of a plan, and the keywords for `nonhertz.optimize`.

    ``changes`` are values in place of those in the file of its case, by path.

    Raises
    ------
    CaseError
        With every mistake in the file.
    InputError
        If ``path`` is not the name of a file.
    """
    return parse_design(*load_document(path, "plan"), changes)


def parse_design(
    document: dict[str, Any], path: Path, text: str | None = None, changes: Mapping[str, Any] | None = None
) -> tuple[Case, dict[str, Any]]:
    """Return the case of a plan in a document, and the keywords for `nonhertz.optimize`.

    Raises
    ------
    CaseError
        With every mistake in the document.
    """
    # Mistakes in the rest of the plan are reported as well.
    case = Plan.of(document, path, text, changes=changes).case
    if not isinstance(case, Case):
        raise CaseError(["case must be a single contact for a design: a bearing can only be swept."], ["case"])
    contents = read_input(PlanDocument, document)
    return case, {"bounds": contents.vary} | contents.design.keywords
