"""Entries into machine code: what they take and give back, and what is kept of them for processes without Numba."""

import os
import subprocess
import sys
import threading
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest

from nonhertz.compiled import compiled, entry, folders, notices, target
from nonhertz.compiled.arguments import flatten, text, type_of
from nonhertz.compiled.native import ObjectCode


class Inner(NamedTuple):
    """What another tuple holds."""

    weights: np.ndarray
    count: int


class Outer(NamedTuple):
    """Arrays of one, two and three dimensions and of all kinds, and numbers."""

    x: np.ndarray
    table: np.ndarray
    inner: Inner
    rate: float
    doubled: bool
    cube: np.ndarray


SOURCE = """
def part(x, rate):
    scaled = np.empty(x.size)
    for i in range(x.size):
        scaled[i] = RATE * rate * x[i]
    return scaled

def whole(given, chosen, out):
    scaled = part(given.x, given.rate)
    total = np.zeros(1)
    for i in range(out.size):
        if chosen[i]:
            out[i] = scaled[i] + given.table[i, 1] * given.inner.weights[i] * given.inner.count + given.cube[1, 0, i]
            total[0] += out[i] * (2.0 if given.doubled else 1.0)
    return total[0]
"""


def example(rate=1.0, source=SOURCE):
    """Return the entry of another start of the program."""
    module = {"__name__": __name__, "RATE": rate, "np": np}
    exec(source, module)
    module["part"] = compiled(module["part"])
    module["whole"] = entry(module["whole"])
    return module["whole"]


def arguments(n=5, rate=0.5):
    numbers = np.random.default_rng(n)
    inner = Inner(numbers.integers(1, 9, n), 3)
    given = Outer(numbers.random(n), numbers.random((n, 2)), inner, rate, True, numbers.random((2, 3, n)))
    return given, np.arange(n) % 2 == 0, np.zeros(n)


@pytest.fixture(autouse=True)
def kept(tmp_path, monkeypatch):
    """The folder of machine code, empty at first; what has been said is said again."""
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path))
    monkeypatch.setattr(notices, "_said", set())
    return tmp_path / "nonhertz"


@pytest.fixture
def built(monkeypatch):
    """The names of the entries that were compiled."""
    names = []
    plain = target.build

    def watched(function, kinds, symbol):
        names.append(function.__name__)
        return plain(function, kinds, symbol)

    monkeypatch.setattr(target, "build", watched)
    return names


def outcome(function, given=None):
    given = arguments() if given is None else given
    return function(*given), given[-1].tobytes()


def test_machine_code_does_what_python_does():
    given, chosen, out = arguments()
    expected = np.zeros_like(out)
    module = {"np": np, "RATE": 1.0}
    exec(SOURCE, module)
    total = module["whole"](given, chosen, expected)
    assert example()(given, chosen, out) == pytest.approx(total, rel=1e-14)
    np.testing.assert_allclose(out, expected, rtol=1e-14)
    assert np.count_nonzero(out) == 3


def test_what_was_compiled_is_read_by_the_next_and_gives_the_same_bytes(kept, built):
    first = outcome(example())
    assert outcome(example()) == first
    assert built == ["whole"]
    assert len(list(kept.iterdir())) == 1  # what it calls is within


def test_other_types_of_arguments_are_other_code(built):
    function = example()
    given, chosen, out = arguments()
    integer = given._replace(inner=given.inner._replace(weights=given.inner.weights.astype(float)))
    found = [function(each, chosen, out) for each in (given, integer, given, integer)]
    assert built == ["whole", "whole"]
    assert len(set(found)) == 1


@pytest.mark.slow
def test_a_change_in_what_is_called_is_a_change(built):
    assert outcome(example()) != outcome(example(rate=3.0))
    assert outcome(example(source=SOURCE.replace("RATE * rate", "RATE + rate"))) != outcome(example())
    assert built == ["whole"] * 3


@pytest.mark.slow
@pytest.mark.parametrize("what", ["llvm.get_host_cpu_name", "_numba", "ourselves"])
def test_another_compiler_is_another_machine_code(monkeypatch, built, what):
    outcome(example())
    origin = sys.modules["nonhertz.compiled.origin"]
    origin.origin.cache_clear()
    monkeypatch.setattr(f"nonhertz.compiled.origin.{what}", lambda: "another")
    try:
        outcome(example())
    finally:
        origin.origin.cache_clear()
    assert built == ["whole", "whole"]


@pytest.mark.parametrize(
    "damage", [lambda data: b"", lambda data: data[:-1], lambda data: data[:500] + b"!" + data[501:]]
)
def test_a_damaged_file_is_compiled_anew_and_replaced(kept, built, damage):
    first = outcome(example())
    (path,) = kept.iterdir()
    path.write_bytes(damage(path.read_bytes()))
    assert outcome(example()) == outcome(example()) == first
    assert built == ["whole", "whole"]


@pytest.mark.slow
def test_nowhere_to_write_is_said_once(tmp_path, monkeypatch, caplog):
    (tmp_path / "file").touch()
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path / "file"))
    assert outcome(example()) != outcome(example(rate=3.0))
    (record,) = caplog.records
    assert "Set NUMBA_CACHE_DIR to a writable folder." in record.getMessage()


def test_an_interrupt_leaves_nothing_behind(kept, monkeypatch):
    def interrupted(draft, place):
        raise KeyboardInterrupt

    function = example()
    with monkeypatch.context() as patch:
        patch.setattr(Path, "replace", interrupted)
        with pytest.raises(KeyboardInterrupt):
            outcome(function)
    assert list(kept.iterdir()) == []
    assert outcome(function) == outcome(example())


@pytest.mark.parametrize("moment", ["_Draft._finalize_final_module", "_frame", "_memory"])
def test_an_interrupted_compiler_starts_anew(monkeypatch, built, moment):
    def interrupted(*_):
        raise KeyboardInterrupt

    function = example()
    with monkeypatch.context() as patch:
        patch.setattr(f"nonhertz.compiled.target.{moment}", interrupted)
        with pytest.raises(KeyboardInterrupt):
            outcome(function)
    assert outcome(function) == outcome(example())
    assert built == ["whole", "whole"]


def test_threads_compile_once_and_run_side_by_side(built):
    function = example()
    found = []
    threads = [threading.Thread(target=lambda: found.append(outcome(function))) for _ in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(found) == 8
    assert len(set(found)) == 1
    assert built == ["whole"]


def test_the_interpreter_goes_on_meanwhile():
    # One thread waits in machine code for what another thread writes.
    wait, trace = entry(_wait), np.zeros(8, dtype=np.int64)
    flag = np.ones(1, dtype=np.int64)
    assert wait(flag, trace, 7) == 7
    flag[0] = 0
    left = []
    thread = threading.Thread(target=lambda: left.append(wait(flag, trace, 3_000_000_000)))
    thread.start()
    flag[0] = 1
    thread.join()
    assert left[0] > 0


def _wait(flag, trace, limit):
    """Count down until ``flag`` is set; what is written might be the flag, so that it is looked at each time."""
    left = limit
    while flag[0] == 0 and left > 0:
        left -= 1
        trace[left % 8] = left
    return left


@pytest.mark.parametrize(
    ("value", "message"),
    [
        (np.zeros(5, dtype=np.float32), "arrays of float64, int64, bool, not of float32"),
        (np.zeros(5, dtype=">f8"), "not of >f8"),
        (np.zeros((5, 2))[:, 0], "contiguous arrays; shape .5,., strides .16,."),
        ([0.0], "not a list"),
        (None, "not a NoneType"),
        (1j, "not a complex"),
    ],
)
def test_what_machine_code_cannot_take_is_refused(value, message):
    function = example()
    given, chosen, out = arguments()
    for _ in range(2):  # the second time, machine code for other types is loaded
        with pytest.raises(TypeError, match=message):
            function(given._replace(x=value), chosen, out)
        function(given, chosen, out)


def test_what_is_as_good_is_taken(built):
    function = example()
    given, chosen, out = arguments()
    found = function(given, chosen, out)
    frozen = given.x.copy()
    frozen.flags.writeable = False
    mapped = given.x.copy().view(np.memmap)
    longlong = given.inner.weights.view(np.longlong)
    assert longlong.dtype.char != given.inner.weights.dtype.char
    for other in (
        given._replace(x=frozen),
        given._replace(x=mapped),
        given._replace(rate=np.float64(given.rate)),
        given._replace(inner=Inner(longlong, np.int64(3))),
        given._replace(doubled=np.bool_(True)),
    ):
        assert function(other, chosen, out) == found
    assert built == ["whole"]


@pytest.mark.parametrize(("result", "value"), [("n * 2", 6), ("n * 0.5", 1.5), ("n > 2", True), ("None", None)])
def test_results(result, value):
    module = {"__name__": __name__}
    exec(f"def give(n, x):\n    x[0] = n\n    return {result}", module)
    found = entry(module["give"])(3, np.zeros(1))
    assert found == value
    assert type(found) is type(value)


def test_an_array_is_no_result():
    module = {"__name__": __name__}
    exec("def give(x):\n    return x", module)
    with pytest.raises(TypeError, match="An entry returns nothing or one float, int or bool, not array"):
        entry(module["give"])(np.zeros(1))


def test_an_exception_comes_back():
    module = {"__name__": __name__}
    exec("def refuse(n):\n    if n > 2:\n        raise ValueError('more than', 2)\n    return n", module)
    refuse = entry(module["refuse"])
    assert refuse(2) == 2
    with pytest.raises(ValueError, match=r"\('more than', 2\)"):
        refuse(3)


def test_memory_is_given_back():
    resource = pytest.importorskip("resource")
    module = {"__name__": __name__, "np": np}
    exec("def fill(n):\n    block = np.zeros(n)\n    block[1:] = 2.0\n    return block[n - 1]", module)
    fill = entry(module["fill"])
    fill(1_000_000)
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    assert {fill(1_000_000) for _ in range(200)} == {2.0}
    # 200 blocks of 8 MB would be 1.6 GB.
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before < 100_000


def test_more_memory_than_there_is():
    module = {"__name__": __name__, "np": np}
    exec("def fill(n):\n    block = np.empty(n)\n    block[n - 1] = 2.0\n    return block[n - 1]", module)
    with pytest.raises(MemoryError):
        entry(module["fill"])(2**57)


def test_an_entry_calls_another():
    module = {"__name__": __name__}
    exec("def low(x):\n    x[0] += 1.0\n\ndef high(x):\n    low(x)\n    low(x)", module)
    module["low"] = entry(module["low"])
    x = np.zeros(1)
    entry(module["high"])(x)
    module["low"](x)
    assert x[0] == 3.0


def test_without_a_compiler_entries_are_python(monkeypatch):
    monkeypatch.setenv("NUMBA_DISABLE_JIT", "1")
    assert entry(_wait) is _wait
    assert compiled(_wait) is _wait


def test_types_are_told_apart_by_their_text():
    texts = [text(type_of(each)) for each in (1, 1.0, True, np.ones(2), np.ones((2, 2)), np.arange(2), (1,), ((1,), 1))]
    assert len(set(texts)) == len(texts)
    assert text(type_of(Inner(np.ones(1), 1))) == f"{__name__}.Inner(weights:float64[1],count:int)"


def test_parts_are_flattened_in_order():
    arrays, numbers, classes = [], [], []
    one, two = np.ones(1), np.ones(2)
    flatten((1, (one, (2.0,)), two, True), arrays, numbers, classes)
    assert [each.size for each in arrays] == [1, 2]
    assert numbers == [1, 2.0, True]
    assert classes == [int, tuple, np.ndarray, tuple, float, None, None, np.ndarray, bool]


def test_object_code_comes_back_from_a_file():
    made = ObjectCode("symbol", "float", ("malloc", "free"), b"\n\x00code\n")
    assert ObjectCode.from_bytes(made.to_bytes()) == made


PROGRAM = """
import sys
import numpy as np
from nonhertz.compiled import compiled, entry

@compiled
def part(x):
    return np.sqrt(x) + np.zeros(x.size)[0]

@entry
def whole(x, out):
    block = np.empty(x.size)
    for i in range(x.size):
        block[i] = np.exp(x[i]) ** 1.5 + part(x)[i]
    out[:] = block

out = np.zeros(4)
whole(np.arange(4.0), out)
print(out.tobytes().hex(), "numba" in sys.modules)
"""


@pytest.mark.slow
def test_a_later_process_needs_no_numba(tmp_path):
    program = tmp_path / "program.py"
    program.write_text(PROGRAM)

    def run():
        ended = subprocess.run([sys.executable, program], env=os.environ, capture_output=True, text=True, check=True)
        return ended.stdout.split()

    (first, imported), (second, again) = run(), run()
    assert (imported, again) == ("True", "False")
    assert first == second
    assert len(folders.held()) == 1


def test_the_package_imports_no_numba():
    code = "import sys, nonhertz, nonhertz.subsurface, nonhertz.patch, nonhertz.life; assert 'numba' not in sys.modules"
    subprocess.run([sys.executable, "-c", code], check=True)
