"""Two campaigns of 50,000 cases each, extreme ones and ones near practice, judged by code apart from the package.

A part of them runs with one twin each, all with all of their twins: see `extent`.
"""

import os

import plain_case
import pytest
from campaign_run import generator, grouped, records
from extent import extent

import nonhertz as nh

CASES, SOME = 50_000, {"extreme_cases": 300, "practice_cases": 100}
MOST_UNCONVERGED = 1e-3  # of cases near practice


def chosen_records(campaign):
    count = extent(CASES, SOME[campaign])
    every = count == CASES
    found = list(records(campaign, range(count), "all" if every else "one", os.cpu_count() or 1))
    print("\n" + grouped(found))
    return found


@pytest.mark.campaign
@pytest.mark.parametrize("campaign", ["extreme_cases", "practice_cases"])
def test_every_case_ends_in_a_right_answer_or_a_sentence(campaign):
    found = chosen_records(campaign)
    faulty = [(record.number, record.faults) for record in found if record.faults]
    assert not faulty, (len(faulty), faulty[:10])
    solved = sum(record.kind == "solved" for record in found)
    if campaign == "extreme_cases":
        assert solved >= 0.6 * len(found)
    else:
        assert solved >= 0.97 * len(found)
        assert sum(record.kind == "unconverged" for record in found) <= MOST_UNCONVERGED * len(found)


@pytest.mark.campaign
@pytest.mark.filterwarnings("ignore::nonhertz.AccuracyWarning")
def test_an_automatic_grid_goes_on_as_far_as_the_contact():
    # A rough line lightly touched: the last grid learnt of a piece of contact that it ended in.
    contact, arguments = plain_case.arguments(generator("practice_cases")(9466))
    solution = nh.solve(contact, **arguments)
    assert nh.EdgeKind.CUT_OFF not in {edge.kind for edge in solution.edge_pressure}
