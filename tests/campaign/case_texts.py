"""Texts of case and bearing files, sound ones changed at random, each with a number; and what is said of them."""

import contextlib
import random
import re
import time
import warnings
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path

from few_rollers import SPHERICAL, THRUST, changed
from peak import peak_memory
from whole_case import TEXT

from nonhertz.errors import CaseError
from nonhertz.files.bearingfile import read_bearing
from nonhertz.files.bounds import MISTAKES
from nonhertz.files.casefile import Case, read_case
from nonhertz.files.starting import starting_bearing, starting_case
from nonhertz.files.toml import parse

SEED = 20261
MANY = 0.01
# Of texts, share that goes through a file; the others spare the disk.
ON_DISK = 0.05
EXAMPLES = Path(__file__).parents[2] / "examples"
BARRELS = changed(SPHERICAL, ('radial = ["20 kN", "5 kN"]', 'radial = ["20 kN", "5 kN"]\naxial = 6e3'))
WASHERS = changed(
    THRUST,
    ("pitch_diameter = 60", 'pitch_diameter = 60\ndensity = "7.85 g/cm^3"'),
    ("length = 8", 'length = 8\nprofile = { kind = "tabulated", file = "points.csv" }'),
    ("[inner]", "[inner]\ndepth = 4"),
    ('axial = "20 kN"', 'axial_displacement = "5 um"\nmoment = "10 N m"'),
)
FILES = {
    "points.csv": "y, relief\n-10, 0.01\n-3, 0\n3, 0\n10, 0.01\n",
    "trace.txt": "y [mm]; z [um]\n" + "".join(f"{y / 20}; {-(y**2) / 1000}\n" for y in range(-200, 201, 10)),
}
NUMBERS = """
    0 -0.0 1 -1 0.5 2 7 100 101 2000 2001 1e-320 5e-324 1e-300 1e-12 1e-6 1e6 1e12 1e154 1e300
    1.7976931348623157e308 1e309 -1e309 inf -inf nan 9223372036854775807 -9223372036854775809 0b1 0o7 1_000
    1979-05-27 07:32:00
""".split()  # noqa: SIM905
NUMBERS += ["0x" + "f" * 300, "9" * 400, "0x" + "f" * 5000, "9" * 5000, "1e" + "9" * 50, "0." + "1" * 3000]
WORDS = """none mirror calibrated series plane-strain diameter auto steel crown tabulated measured roller ring plate
    20 20\\u0020kg 5\\u0020mm 1e999\\u0020m -5\\u0020um 9**9**9\\u0020mm 1\\u0020mm/mm . .. /dev/zero
    /dev/null /etc/passwd points.csv trace.txt nowhere.csv \\u0000 \\ud7ff \\uffff \\U0010FFFF a\\nb
    \\u001b[31m $x$ ü 漢""".split()  # noqa: SIM905
VALUES = [
    "true",
    "false",
    "[]",
    "{}",
    "[[]]",
    "[1, 2]",
    "['a', 1]",
    "[nan, inf]",
    "{ kind = 'crown' }",
    "''",
    "'''\n'''",
]
LINES = [
    "[",
    "]",
    "[]",
    "=",
    "[body]",
    "[body.a]",
    "[[body]]",
    "[[body.a.profile]]",
    "a.b.c = 1",
    '"" = 1',
    "[a.b]",
    "#",
]
_NUMBER = re.compile(r"(?<![\w.])-?\d[\d.e-]*")
_TEXT = re.compile(r'"[^"\n]*"')
_KEY = re.compile(r"\b[a-z_]+(?= =)")
_VALUE = re.compile(r"(?<== )[^\n]+")


def sound_texts() -> list[str]:
    """Return case files that nothing is wrong with, in a folder that holds `FILES`."""
    names = ("crowned-roller", "cylindrical-roller-bearing", "elliptical-point-contact")
    return [starting_case(), TEXT, *map(_example, names)]


def sound_bearings() -> list[str]:
    """Return the same of bearing files."""
    return [starting_bearing(), *map(_example, ("nu206", "tapered-pair")), BARRELS, WASHERS]


def _example(name: str) -> str:
    return (EXAMPLES / f"{name}.toml").read_text(encoding="utf-8")


class Mutator:
    """Changes texts at random, in one place or in several."""

    def __init__(self, number: int, texts: list[str]) -> None:
        self.random = random.Random(SEED * 1_000_003 + number)
        self.texts = texts

    def text(self) -> str:
        """Return a case file with mistakes, now and then without."""
        text = self.random.choice(self.texts)
        changes: list[Callable[[str], str]] = [self.number, self.word, self.value, self.key, self.line, self.cut]
        changes += [self.characters, self.copy, self.nest]
        for _ in range(self.random.choice([1, 1, 1, 2, 3, 8])):
            text = self.random.choices(changes, [30, 15, 15, 10, 10, 3, 5, 5, 2])[0](text)
        # At last, so that what comes after it need not go through a megabyte.
        return self.many(text) if self.random.random() < MANY else text

    def replaced(self, pattern: re.Pattern[str], text: str, new: str) -> str:
        found = list(pattern.finditer(text))
        if not found:
            return text
        place = self.random.choice(found)
        return text[: place.start()] + new + text[place.end() :]

    def number(self, text: str) -> str:
        magnitude = f"{self.random.choice([-1, 1]) * 10 ** self.random.uniform(-9, 9):.6g}"
        return self.replaced(_NUMBER, text, self.random.choice([magnitude, self.random.choice(NUMBERS)]))

    def word(self, text: str) -> str:
        return self.replaced(_TEXT, text, f'"{self.random.choice(WORDS)}"')

    def value(self, text: str) -> str:
        new = self.random.choice([*VALUES, self.random.choice(NUMBERS), f'"{self.random.choice(WORDS)}"'])
        return self.replaced(_VALUE, text, new)

    def key(self, text: str) -> str:
        other = self.random.choice(_KEY.findall(text) or ["x"])
        return self.replaced(
            _KEY, text, self.random.choice([other, other[:-1], other * 2, '"a b"', "ü", "'a.b'", "a.b"])
        )

    def line(self, text: str) -> str:
        """Move, repeat, drop or put in a line."""
        lines = text.split("\n")
        here, there = self.random.randrange(len(lines)), self.random.randrange(len(lines) + 1)
        taken = self.random.choice([[lines[here]], [lines[here]], [self.random.choice(LINES)]])
        if self.random.random() < 0.4:
            del lines[here]
        lines[there:there] = taken * self.random.choice([0, 1, 1, 2])
        return "\n".join(lines)

    def cut(self, text: str) -> str:
        low, high = sorted(self.random.randrange(len(text) + 1) for _ in range(2))
        return self.random.choice([text[:low], text[low:], text[:low] + text[high:]])

    def characters(self, text: str) -> str:
        for _ in range(self.random.choice([1, 2, 10])):
            here = self.random.randrange(len(text) + 1)
            new = self.random.choice(
                ["", '"', "'", "[", "]", "{", "}", ",", "=", ".", "\n", "\r", "\x00", "\t", "é", "\ufeff"]
            )
            text = text[:here] + new + text[here + 1 :]
        return text

    def copy(self, text: str) -> str:
        low, high = sorted(self.random.randrange(len(text) + 1) for _ in range(2))
        here = self.random.randrange(len(text) + 1)
        return text[:here] + text[low:high] + text[here:]

    def nest(self, text: str) -> str:
        """Put tables or lists within one another, or give a key many parts."""
        depth = self.random.choice([2, 15, 16, 17, 100, 3000])
        nested = ["[" * depth + "]" * depth, "{a = " * depth + "1" + "}" * depth, "[{a = " * depth + "1" + "}]" * depth]
        if self.random.random() < 0.5:
            return self.replaced(_VALUE, text, self.random.choice(nested))
        parts = ".".join(self.random.choice(["a", '"a b"', "1"]) for _ in range(depth))
        return self.random.choice([f"{parts} = 1\n{text}", f"{text}\n[{parts}]\n", f"{text}\n[[{parts}]]\n"])

    def many(self, text: str) -> str:
        """Repeat something so often that it meets a bound, or is just below one."""
        count = int(10 ** self.random.uniform(1, 5.5))
        tables = "{ kind = 'crown', radius = 4000.0 }," * min(count, 30_000)
        return self.random.choice([
            "".join(f"key{n} = {n}\n" for n in range(min(count, 60_000))) + text,
            text + "".join(f"\n[t{n}]" for n in range(min(count, 60_000))),
            text + "\n[[life.spectrum]]\nload = 1\nshare = 0.1" * min(count, 30_000),
            self.replaced(re.compile(r"(?<=profile = )[^\n]+"), text, f"[{tables}]"),
            self.replaced(_VALUE, text, f"[{'0.5, ' * min(count, 150_000)}]"),
            self.replaced(_VALUE, text, "'" + "x" * count + "'"),
            self.replaced(_KEY, text, "x" * count),
            text + "#" * 4 * count,
        ])  # fmt: skip


@dataclass
class Outcome:
    """What came of many texts: how many were sound, what was amiss, and what the dearest cost."""

    counts: Counter[str] = field(default_factory=Counter)
    amiss: list[str] = field(default_factory=list)
    slowest: tuple[float, int] = (0.0, -1)
    memory: float = 0.0


def case_complaints(file: Path | bytes) -> tuple[str, ...]:
    """Return what is said of a case file or of the bytes in one."""
    with _said() as said:
        if isinstance(file, Path):
            read_case(file)
        else:
            Case.of(parse(file.decode("utf-8-sig", "replace"), "case.toml"), Path("case.toml"))
    return tuple(said)


def bearing_complaints(file: Path | bytes) -> tuple[str, ...]:
    """Return what is said of a bearing file, or what is wrong with the file that a sound one is written to."""
    path, again = Path("bearing.toml"), Path("again.toml")
    if isinstance(file, bytes):
        path.write_bytes(file)
    with _said() as said:
        case = read_bearing(path)
        case.write(again)
        same = read_bearing(again)
        if (same.bearing, same.prescribed) != (case.bearing, case.prescribed):
            said.append("Error: written, it is not the same again")
    return tuple(said)


@contextlib.contextmanager
def _said() -> Iterator[list[str]]:
    """Gather mistakes; an error of another kind goes by its name."""
    said: list[str] = []
    try:
        yield said
    except CaseError as error:
        said += error.mistakes or ("no mistake is named",)
    except Exception as error:  # noqa: BLE001  (whatever it is, it is what is looked for)
        said.append(f"{type(error).__name__}: {error}")


KINDS = {"case": (sound_texts, case_complaints), "bearing": (sound_bearings, bearing_complaints)}


def read_all(numbers: range, folder: str, kind: str) -> Outcome:
    """Read the files of a kind of these numbers in a folder of their own, and return what came of them."""
    home = Path(folder, f"{numbers.start}")
    home.mkdir()
    for name, content in FILES.items():
        (home / name).write_text(content, encoding="utf-8")
    sound, complaints = KINDS[kind]
    outcome, texts, path = Outcome(), sound(), home / "changed.toml"
    with contextlib.chdir(home), warnings.catch_warnings():
        warnings.simplefilter("ignore")
        # What goes on to a person as a warning must have been meant for one.
        warnings.simplefilter("error", RuntimeWarning)
        outcome.amiss += (f"sound: {each}" for text in texts for each in complaints(text.encode()))
        for number in numbers:
            mutator = Mutator(number, texts)
            text = mutator.text().encode("utf-8", "surrogatepass")
            on_disk = kind == "case" and mutator.random.random() < ON_DISK
            if on_disk:
                path.write_bytes(text)
            begun = time.process_time()
            found = complaints(path if on_disk else text)
            outcome.slowest = max(outcome.slowest, (time.process_time() - begun, number))
            outcome.counts["refused" if found else "sound"] += 1
            outcome.amiss += (f"{number}: {each[:300]!r}" for each in found if not is_sentence(each))
            if len(found) > MISTAKES + 1:
                outcome.amiss.append(f"{number}: {len(found)} mistakes")
    outcome.memory = peak_memory()
    return outcome


def is_sentence(text: str) -> bool:
    """Return whether a complaint is one: on one line, ended, and no longer than a person reads."""
    return (
        text.endswith((".", "?"))
        and "\n" not in text
        and len(text) < 1000
        and not text.partition(":")[0].endswith("Error")
    )
