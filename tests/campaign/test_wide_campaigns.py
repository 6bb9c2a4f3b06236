"""50,000 extreme contacts, alone and among many, judged by code apart from the package."""

import numpy as np
import pytest
from campaign_run import grouped, records
from extent import extent

import nonhertz as nh

CASES, SOME = 50_000, 400


@pytest.mark.campaign
def test_every_case_ends_in_a_right_answer_or_a_sentence():
    count = extent(CASES, SOME)
    found = records(range(count))
    print("\n" + grouped(found))
    faulty = [(record.number, record.faults) for record in found if record.faults]
    assert not faulty, (len(faulty), faulty[:10])
    assert sum(record.kind == "solved" for record in found) >= 0.6 * count


@pytest.mark.campaign
@pytest.mark.filterwarnings("ignore::nonhertz.AccuracyWarning")
@pytest.mark.parametrize("seed", range(10))
def test_an_automatic_grid_goes_on_as_far_as_the_contact(seed):
    """Of a rough line lightly touched: the last grid must not learn of a piece of contact that it ended in."""
    y = np.linspace(-3.6, 3.6, 236)
    relief = 3e-3 * (y / 3.6) ** 2 + np.random.default_rng(seed).normal(0.0, 3e-4, y.size)
    roller = nh.Roller(diameter=11.0, length=7.2, profile=nh.profile.tabulated(y, relief), side_faces="calibrated")
    contact = nh.Contact(roller, nh.Ring(diameter=63.0, length=10.0))
    solution = nh.solve(contact, approach=float(relief.min()) + 5e-4, tilt=1e-4, element=nh.PARABOLIC)
    assert nh.EdgeKind.CUT_OFF not in {edge.kind for edge in solution.edge_pressure}
