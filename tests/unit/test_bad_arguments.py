"""Every public function and method against wrong types and values: the right answer or one sentence, nothing else."""

import importlib
import inspect
import types
import typing
from collections.abc import Callable
from enum import Enum
from typing import Any

import numpy as np
import pytest
from numpy.typing import ArrayLike

import nonhertz as nh
from nonhertz import bearing, hertz, life, measured, profile, strength, subsurface
from nonhertz.inputs import checks, descriptions

pytestmark = pytest.mark.filterwarnings("ignore::nonhertz.AccuracyWarning")

NONSENSE: dict[str, Any] = {
    "none": None,
    "text": "abc",
    "empty text": "",
    "true": True,
    "nan": float("nan"),
    "inf": float("inf"),
    "minus inf": -float("inf"),
    "huge": 1e308,
    "tiny": 1e-320,
    "minus one": -1.0,
    "zero": 0,
    "three": 3,
    "half": 0.5,
    "empty": [],
    "row": [1.0, 2.0, 3.0],
    "square": [[1.0, 2.0], [3.0, 4.0]],
    "ragged": [[1.0], [2.0, 3.0]],
    "mixed": [1.0, None],
    "words": ["a"],
    "row with nan": [1.0, float("nan")],
    "complex": 1j,
    "complex array": np.array([1j]),
    "array": np.array(1.0),
    "array of three": np.array([1.0, 2.0, 3.0]),
    "speed": "3000 rpm",
    "distance": "3 mm",
    "force": "3 kN",
    "dictionary": {},
    "object": object(),
    "function": lambda *_: None,
}
ALL = set(NONSENSE)
TEXTS = {"text", "empty text", "speed", "distance", "force"}
NO_VALUE = {"object", "complex"}
NO_NUMBER = {"text", "empty text", "true", "nan", "complex", "complex array", "dictionary", "object", "function"}
NO_NUMBERS = NO_NUMBER | {"none", "ragged", "mixed", "words", "row with nan"}
NUMBER = NO_NUMBERS | {"inf", "minus inf", "huge", "empty", "row", "square"}
POSITIVE = NUMBER | {"minus one", "zero", "tiny"}
COUNT = NUMBER | {"minus one", "half"}
#: What must be refused of an argument by its type; of other types it must only not end in an error of another kind.
OF_TYPE: dict[Any, set[str]] = {
    bool: ALL - {"true"},
    float: NUMBER,
    int: COUNT,
    str: ALL,
    nh.study.Sampling: ALL - {"dictionary"},  # of keywords
    ArrayLike: NO_NUMBERS | {"inf", "minus inf", "huge"},
    ArrayLike | None: (NO_NUMBERS | {"inf", "minus inf", "huge"}) - {"none"},
}
SIZES = (
    "bore", "cell", "compliance", "contamination", "cutoff", "diameter", "dynamic", "exponent", "inner_raceway",
    "length", "limit", "line_load", "load", "load_rating", "material_factor", "outer_raceway", "pitch_diameter",
    "raceway_diameter", "radius", "reach", "relative_limit", "reliability", "slope", "static", "viscosity",
    "viscosity_ratio", "width",
)  # fmt: skip
NUMBERED = ("dimensions", "laminae", "rollers", "rows", "samples", "threads", "tilts", "workers")
#: By its name, where the type does not say it.
OF_NAME = {
    **dict.fromkeys(SIZES, POSITIVE),
    **dict.fromkeys(("contact_angle", "depth_exponent", "fatigue_limit"), NUMBER | {"minus one"}),
    **dict.fromkeys(NUMBERED, COUNT | {"zero"}),
    **dict.fromkeys(("contacts", "element", "path", "plan", "quantity", "ring", "solution"), ALL),
    "load": POSITIVE - {"huge", "tiny"},
    "within": POSITIVE - {"inf"},
    "accuracy": ALL - {"array", "half", "tiny"},
    "callback": ALL - {"function"},
    "out": ALL - TEXTS,
    "strips": ALL - {"three", "row", "array of three"},
}


def of_field(each: descriptions.Description) -> set[str]:
    """Return what the description of a field refuses."""
    words = getattr(each, "words", ())
    match each:
        case descriptions.Quantity(condition=checks.above_zero):
            return NUMBER - {"huge"} | {"minus one", "zero"}
        case descriptions.Quantity(condition=condition):
            more = (
                POSITIVE
                if condition is checks.positive
                else {"minus one"}
                if condition is checks.not_negative
                else set()
            )
            # What may be endless has a condition of its own.
            own = (
                {"inf", "function"} if condition not in (checks.finite, checks.positive, checks.not_negative) else set()
            )
            return (NUMBER | more) - ({"function"} if words else set()) - own
        case descriptions.Word():
            return ALL if words else ALL - TEXTS
    kinds = {
        descriptions.Count: COUNT,
        descriptions.Flag: OF_TYPE[bool],
        descriptions.Quantities: NO_NUMBERS,
        descriptions.Part: ALL,
    }
    if isinstance(each, descriptions.Count) and each.least > 0:
        return COUNT | {"zero"}
    return kinds.get(type(each), NO_VALUE)


def of_annotation(name: str, kind: Any) -> set[str]:
    """Return what a name or a type refuses; of several types nothing that one of them takes."""
    plain = {float, int, float | None, int | None}
    if name in OF_NAME and (kind in plain or name not in (*SIZES, *NUMBERED, "contact_angle")):
        return OF_NAME[name]
    if kind in OF_TYPE:
        return OF_TYPE[kind]
    if typing.get_origin(kind) is typing.Literal:
        return ALL
    if isinstance(kind, types.UnionType) or typing.get_origin(kind) is typing.Union:
        return set.intersection(*(of_annotation(name, each) for each in typing.get_args(kind)))
    if kind is type(None):
        return ALL - {"none"}
    ours = isinstance(kind, type) and kind.__module__.startswith("nonhertz")
    return ALL if ours and not getattr(kind, "_is_protocol", False) else set() if kind is Any else NO_VALUE


def refused(call: Callable[..., Any], name: str, parameter: inspect.Parameter) -> set[str]:
    """Return what must be refused of an argument."""
    of = getattr(call, "descriptions", None) or getattr(profile.PARAMETERS.get(kind_of(call)), "descriptions", {})
    found = of_field(of[name]) if name in of else of_annotation(name, parameter.annotation)
    if parameter.annotation is str and inspect.isclass(call):  # a name or a title
        found = found - TEXTS
    return found - {"none"} if parameter.default is None else found


def kind_of(call: Callable[..., Any]) -> str:
    return getattr(call, "__name__", "").replace("_", "-")


MODULES = {
    "": nh,
    "bearing.": bearing,
    "hertz.": hertz,
    "life.": life,
    "measured.": measured,
    "profile.": profile,
    "strength.": strength,
    "study.": nh.study,
    "subsurface.": subsurface,
}
#: Of these only what must be refused is tried.
SLOW = {
    "bearing.from_catalogue", "bearing.maps", "bearing.volume_life", "compare", "contact_map", "life.assess",
    "life.exposure", "life.overrolled", "measured.fit", "measured.fit_best", "measured.prepare", "strength.assess",
    "optimize", "pareto", "study.diagram", "subsurface.extremes", "sweep", "tolerance",
}  # fmt: skip
#: Of these not even what is taken; other tests solve them.
SLOWEST = {
    "bearing.maps",
    "bearing.volume_life",
    "life.exposure",
    "life.overrolled",
    "optimize",
    "pareto",
    "strength.assess",
}
#: What takes any keyword and refuses those that it does not know itself.
BY_THEMSELVES = {"life.model", "measured.fit", "profile.with_drop"}
#: They would write files of nonsensical names; in tests/unit/test_written.py.
WRITING = {"load", "read", "write", "save"}
#: Asked by the package, of positions that it has checked, of documents and bearings that it has read or solved.
ASKED = {
    "apply", "between", "contents_of", "curvature_at", "document_in", "draw", "drop_at", "exactly",
    "likely", "moved", "of", "partials", "rated", "relief_at", "scaled", "separation_at", "unchecked", "with_entry",
}  # fmt: skip
#: Made by the package and not by its users, who only read them.
RESULTS = {
    "strength.Check", "strength.Strength", "strength.CheckStatus", "study.Measure",
    "Comparison", "ContactMap", "Chunk", "study.Progress", "study.Sweep", "study.Tolerance", "study.Diagram",
    "study.Band", "study.Design", "study.Front", "study.Limit", "study.Start",
    "study.Index", "study.Quantile", "study.Capability", "study.Gradient", "study.Partials",
    "EdgeKind", "EdgePressure", "ErrorEstimate", "Result", "SingularEnd", "Solution", "Solutions",
    "Status",
    "hertz.LineContact", "hertz.PointContact",
    "bearing.BearingLife", "bearing.BearingMaps", "bearing.BearingSolution",
    "bearing.BearingSolutions", "bearing.CatalogueGuess", "bearing.ContactFilm", "bearing.Films",
    "bearing.Friction", "bearing.InterferenceFit", "bearing.Kinematics",
    "bearing.ClearanceRanges", "bearing.OperatingClearance", "bearing.Range", "bearing.Tolerances",
    "bearing.Rating", "bearing.RingShape", "bearing.Row",
    "bearing.ForceTable", "bearing.UnrolledPressure",
    "bearing.VolumeLife",
    "life.Exposure", "life.Life", "life.Overrolled",
    "measured.ProfileFit", "measured.Roughness", "measured.StepResult",
    "subsurface.Extreme", "subsurface.Extremes", "subsurface.Field", "subsurface.Passage",
    "AccuracyWarning", "CaseError", "ConvergenceError", "InputError", "Interrupted", "NonhertzError",
    *(f"profile.{name}" for name in (
        "Arcs", "Conical", "Logarithmic", "Profile", "Straight", "Sum", "Tabulated", "Transformed",
        "ProfileKind", "TaperedEnds", "UniformPressure",
    )),
}  # fmt: skip
#: Python's own errors, of what is subscripted, and those of a file as a whole.
OTHERS = (IndexError, KeyError, nh.CaseError)


@pytest.fixture(scope="module")
def given():
    """The module of arguments, which is imported when the tests begin: it solves what they need."""
    return importlib.import_module("public_arguments")


def public(module: str, *, classes: bool) -> dict[str, Any]:
    """Return the classes or the functions of a module that are ours, by their names."""
    found, test = MODULES[module], inspect.isclass if classes else inspect.isfunction
    values = {name: getattr(found, name) for name in getattr(found, "__all__", dir(found)) if not name.startswith("_")}
    home = "nonhertz" if hasattr(found, "__all__") or found is nh else found.__name__
    own = {name: each for name, each in values.items() if test(each) and each.__module__.startswith(home)}
    return {name: each for name, each in own.items() if found is nh or getattr(nh, name, None) is not each}


def methods_of(cls: type) -> list[str]:
    """Return the names of the public methods that take arguments."""
    found = []
    for name, each in inspect.getmembers(cls, lambda each: inspect.isfunction(each) or inspect.ismethod(each)):
        named = name in {"__call__", "__getitem__"} or not name.startswith("_")
        if named and name not in WRITING | ASKED and parameters(each).keys() - {"self"}:
            found.append(name)
    return found


def entries(module: str, given: Any) -> dict[str, Callable[..., Any]]:
    """Return all that is called: functions, inputs and methods of instances."""
    found = public(module, classes=False) | public(module, classes=True)
    found = {module + name: each for name, each in found.items() if module + name not in RESULTS}
    for instance in given.INSTANCES.get(module, []):
        for name in methods_of(type(instance)):
            found[f"{module}{type(instance).__name__}.{name}"] = getattr(instance, name)
    return found


def good_arguments(name: str, call: Callable[..., Any], given: Any) -> dict[str, Any]:
    """Return arguments that are taken: those of the function, or of their names where there is no default."""
    known = given.GOOD | given.OTHERWISE.get(name, {})
    return {each: known[each] for each in parameters(call) if each in known} | given.OTHERWISE.get(name, {})


def parameters(call: Callable[..., Any]) -> dict[str, inspect.Parameter]:
    try:
        found = inspect.signature(call, eval_str=True).parameters
    except NameError:  # of a type that is imported for type checkers alone
        found = inspect.signature(call).parameters
    return {name: each for name, each in found.items() if each.kind not in (each.VAR_KEYWORD, each.VAR_POSITIONAL)}


@pytest.mark.parametrize("module", MODULES)
def test_the_good_arguments_are_taken_and_unknown_keywords_refused_by_name(module, given):
    for name, call in entries(module, given).items():
        arguments = good_arguments(name, call, given)
        if name not in SLOWEST:
            call(**arguments)
        with pytest.raises((TypeError, *[nh.InputError] * (name in BY_THEMSELVES)), match="unknown_keyword"):
            call(**arguments, unknown_keyword=1)


@pytest.mark.parametrize("module", MODULES)
def test_nonsense_ends_in_the_right_answer_or_in_one_sentence(module, given):
    wrong = []
    for name, call in entries(module, given).items():
        arguments = good_arguments(name, call, given)
        for argument, parameter in parameters(call).items():
            no = refused(call, argument, parameter)
            for what, value in NONSENSE.items():
                if name not in SLOW or what in no:
                    ended = how_ends(call, arguments | {argument: value})
                    if ended and not (ended == "taken" and what not in no):
                        wrong.append(f"{name}: {argument} = {what}: {ended}")
    assert not wrong, "\n".join(wrong)


def how_ends(call, arguments):
    """Return what is wrong with the end of a call, "taken" where it returns, or nothing where it refuses well."""
    try:
        call(**arguments)
    except nh.InputError as error:
        said = str(error)
        return "" if (" must " in said or said.startswith("Unknown ")) and len(said.splitlines()) == 1 else said
    except (nh.ConvergenceError, *OTHERS):
        return ""
    except Exception as error:  # noqa: BLE001  (whatever it is, it is wrong)
        return repr(error)
    return "taken"


@pytest.mark.parametrize("module", MODULES)
def test_every_class_whose_methods_take_arguments_has_an_instance(module, given):
    known = {type(each) for each in given.INSTANCES.get(module, [])}
    for name, cls in public(module, classes=True).items():
        if module == "measured." or issubclass(cls, Exception | Enum | nh.profile.Profile):
            continue
        for method in methods_of(cls):
            functions = {getattr(each, method, None) for each in known}
            assert any(issubclass(each, cls) for each in known) or getattr(cls, method) in functions, (name, method)


def test_options_that_verbs_hand_on(given):
    for verb in (subsurface.stress, subsurface.extremes, strength.assess, life.exposure):
        for option, value in (("body", "c"), ("threads", 0), ("threads", 1.5), ("callback", 3)):
            with pytest.raises(nh.InputError, match=f"^{option} = "):
                verb(
                    given.SOLUTION, **{option: value}, **dict.fromkeys("xyz", 0.0) if verb is subsurface.stress else {}
                )
    with pytest.raises(TypeError, match=r"passage\(\) got an unexpected keyword argument 'displacement'"):
        subsurface.passage(given.SOLUTION, 0.0, 0.1, displacement=True)
    with pytest.raises(TypeError, match=r"extremes\(\) got an unexpected keyword argument 'displacement'"):
        subsurface.extremes(given.SOLUTION, displacement=True)


def test_shares_out_of_range_and_what_is_no_spectrum_are_refused(given):
    solution = given.SOLUTION
    for share in (1e308, 1e300, float("inf"), float("nan"), -1.0, None, "half"):
        with pytest.raises(nh.InputError, match=r"^share = "):
            life.assess([(solution, share), (solution, share)], "iso-16281", body="b")
    for pairs in ([], [solution], [(solution,)], [(1.0, solution)], [(None, 1.0)], "ab", None, 3):
        with pytest.raises(nh.InputError, match=r"^solution = "):
            life.assess(pairs, "iso-16281", body="b")


def test_an_impossible_raceway_is_refused(given):
    with pytest.raises(nh.InputError, match=r"pitch_diameter = 5\.0 must exceed the roller's diameter of 10 mm"):
        life.Raceway(10.0, 9.6, 5.0, True)
    with pytest.raises(nh.InputError, match="rollers = 21 must be a whole number from 1 to 20"):
        given.RACEWAY.load_rating(21)
