"""The decorator of compiled functions."""

import os
import subprocess
import sys
import types

import numpy as np
import pytest

from nonhertz.compiled import compiled, files
from nonhertz.compiled.cache import stamp

doubled = compiled(lambda x: 2.0 * x)


def test_python_compiled_functions_and_those_of_others_call_it():
    import numba

    assert doubled(1.0) == 2.0
    assert compiled(lambda x: doubled(x) + 1.0)(2.0) == 5.0
    assert numba.njit(lambda x: doubled(x) + 2.0)(2.0) == 6.0


@pytest.mark.parametrize("change", [{"__file__": "/there/library.py"}, {"__name__": "other"}])
def test_machine_code_is_known_by_the_names_of_libraries_and_not_by_their_folders(change):
    library = types.ModuleType("library")
    root = eval("lambda x: library.sqrt(x)", {"library": library})
    before = stamp.__wrapped__(root)
    vars(library).update(change)
    assert (stamp.__wrapped__(root) == before) == ("__file__" in change)


@pytest.mark.slow
def test_without_numba_a_contact_has_the_same_solution():
    code = (
        "import sys, nonhertz as nh; body = {'side_faces': 'none', 'depth': 'none'}\n"
        "crown = nh.profile.crown(radius=4000)\n"
        "contact = nh.Contact(nh.Roller(diameter=20, length=20, profile=crown, **body), nh.Plate(**body))\n"
        "found = nh.solve(contact, load=5e3, strips=5)\n"
        "print(found.approach, found.max_pressure, 'numba' in sys.modules)"
    )
    by_machine, by_python = (
        subprocess.run(
            [sys.executable, "-W", "ignore", "-c", code],
            env=os.environ | disabled, capture_output=True, text=True, check=True,
        ).stdout.split()
        for disabled in ({}, {"NUMBA_DISABLE_JIT": "1"})
    )  # fmt: skip
    assert [float(each) for each in by_python[:2]] == pytest.approx([float(each) for each in by_machine[:2]], rel=1e-9)
    assert (by_machine[2], by_python[2]) == ("True", "False")


@pytest.mark.slow
def test_kept_machine_code_of_a_solve_loads_no_reductions_of_arrays():
    """Numba's have SciPy's linear algebra loaded with them, which takes longer than the first solve in a process."""
    code = (
        "import sys, nonhertz as nh; body = {'side_faces': 'none', 'depth': 'none'}\n"
        "contact = nh.Contact(nh.Roller(diameter=20, length=20, **body), nh.Plate(**body))\n"
        "nh.solve(contact, load=5e3, strips=41); nh.solve(contact, load=5e3)\n"
        "print('numba.np.arraymath' in sys.modules)"
    )
    # The first may have to compile.
    first, kept = (
        subprocess.run([sys.executable, "-W", "ignore", "-c", code], capture_output=True, text=True, check=True).stdout
        for _ in range(2)
    )
    assert kept.split() == ["False"], first


@pytest.mark.parametrize("watched", [True, False])
def test_who_waits_at_a_terminal_is_told_why_once(tmp_path, monkeypatch, caplog, watched):
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path))
    monkeypatch.setattr("sys.stderr.isatty", lambda: watched, raising=False)
    files.log_once.cache_clear()
    assert compiled(lambda x: x + 1.0)(1.0) == compiled(lambda x: np.sqrt(x) + 1.0)(1.0) == 2.0
    assert len(caplog.messages) == watched
