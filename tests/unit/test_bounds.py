"""What a case file may hold at most, and that nothing is read, parsed or looked at beyond that."""

import os
import re
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

import nonhertz as nh
from nonhertz.errors import CaseError
from nonhertz.files import reading
from nonhertz.files.bounds import KEYS, LARGEST_CASE, LOADS, MISTAKES, NESTING, PROFILES, has_long_key
from nonhertz.files.casefile import read_case
from nonhertz.files.toml import parse
from nonhertz.model.profile import table
from nonhertz.model.profile.table import LARGEST_FILE, from_file

BODIES = "[body.a]\ndiameter = 20.0\nlength = 20.0\n{keys}\n[body.b]\n"
LOAD = "[load]\nload = 20000.0\n"
CASE = BODIES.format(keys="") + LOAD
posix = pytest.mark.skipif(os.name != "posix", reason="devices and pipes are files")
NO_FILES = ("/dev/zero", "pipe")
GUARD = 120  # s, against hanging for ever


def mistakes_in(folder: Path, text: str) -> tuple[str, ...]:
    path = folder / "case.toml"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(CaseError) as caught:
        read_case(path)
    return tuple(each.removeprefix(str(path)).strip() for each in caught.value.mistakes)


READING = """
import resource, sys
resource.setrlimit(resource.RLIMIT_AS, (2 * 10**9, 2 * 10**9))
from nonhertz.errors import CaseError
from nonhertz.files.casefile import read_case
for name in sys.argv[1:]:
    try:
        read_case(name)
    except CaseError as error:
        print(*error.mistakes, sep="\\n")
"""


@posix
@pytest.mark.slow
def test_devices_and_pipes_are_neither_read_to_their_end_nor_named_by_a_case(tmp_path):
    """In a process of 2 GB at most: a pipe that nobody writes to is an empty case, what names one is refused."""
    os.mkfifo(tmp_path / "pipe")
    tables = [f"{{ kind = '{kind}', file = '{name}' }}" for kind in ("tabulated", "measured") for name in NO_FILES]
    (tmp_path / "case.toml").write_text(BODIES.format(keys=f"profile = [{', '.join(tables)}]") + LOAD)
    names = ["/dev/zero", str(tmp_path / "case.toml"), str(tmp_path / "pipe")]
    said = subprocess.run(
        [sys.executable, "-c", READING, *names], capture_output=True, text=True, check=True, timeout=GUARD,
        env=os.environ | {"PYTHONPATH": str(Path(nh.__file__).parents[1]), "OPENBLAS_NUM_THREADS": "1"},
    ).stdout.splitlines()  # fmt: skip
    assert said[0] == "/dev/zero must be readable (larger than 1 MB): put measured points into a file that it names."
    for number, (sentence, name) in enumerate(zip(said[1:5], NO_FILES * 2, strict=True), start=1):
        assert sentence.startswith(f"body.a.profile[{number}].file = '{name}' must ")
        assert "not a device or a pipe" in sentence
    assert said[5].startswith("body must be given")


@posix
def test_a_case_comes_through_a_pipe():
    read, write = os.pipe()
    os.write(write, CASE.encode())
    os.close(write)
    try:
        assert read_case(f"/dev/fd/{read}").prescribed.keywords == {"load": 20000.0}
    finally:
        os.close(read)


def test_a_case_file_has_a_largest_size(tmp_path):
    largest = CASE + "#" * (LARGEST_CASE - len(CASE))
    (tmp_path / "case.toml").write_text(largest)
    assert read_case(tmp_path / "case.toml").prescribed.keywords == {"load": 20000.0}
    assert mistakes_in(tmp_path, largest + "#") == (
        "must be readable (larger than 1 MB): put measured points into a file that it names.",
    )


def test_a_tabulated_file_has_a_largest_size(tmp_path):
    path = tmp_path / "points.csv"
    path.write_text("0 0\n1 0\n" + "#" * (LARGEST_FILE - 8))
    assert from_file(path).extent == (0.0, 1.0)
    path.write_text("0 0\n1 0\n" + "#" * (LARGEST_FILE - 7))
    with pytest.raises(nh.InputError, match=re.escape("larger than 5 MB): export fewer points")):
        from_file(path)


def test_a_tabulated_file_has_most_points(tmp_path, monkeypatch):
    monkeypatch.setattr(table, "MOST_POINTS", 3)
    path = tmp_path / "points.csv"
    path.write_text("0 0\n1 0\n2 0\n")
    assert from_file(path).extent == (0.0, 2.0)
    path.write_text("0 0\n1 0\n2 0\n3 0\n")
    with pytest.raises(nh.InputError, match="at most 3 points: export fewer points"):
        from_file(path)


@pytest.mark.parametrize(
    "text",
    [
        ".".join("a" * 3000) + " = 1",
        ".".join("a" * 400_000) + " = 1",
        "[" + '."b c" . '.join("a" * (NESTING + 1)) + "]",
        "[[" + ".".join("a" * 1000) + "]]",
        "a = { " + ".".join("a" * 1000) + " = 1 }",
        "a = { b = 1, " + ".".join("'a'" for _ in range(1000)) + " = 1 }",
        "a = " + "[" * 100 + "]" * 100,
    ],
    ids=lambda text: text[:12],
)
def test_a_case_is_not_nested_without_end(tmp_path, text):
    assert mistakes_in(tmp_path, text) == ("must be a case file: lists or tables are nested too deeply.",)


@pytest.mark.parametrize(
    "text",
    ["a = 1.5", "a = 'x.y.z'", ".".join("a" * NESTING) + " = 1", "a = [" + "1.0, " * 100 + "]", "a = 2020-01-01"],
)
def test_what_is_no_key_of_many_parts(text):
    assert tomllib.loads(text)
    assert not has_long_key(text)


def test_many_unknown_keys_are_counted_and_not_told_one_by_one(tmp_path):
    number = 3000
    told = mistakes_in(tmp_path, "".join(f"key{n} = 1\n" for n in range(number)) + CASE)
    assert len(told) == MISTAKES + 1
    assert told[0].startswith("Unknown key key0: ")
    assert told[MISTAKES - 1].startswith(f"Unknown key key{MISTAKES - 1}: ")
    assert told[MISTAKES] == f"There are {number - MISTAKES} more mistakes."


def test_one_mistake_more_is_one(tmp_path):
    told = mistakes_in(tmp_path, "".join(f"key{n} = 1\n" for n in range(MISTAKES + 1)) + CASE)
    assert told[MISTAKES:] == ("There is one more mistake.",)


@pytest.mark.parametrize(
    "text",
    [
        "".join(f"key{n} = 1\n" for n in range(KEYS + 1)),
        "[[life.spectrum]]\nload = 1\nshare = 1\n" * KEYS,
        "a = [" + "{ b = 1 }," * KEYS + "]\n",
    ],
    ids=["one table", "tables", "tables of a list"],
)
def test_a_case_has_so_many_keys(tmp_path, monkeypatch, text):
    def compared(*_: object) -> None:
        raise AssertionError("no key is looked at")

    monkeypatch.setattr(reading, "nearest", compared)
    assert mistakes_in(tmp_path, text) == (f"must be a case file: there are more than {KEYS} keys.",)


def test_a_body_has_so_many_profiles(tmp_path):
    table = "{ kind = 'crown', radius = 4000.0 },"
    read = parse(BODIES.format(keys=f"profile = [{table * PROFILES}]") + LOAD, "case.toml")
    assert len(read["body"]["a"]["profile"]) == PROFILES
    (told,) = mistakes_in(tmp_path, BODIES.format(keys=f"profile = [{table * (PROFILES + 1)}]") + LOAD)
    assert told.startswith("body.a.profile = [{")
    assert told.endswith("must have at most 100 profiles: add them up in one of kind 'tabulated'.")


def test_a_spectrum_has_so_many_loads(tmp_path):
    row = f"[[life.spectrum]]\nload = 1000\nshare = {1.0 / LOADS}\n"
    (tmp_path / "case.toml").write_text(CASE + row * LOADS)
    assert len(read_case(tmp_path / "case.toml").life.spectrum) == LOADS
    (told,) = mistakes_in(tmp_path, CASE + row * (LOADS + 1))
    assert f"must have at most {LOADS} tables" in told


def test_many_models_are_not_looked_up(tmp_path):
    (told,) = mistakes_in(tmp_path, CASE + f"[life]\nmodels = {['x'] * 1000}\n")
    assert told.startswith("life.models = ['x', ")


@pytest.mark.parametrize("place", ["title", "solver.strips", "life.rollers", "life.laminae", "body.a.kind"])
def test_a_number_of_thousands_of_digits_has_a_complaint(tmp_path, place):
    told = mistakes_in(tmp_path, f"{place} = 0x{'f' * 20_000}\n")
    assert any(each.startswith(f"{place} = ") for each in told)


def test_a_number_beyond_all_floats_is_infinite_for_a_measured_profile_too(tmp_path):
    (tmp_path / "trace.txt").write_text("".join(f"{y} 0\n" for y in range(-9, 10)))
    told = mistakes_in(
        tmp_path,
        BODIES.format(keys=f"profile = {{ kind = 'measured', file = 'trace.txt', cutoff = {'9' * 400} }}") + LOAD,
    )
    assert len(told) == 1
    assert told[0].endswith("must be a finite number: give a wavelength in mm, such as 0.8.")


def test_a_list_with_a_number_of_thousands_of_digits_has_a_complaint(tmp_path):
    told = mistakes_in(tmp_path, f"life.models = ['x', 0x{'f' * 20_000}]\n{CASE}")
    assert [each.partition(" = ")[0] for each in told] == ["life.models[1]", "life.models[2]"]


def test_a_key_of_any_length_is_shown_in_a_line(tmp_path):
    (told,) = mistakes_in(tmp_path, f"{'key' * 1000} = 1\n{CASE}")
    assert told.startswith('Unknown key "keykey')
    assert '...": choose from' in told
    assert len(told) < 200


@posix
def test_a_name_that_is_no_text_makes_a_title_that_is(tmp_path):
    path = tmp_path / os.fsdecode(b"roller\xff.toml")
    path.write_text(CASE)
    assert read_case(path).title == "roller\ufffd"
    assert read_case(path).file_name == "roller\ufffd.toml"


@posix
def test_a_file_whose_name_has_two_lines_is_complained_of_in_one(tmp_path):
    (tmp_path / "a\nb").write_text("0 0\n1 nan\n")
    for name in ("a\\nb", "no\\nfile"):
        keys = f'profile = {{ kind = "tabulated", file = "{name}" }}'
        (told,) = mistakes_in(tmp_path, BODIES.format(keys=keys) + LOAD)
        assert len(told.splitlines()) == 1
