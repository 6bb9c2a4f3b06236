"""`nonhertz warm`: it compiles everything, and says where that is kept."""

from pathlib import Path

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.cli import main, warm
from nonhertz.compiled import cache, files


@pytest.mark.slow
def test_after_every_part_no_command_compiles_anything(run, monkeypatch):
    *parts, kept = run("warm").out.splitlines()
    assert [line.partition(":")[0] for line in parts] == list(warm.PARTS)
    assert kept.startswith("machine code: ")
    assert "machine-code" in kept
    written, case = [], str(Path(__file__).parents[2] / "examples" / "crowned-roller.toml")
    monkeypatch.setattr(cache, "read", lambda name, key: None)
    monkeypatch.setattr(cache, "write", lambda name, key, content: written.append(name))
    for words in (["solve", case], ["stress", case], ["life", case], ["compare", case, "--cells", "32", "64"]):
        main(words)
    assert written == []
    # Nor does what is given back to Python, arrays that cannot be written to.
    contact = nh.read_case(case).contact
    found = nh.solve(contact, load=5e3)
    again = nh.solve(contact, load=5e3, strips=found.edges)
    nh.subsurface.stress(again, found.half_width, found.y, found.half_width)
    made = nh.contact_map(contact, load=(0.0, 5e3), accuracy=0.1, checks=20)
    made.strip_loads(made.at(approach=np.broadcast_to(1e-3, 2)), found.edges)
    row = nh.bearing.CylindricalRollerBearing(
        roller=contact.a, inner=nh.Ring(diameter=60.0), outer=nh.Ring(diameter=-100.0), rollers=6
    )
    loaded = nh.bearing.solve_many(row, radial=[2e3, 3e3], method="slices")
    nh.bearing.solve_many(row, displacement=loaded.displacement, method="slices")
    assert written == []


def test_the_exit_code_says_that_nothing_can_be_kept(tmp_path, caplog, monkeypatch):
    (tmp_path / "file").touch()
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path / "file"))
    monkeypatch.setattr(warm, "PARTS", {})
    files.log_once.cache_clear()
    assert main(["warm"]) == 1
    assert f"nothing can be written in {tmp_path / 'file' / 'nonhertz'} (Not a directory)" in caplog.text
