"""Machine code: the compiler's settings, what it is kept under, and what is read back."""

import errno
import logging
import os
import time
import types
from pathlib import Path

import numba
import numpy as np
import pytest
from numba.core.codegen import JITCPUCodegen

from nonhertz.compiled import compiled, dispatching, folders, notices
from nonhertz.compiled.meaning import meanings

SOURCE = """
def inner(x):
    return RATE * x * x

def outer(x):
    return inner(x) + 1.0
"""
X = 2.0
ANSWER = {2.0: 9.0, 3.0: 13.0}  # of each rate


def pair(rate=2.0, source=SOURCE):
    """Return ``outer`` of another start of the program, compiled when it is called."""
    module = {"__name__": __name__, "RATE": rate}
    exec(source, module)
    module["inner"] = compiled(module["inner"])
    module["outer"] = compiled(module["outer"])
    return module["outer"]


def loaded(function):
    """Return whether the machine code of ``function`` was read."""
    return sum(function.stats.cache_hits.values()) == 1


@pytest.fixture(autouse=True)
def kept(tmp_path, monkeypatch):
    """The folder of machine code, empty at first; what has been said is said again."""
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path))
    monkeypatch.setattr(notices, "_said", set())
    return tmp_path / "nonhertz"


def file_of(folder, name):
    (found,) = (path for path in folder.iterdir() if f".{name}-" in path.name)
    return found


def seen_while_compiling(monkeypatch, function):
    """Return the settings that the compiler meets while it compiles ``function``."""
    seen = []
    plain = numba.core.codegen.CPUCodegen._function_pass_manager

    def watched(codegen, *modules, **options):  # a module where Numba is older than 0.61
        seen.append((numba.core.config.SLP_VECTORIZE, codegen._library_class))
        return plain(codegen, *modules, **options)

    monkeypatch.setattr(numba.core.codegen.CPUCodegen, "_function_pass_manager", watched)
    function()
    return set(seen)


def test_settings_are_for_our_functions_alone(monkeypatch):
    before = numba.core.config.SLP_VECTORIZE
    ours, theirs = compiled(lambda x: x + 1.0), numba.njit(lambda x: x + 2.0)
    assert seen_while_compiling(monkeypatch, lambda: ours(1.0)) == {(1, dispatching._OwnCopies)}
    assert before == numba.core.config.SLP_VECTORIZE
    assert seen_while_compiling(monkeypatch, lambda: theirs(1.0)) == {(before, JITCPUCodegen._library_class)}


def test_settings_come_back_after_a_failure():
    before = numba.core.config.SLP_VECTORIZE
    hopeless = compiled(lambda x: x.nowhere)
    with pytest.raises(numba.core.errors.TypingError):
        hopeless(np.ones(3))
    assert before == numba.core.config.SLP_VECTORIZE


def test_no_module_calls_the_copy_of_another():
    # Long enough to be called and not put in place of the call.
    sums = "".join(f"    x = (x * x + {n}.0) / (x + {n}.0)\n" for n in range(30))
    outer = pair(source=f"def inner(x):\n{sums}    return x\ndef outer(x):\n    return inner(x) * inner(-x)")
    outer(X)
    (result,) = outer.overloads.values()
    functions = [each for each in result.library._final_module.functions if not each.is_declaration]
    copies = [each for each in functions if "inner" in each.name]
    assert copies
    assert {each.linkage.name for each in copies} == {"internal"}
    assert not [each.name for each in functions if each.linkage.name.startswith(("linkonce", "weak"))]


def test_what_was_compiled_is_read_by_the_next(kept):
    assert pair()(X) == ANSWER[2.0]
    second = pair()
    assert second(X) == ANSWER[2.0]
    assert loaded(second)
    assert len(list(kept.iterdir())) == 2


def test_other_types_of_arguments_are_other_code():
    first, second = pair(), pair()
    assert first(X) == first(2) == second(2) == ANSWER[2.0]
    assert loaded(second)


@pytest.mark.parametrize(
    "changed",
    [{"rate": 3.0}, {"source": SOURCE.replace("x * x", "x * 3.0")}, {"source": SOURCE.replace("1.0", "2.0")}],
    ids=["global", "code", "constant"],
)
def test_a_change_in_what_is_called_is_a_change(changed):
    pair()(X)
    second = pair(**changed)
    assert second(X) == pair(**changed).py_func(X) != ANSWER[2.0]
    assert not loaded(second)


@pytest.mark.parametrize(
    "upgrade",
    [
        lambda patch: patch.setattr(numba, "__version__", "0.0"),
        lambda patch: patch.setattr(np, "__version__", "0.0"),
        lambda patch: patch.setattr(numba.core.config, "BOUNDSCHECK", 1),
        lambda patch: patch.setattr(JITCPUCodegen, "magic_tuple", lambda codegen: "another processor"),
        lambda patch: patch.setattr("nonhertz.compiled.kept.ourselves", lambda: "compiled in another way"),
    ],
    ids=["numba", "numpy", "settings", "processor", "decorator"],
)
def test_another_compiler_is_another_machine_code(monkeypatch, upgrade):
    pair()(X)
    upgrade(monkeypatch)
    second = pair()
    assert second(X) == ANSWER[2.0]
    assert not loaded(second)


def test_a_constant_that_changes_under_compiled_code_is_not_kept(kept):
    # The compiler goes on with the old inner function, as it would for anyone.
    outer = pair()
    module = outer.py_func.__globals__
    outer(X)
    before = {path.name for path in kept.iterdir()}
    module["RATE"] = 3.0
    compiled(module["outer"].py_func)(X)
    assert {path.name for path in kept.iterdir()} == before
    assert pair(rate=3.0)(X) == ANSWER[3.0]


DAMAGE = {
    "empty": lambda data, other: b"",
    "cut": lambda data, other: data[: len(data) // 2],
    "random": lambda data, other: np.random.default_rng(1).bytes(len(data)),
    "one byte": lambda data, other: data[: len(data) // 4] + b"\xcc" + data[len(data) // 4 + 1 :],
    "another's": lambda data, other: other,
}


@pytest.mark.parametrize("damage", DAMAGE.values(), ids=DAMAGE)
def test_a_damaged_file_is_compiled_anew_and_replaced(kept, damage):
    pair()(X)
    path = file_of(kept, "outer")
    path.write_bytes(damage(path.read_bytes(), file_of(kept, "inner").read_bytes()))
    second, third = pair(), pair()
    assert second(X) == third(X) == ANSWER[2.0]
    assert not loaded(second)
    assert loaded(third)


def test_a_whole_file_that_numba_cannot_use_is_compiled_anew(kept, monkeypatch):
    monkeypatch.setattr("nonhertz.compiled.kept.dumps", lambda parts: b"of another build")
    pair()(X)
    monkeypatch.undo()
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(kept.parent))
    second, third = pair(), pair()
    assert second(X) == third(X) == ANSWER[2.0]
    assert not loaded(second)
    assert loaded(third)


def test_an_unreadable_file_is_replaced(kept):
    pair()(X)
    path = file_of(kept, "outer")
    path.unlink()
    path.mkdir()
    assert pair()(X) == ANSWER[2.0]
    path.rmdir()
    pair()(X)
    third = pair()
    assert third(X) == ANSWER[2.0]
    assert loaded(third)


def test_nowhere_to_write_is_said_once_with_the_way_out(tmp_path, monkeypatch, caplog):
    (tmp_path / "file").touch()
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path / "file"))
    assert pair()(X) == pair(rate=3.0)(X) - 4.0 == ANSWER[2.0]
    (record,) = caplog.records
    assert (record.name, record.levelno) == ("nonhertz", logging.WARNING)
    assert f"nothing can be written in {tmp_path / 'file' / 'nonhertz'} (Not a directory)" in record.getMessage()
    assert "Set NUMBA_CACHE_DIR to a writable folder." in record.getMessage()


def test_a_full_disk_leaves_nothing_half_written(kept, caplog):
    resource = pytest.importorskip("resource")
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    first = pair()
    resource.setrlimit(resource.RLIMIT_FSIZE, (1000, hard))
    try:
        assert first(X) == ANSWER[2.0]
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
    assert list(kept.iterdir()) == []
    assert os.strerror(errno.EFBIG) in caplog.text
    second = pair()
    assert second(X) == ANSWER[2.0]
    assert not loaded(second)


def test_an_interrupt_leaves_nothing_behind(kept, monkeypatch):
    def interrupted(draft, target):
        raise KeyboardInterrupt

    outer = pair()
    monkeypatch.setattr(Path, "replace", interrupted)
    with pytest.raises(KeyboardInterrupt):
        outer(X)
    monkeypatch.undo()
    assert list(kept.iterdir()) == []
    assert outer(X) == ANSWER[2.0]


def test_an_interrupted_compiler_starts_anew(kept, monkeypatch):
    def interrupted(library):
        raise KeyboardInterrupt

    outer = pair()
    with monkeypatch.context() as patch:
        patch.setattr(dispatching._OwnCopies, "_finalize_final_module", interrupted)
        with pytest.raises(KeyboardInterrupt):
            outer(X)
    assert outer(X) == ANSWER[2.0]
    second = pair()
    assert second(X) == ANSWER[2.0]
    assert loaded(second)


def test_a_file_is_read_under_its_key_alone():
    folders.write("name", b"key", b"content")
    assert folders.read("name", b"key") == b"content"
    assert folders.read("name", b"another") is None


def test_what_a_killed_process_was_writing_is_swept(kept):
    kept.mkdir()
    for name, age in {".draft-old": 7200.0, ".draft-new": 60.0}.items():
        (kept / name).touch()
        os.utime(kept / name, (time.time() - age,) * 2)
    folders.write("name", b"key", b"content")
    assert {path.name for path in kept.iterdir()} == {".draft-new", "name"}


def test_a_folder_has_room_for_what_is_used(kept, monkeypatch):
    monkeypatch.setattr(folders, "LARGEST", 3000)
    for age, name in enumerate("abcd"):
        folders.write(name, b"key", bytes(900))
        os.utime(kept / name, (1e9 + age,) * 2)
        assert folders.read("a", b"key") == bytes(900)
    assert {path.name for path in kept.iterdir()} == {"a", "c", "d"}


def test_without_a_setting_the_package_and_then_the_user_keep(monkeypatch):
    monkeypatch.delenv("NUMBA_CACHE_DIR")
    monkeypatch.setenv("XDG_CACHE_HOME", "/home/of/cache")
    package = Path(folders.__file__).parents[1] / "__pycache__/machine-code"
    assert folders.folders() == (package, Path("/home/of/cache/nonhertz/machine-code"))
    # As it is where nobody knows of a home.
    monkeypatch.setenv("XDG_CACHE_HOME", "~/.cache")
    assert folders.folders() == (package,)


@pytest.mark.parametrize(
    "value",
    [{"a": 1}, [1.0], compiled, types.ModuleType(__name__ + ".own")],
    ids=["dict", "list", "function", "module"],
)
def test_what_cannot_be_told_apart_is_refused(value):
    with pytest.raises(TypeError, match=r"inner is compiled and reads RATE, a .*: have it read only numbers"):
        pair(rate=value)(X)


@pytest.mark.parametrize(
    ("one", "other"),
    [
        (0.0, -0.0),
        (1, 1.0),
        (1, True),
        ((1, 2), (1, 3)),
        (np.arange(3), np.arange(3.0)),
        (np.float32(1), np.float64(1)),
    ],
)
def test_constants_that_differ_differ(one, other):
    def meaning(value):
        return list(meanings(pair(rate=value).py_func).values())[-1]

    assert meaning(one) == meaning(one) != meaning(other)


def test_a_function_that_calls_itself_has_a_meaning():
    def meaning(start):
        module = {"__name__": __name__}
        exec(f"def down(n):\n    return {start} if n == 0 else down(n - 1)", module)
        module["down"] = compiled(module["down"])
        return list(meanings(module["down"].py_func).values())

    assert meaning(0) == meaning(0) != meaning(1)


@pytest.mark.parametrize("watched", [True, False])
def test_who_waits_at_a_terminal_is_told_why_once(monkeypatch, capsys, watched):
    monkeypatch.setattr(notices, "_SILENCE", 0.0)
    monkeypatch.setattr("sys.stderr.isatty", lambda: watched, raising=False)
    pair()(X)
    pair(rate=3.0)(X)
    said = f"{notices._WAIT}\n"
    assert capsys.readouterr() == ("", said if watched else "")
