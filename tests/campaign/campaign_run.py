"""Runs cases of a campaign, each alone and among many."""

import time
import traceback
import warnings
from collections import defaultdict
from dataclasses import dataclass, field
from pathlib import Path

import plain_case
from extreme_cases import random_case
from own_theory import kernel
from pool import of_each
from verdict import sentence_faults, solution_faults, without_numbers

import nonhertz as nh

SLOWEST, FEW_STRIPS = 5.0, 400  # seconds of processor, up to so many strips


@dataclass
class Ending:
    """How one solve ended."""

    kind: str
    words: str
    solution: object = None
    error: BaseException | None = None
    seconds: float = 0.0


@dataclass
class Record:
    """What became of one case."""

    number: int
    kind: str
    words: str = ""
    call: str = ""
    seconds: float = 0.0
    faults: list = field(default_factory=list)
    warned: list = field(default_factory=list)


def solved(case):
    """Solve a case, whatever happens."""
    start = time.process_time()
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        warnings.simplefilter("ignore", nh.AccuracyWarning)
        try:
            contact, keywords = plain_case.arguments(case)
            ending = Ending("solved", "", nh.solve(contact, **keywords))
        except nh.InputError as error:
            ending = Ending("refused", without_numbers(f"{error.field} must {error.condition}"), error=error)
        except nh.ConvergenceError as error:
            ending = Ending("unconverged", without_numbers(str(error)), error=error)
        except Exception as error:  # noqa: BLE001  (what the campaign looks for)
            ending = Ending("crash", without_numbers(f"{type(error).__name__}: {error}"), error=error)
    ending.seconds = time.process_time() - start
    return ending


def faults_of(case, ending):
    """Faults of one ending by itself."""
    if ending.kind == "crash":
        where = traceback.extract_tb(ending.error.__traceback__)[-1]
        return [(f"crash {ending.words[:120]}", f"{Path(where.filename).name}:{where.lineno} {where.name}")]
    faults = solution_faults(ending.solution, case) if ending.solution is not None else []
    if ending.error is not None:
        faults = sentence_faults(ending.error, case)
    if ending.seconds > SLOWEST and _strips(case) <= FEW_STRIPS:
        faults.append(("slow", f"{ending.seconds:.1f} s"))
    return faults


def _strips(case):
    strips = case["strips"]
    return 0 if strips is None else strips if isinstance(strips, int) else len(strips) - 1


def examined(case, number):
    """Solve a case alone and among many, and return the record."""
    start = time.perf_counter()
    ending = solved(case)
    faults = faults_of(case, ending)
    if ending.kind != "crash":
        faults += many_faults(case, ending)
    warned = [] if ending.solution is None else [one.kind for one in ending.solution.findings]
    words = "" if ending.solution is not None else f"{ending.words} | {ending.error}"
    seconds = time.perf_counter() - start
    return Record(number, ending.kind, words, plain_case.call_text(case), seconds, faults, warned)


def many_faults(case, ending):
    """Solve the case twice in a batch with one that cannot be solved, and compare."""
    cases = [case, case, _impossible(case)]
    endings = [ending, ending, solved(cases[2])]
    try:
        contacts = [plain_case.arguments(one)[0] for one in cases]
    except nh.InputError:  # there is no such contact
        return []
    given = {name: [one["given"][name] for one in cases] for name in case["given"]}
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        warnings.simplefilter("ignore", nh.AccuracyWarning)
        try:
            many = nh.solve_many(contacts, **given, element=plain_case.element(case), strips=case["strips"], threads=1)
            failures = many.failures
        except nh.InputError as error:
            alone = [one for one in endings if one.kind == "refused"]
            if any(str(one.error) in str(error) or one.error.field.split(".")[-1] in error.field for one in alone):
                return []
            return [("many: refused as a whole", str(error))]
        except Exception as error:  # noqa: BLE001  (what the campaign looks for)
            where = traceback.extract_tb(error.__traceback__)[-1]
            words = without_numbers(f"{type(error).__name__}: {error}")[:120]
            return [(f"many: crash {words}", f"{where.name}:{where.lineno}")]
        faults = []
        for row, (one, alone) in enumerate(zip(cases, endings, strict=True)):
            faults += [
                (f"many: {kind}", f"row {row} {detail}")
                for kind, detail in _row_faults(many, row, failures, one, alone)
            ]
        return faults


def _impossible(case):
    """The same case with a load that no body can bear, or bodies that never meet."""
    given = dict(case["given"])
    if "approach" in given:
        given["approach"] = -abs(given["approach"]) - 1e9
    else:
        given["load"] = given["load"] * 1e12
    return {**case, "given": given}


def _row_faults(many, row, failures, case, alone):
    if alone.kind == "crash":
        return []
    if row in failures:
        error = failures[row]
        words = without_numbers(
            f"{error.field} must {error.condition}" if isinstance(error, nh.InputError) else str(error)
        )
        return [] if words == alone.words else [(f"failed where it was {alone.kind}", f"{words} | {alone.words}")]
    found = many[row]
    if alone.solution is None:
        # Documented: a case that starts from its neighbour may be solved where it would fail alone.
        if alone.kind == "unconverged" and case["strips"] is not None:
            return [(kind, detail) for kind, detail in solution_faults(found, case) if "without a word" not in kind]
        return [(f"solved where it was {alone.kind}", alone.words)]
    wanted, faults = alone.solution, []
    spare = 0.0 if case["strips"] is None else 1e-6
    reach = 0.5 * (wanted.contact_y[-1][1] - wanted.contact_y[0][0])
    farthest = max(abs(wanted.contact_y[0][0]), abs(wanted.contact_y[-1][1]))
    beside = {"moment": wanted.load * farthest, "tilt": float(wanted.interference.max()) / reach}
    for name in ("approach", "tilt", "load", "moment", "max_pressure"):
        one, other = getattr(found, name), getattr(wanted, name)
        scale = abs(other) + beside.get(name, 0.0)
        if not abs(one - other) <= spare * scale:
            faults.append((f"{name} differs", f"{one!r} for {other!r}"))
        # The columns are summed in another order.
        if not abs(float(getattr(many, name).ravel()[row]) - one) <= 1e-13 * scale:
            faults.append((f"column {name} is not the solution's", ""))
    if case["strips"] is not None and (row in many.warnings) != bool(wanted.warnings):
        faults.append(("warned of alone or among many only", f"{many.warnings.get(row)} | {wanted.warnings}"))
    return faults


def case_record(number):
    """The record of one numbered case; what goes wrong in the campaign itself is one too."""
    try:
        return examined(random_case(number), number)
    except Exception:  # noqa: BLE001  (a checker that fails must not hide the other cases)
        return Record(number, "campaign", faults=[("the campaign itself failed", traceback.format_exc()[-1500:])])


def warm_up():
    """Load everything, and make the tables, so that no case is slow because of it."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        body = nh.Roller(diameter=20.0, length=20.0, profile=nh.profile.chamfer(20.0, 0.5))
        for element in (nh.SEMI_ELLIPTIC, nh.PARABOLIC):
            kernel(element.name)
            for strips in (None, 20):
                nh.solve(nh.Contact(body, nh.Ring(diameter=80.0)), load=2e3, tilt=1e-4, element=element, strips=strips)
                nh.solve_many(
                    nh.Contact(body, nh.Plate()), load=[2e3, 3e3], moment=10.0, element=element, strips=strips
                )


def records(numbers):
    """The records of all numbers."""
    return of_each(case_record, numbers, "spawn", initializer=warm_up)


def grouped(found):
    """Text: endings, warnings, and faults by kind with the shortest call of each."""
    endings, warned, faults = defaultdict(int), defaultdict(int), defaultdict(list)
    for record in found:
        endings[f"{record.kind} {record.words.split(' | ')[0]}"[:150]] += 1
        for sentence in set(record.warned):
            warned[sentence] += 1
        for kind, detail in record.faults:
            faults[kind].append((len(record.call), record.number, detail, record.call, record.words))
    lines = ["## Endings"] + [f"{count:7} {kind}" for kind, count in sorted(endings.items(), key=lambda one: -one[1])]
    lines += ["", "## Warnings"] + [
        f"{count:7} {one}" for one, count in sorted(warned.items(), key=lambda one: -one[1])
    ]
    lines += ["", "## Faults"]
    for kind, cases in sorted(faults.items(), key=lambda one: -len({case[1] for case in one[1]})):
        _, number, detail, call, words = min(cases)
        numbers = sorted({case[1] for case in cases})
        lines += [
            f"### {len(numbers)} x {kind}",
            f"numbers {numbers[:12]}",
            f"smallest, {number}: {detail} {words}",
            f"    {call}",
            "",
        ]
    seconds = sorted(record.seconds for record in found)
    if seconds:
        lines.append(f"seconds per case: median {seconds[len(seconds) // 2]:.3f}, longest {seconds[-1]:.1f}")
    return "\n".join(lines)
