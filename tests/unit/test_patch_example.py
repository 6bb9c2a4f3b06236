"""The dented raceway: the example runs, and its figures are those of a grid with four times as many cells."""

import importlib.util
from pathlib import Path

import numpy as np
import pytest

pytestmark = pytest.mark.slow

EXAMPLE = Path(__file__).parents[2] / "examples" / "dented-raceway.py"


def test_the_dent_raises_the_maximum_and_moves_it_to_its_rim(tmp_path, capsys):
    specification = importlib.util.spec_from_file_location("dented_raceway", EXAMPLE)
    example = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(example)
    results = example.main(tmp_path)
    # 2672.6 MPa with (128, 3072) cells.
    np.testing.assert_allclose(results["dented"].max_pressure, 2672.6, rtol=1e-3, atol=0.0)
    x, y = results["dented"].max_pressure_x, results["dented"].max_pressure_y
    away = np.hypot(x - example.DENT.x, y - example.DENT.y)
    assert 0.25 < away < 0.5  # on the shoulder
    assert "The dent raises the maximum by 16 %." in capsys.readouterr().out
    assert (tmp_path / "dented-raceway.svg").stat().st_size > 10_000
