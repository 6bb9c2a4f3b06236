"""A run of many cases as it goes on: what is announced, and what is kept when it is stopped."""

import _thread
import pickle
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.model.prescription import Prescription
from nonhertz.native import core
from nonhertz.solver.one import problem_of
from nonhertz.solver.portions import NOT_SOLVED

pytestmark = pytest.mark.filterwarnings("ignore::nonhertz.AccuracyWarning")

# Ends that cost little: what a case costs is not the subject here.
CROWNED = nh.Contact(nh.Roller(diameter=20, length=20, profile=nh.profile.crown(4000), side_faces="mirror"), nh.Plate())
CHAMFERED = nh.Contact(
    nh.Roller(diameter=20, length=20, profile=nh.profile.chamfer(20, 1.0), side_faces="mirror"), nh.Plate()
)
COLUMNS = (
    "approach", "tilt", "load", "moment", "max_pressure", "max_pressure_y", "max_half_width", "contact_length",
    "penetration", "stiffness", "singular", "converged",
)  # fmt: skip
CASES = {"approach": np.append(np.linspace(0.01, 0.02, 99), -0.5)[:, None], "tilt": [0.0, 2e-4]}


def assert_equal(found: nh.Solutions, expected: nh.Solutions) -> None:
    for name in COLUMNS:
        np.testing.assert_array_equal(getattr(found, name), getattr(expected, name), err_msg=name)
    assert {at: repr(error) for at, error in found.failures.items()} == {
        at: repr(error) for at, error in expected.failures.items()
    }


@pytest.mark.slow
@pytest.mark.parametrize("strips", [15, None], ids=["equal", "automatic"])
def test_portions_hold_every_case_once_as_the_results_do(strips):
    portions: list[nh.Chunk] = []
    contacts, load = [CROWNED, CHAMFERED], np.linspace(2e3, 9e3, 90)[:, None]
    many = nh.solve_many(contacts, load=load, strips=strips, callback=portions.append)
    assert_equal(many, nh.solve_many(contacts, load=load, strips=strips))
    assert len(portions) > 1
    assert sorted(np.concatenate([each.numbers for each in portions]).tolist()) == list(range(180))
    assert [each.done for each in portions] == np.cumsum([each.numbers.size for each in portions]).tolist()
    assert {each.total for each in portions} == {180}
    for portion in portions:
        assert np.all(np.diff(portion.numbers) > 0)
        for name in COLUMNS:
            values = getattr(many, name).reshape(180, *getattr(many, name).shape[2:])
            np.testing.assert_array_equal(getattr(portion.solutions, name), values[portion.numbers], err_msg=name)
        at = tuple(int(index) for index in np.unravel_index(portion.numbers[-1], many.shape))
        assert np.array_equal(portion.solutions[-1].line_load, many[at].line_load)
        assert portion.solutions[-1].contact is many[at].contact


def test_what_is_announced_does_not_depend_on_the_threads():
    said: dict[int, list[tuple[list[int], list[float], list[str]]]] = {1: [], 3: []}
    for threads, found in said.items():

        def note(portion, found=found):
            failures = [f"{at}: {error}" for at, error in portion.solutions.failures.items()]
            found.append((portion.numbers.tolist(), portion.solutions.load.astype(str).tolist(), failures))

        nh.solve_many(CROWNED, **CASES, strips=15, threads=threads, callback=note)
    assert said[1] == said[3]
    assert len(said[1]) == 4
    assert [len(failures) for *_, failures in said[1]] == [0, 0, 0, 2]


def test_an_error_of_the_callback_stops_the_run():
    calls = []

    def fails(portion):
        calls.append(portion)
        raise RuntimeError("the disk is full")

    with pytest.raises(RuntimeError, match="the disk is full"):
        nh.solve_many(CROWNED, load=np.linspace(2e3, 9e3, 2000), strips=15, callback=fails)
    assert len(calls) == 1


def interrupted(**case) -> nh.Interrupted:
    def stop(portion):
        raise KeyboardInterrupt

    with pytest.raises(nh.Interrupted) as stopped:
        nh.solve_many(CROWNED, **case, threads=2, callback=stop)
    return stopped.value


@pytest.mark.slow
@pytest.mark.parametrize(("count", "strips"), [(3000, 41), (400, None)], ids=["equal", "automatic"])
def test_what_was_solved_before_an_interruption_is_kept(count, strips):
    case = {"load": np.linspace(2e3, 9e3, count), "strips": strips}
    stop = interrupted(**case)
    found = stop.solutions
    solved = found.converged
    assert 32 <= np.count_nonzero(solved) < count
    assert str(stop) == f"Stopped after {np.count_nonzero(solved)} of {count} cases."
    whole = nh.solve_many(CROWNED, **case)
    for name in COLUMNS:
        np.testing.assert_array_equal(getattr(found, name)[solved], getattr(whole, name)[solved], err_msg=name)
    assert found[0].error_estimate == whole[0].error_estimate
    assert set(found.failures) == set(np.flatnonzero(~solved).tolist())
    assert {str(error) for error in found.failures.values()} == {NOT_SOLVED}
    with pytest.raises(nh.NonhertzError, match="was not solved: the run was stopped"):
        found[int(np.flatnonzero(~solved)[0])]
    assert np.isnan(found.column("load")[~solved]).all()
    assert pickle.loads(pickle.dumps(stop)).solutions.load[0] == found.load[0]


class Stuck(nh.profile.Profile):
    """A profile that is not computed before the test says so."""

    def __init__(self, go_on: threading.Event, asked: threading.Event) -> None:
        self.go_on, self.asked = go_on, asked

    def relief(self, y):
        self.asked.set()
        self.go_on.wait(60.0)
        return np.zeros_like(y)


def test_a_profile_that_is_being_asked_is_waited_for_but_not_for_long(monkeypatch):
    monkeypatch.setattr("nonhertz.solver.portions.PATIENCE", 0.1)
    go_on, asked = threading.Event(), threading.Event()
    go_on.set()  # while the contact is made
    stuck = nh.Contact(nh.Roller(diameter=20, length=20, profile=Stuck(go_on, asked)), nh.Plate())

    def stop(portion):
        asked.wait(60.0)
        raise KeyboardInterrupt

    go_on.clear()
    asked.clear()
    try:
        with pytest.raises(nh.Interrupted, match=r"^Stopped after 64 of 128 cases\.$") as stopped:
            nh.solve_many([CROWNED] * 64 + [stuck] * 64, load=5e3, strips=11, threads=2, callback=stop)
    finally:
        go_on.set()
    assert list(stopped.value.solutions.failures) == list(range(64, 128))


def test_cases_that_have_begun_end_with_the_step_that_they_are_in():
    stop = core.Stop()
    problem = problem_of(CROWNED, Prescription(load=5e3), nh.SEMI_ELLIPTIC)
    by_force, target = problem.by_force, problem.target
    waiting = threading.Timer(0.2, stop.set)
    waiting.start()
    start = time.perf_counter()
    # Minutes' worth of cases.
    ended = core.solve_in_turn(problem.model.in_core, by_force, [target] * 2000, core.Accuracy(1e-6, np.inf), stop)
    assert time.perf_counter() - start < 10.0
    assert len(ended) < 2000
    assert all(result.holds for result in ended)
    assert core.solve(problem.model.in_core, by_force, target, 15, stop) is None


def test_ctrl_c_ends_one_solve_too():
    before = signal.signal(signal.SIGINT, signal.default_int_handler)  # ignored by what a shell runs in the background
    try:
        waiting = threading.Timer(0.2, _thread.interrupt_main)
        waiting.start()
        start = time.perf_counter()
        with pytest.raises(KeyboardInterrupt):
            nh.solve(CROWNED, load=5e3, strips=2000)  # some 20 s
    finally:
        signal.signal(signal.SIGINT, before)
    assert time.perf_counter() - start < 10.0


STOPPED = """
import signal
import sys
import numpy as np
import nonhertz as nh

signal.signal(signal.SIGINT, signal.default_int_handler)  # ignored by what a shell runs in the background
contact = nh.Contact(nh.Roller(diameter=20, length=20, profile=nh.profile.crown(4000)), nh.Plate())
begun = False

def show(portion):
    global begun
    if not begun:
        begun = True
        print("begun", flush=True)

try:
    nh.solve_many(contact, load=np.linspace(2e3, 9e3, 200_000), strips=41, callback=show)
except nh.Interrupted as stop:
    found = stop.solutions
    solved = int(np.count_nonzero(found.converged))
    print(solved, len(found.failures), np.isfinite(found.max_pressure[found.converged]).all(), stop, flush=True)
    raise
"""


@pytest.mark.slow
@pytest.mark.skipif(sys.platform == "win32", reason="Windows sends no SIGINT to one process alone")
def test_ctrl_c_ends_a_script_with_what_was_solved():
    script = subprocess.Popen(
        [sys.executable, "-c", STOPPED], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )
    assert script.stdout is not None
    assert script.stdout.readline() == "begun\n"
    script.send_signal(signal.SIGINT)
    out, error = script.communicate(timeout=60)
    solved, failed, finite, *sentence = out.split()
    assert int(solved) >= 64
    assert int(solved) + int(failed) == 200_000
    assert finite == "True"
    assert " ".join(sentence) == f"Stopped after {solved} of 200000 cases."
    assert script.returncode == 1
    assert "Interrupted: Stopped after" in error.splitlines()[-1]
