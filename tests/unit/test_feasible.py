"""What no loads on any strips can meet: who is told what, of strips that were given and of automatic ones."""

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.model.prescription import Prescription
from nonhertz.solver.one import problem_of
from nonhertz.strip.feasible import feasible, refuse_infeasible, refuse_no_contact

CROWNED = nh.Contact(nh.Roller(diameter=20, length=20, profile=nh.profile.crown(500)), nh.Plate())
EDGES = np.linspace(-10.0, 10.0, 5)  # centres at 2.5 and 7.5 mm


def problem(**given):
    return problem_of(
        CROWNED,
        Prescription(**given),
        nh.SEMI_ELLIPTIC,
    )


@pytest.mark.parametrize(("chosen", "field"), [(True, "strips"), (False, "moment")])
def test_a_resultant_beyond_the_outermost_centres(chosen, field):
    beyond = problem(load=1e3, moment=8e3)
    with pytest.raises(nh.InputError) as refused:
        refuse_infeasible(beyond, EDGES, chosen=chosen)
    assert refused.value.field == field
    assert not feasible(beyond, EDGES)
    refuse_infeasible(problem(load=1e3, moment=7.5e3), EDGES, chosen=chosen)


def test_strips_that_miss_a_contact_between_their_centres():
    # The crown is 6 um back at 2.5 mm.
    with pytest.raises(nh.InputError) as refused:
        refuse_no_contact(problem(approach=3e-3), EDGES)
    assert refused.value.field == "strips"
    with pytest.raises(nh.InputError, match="lead to a contact that strips can resolve"):
        refuse_no_contact(problem(approach=3e-3), EDGES, chosen=False)


@pytest.mark.parametrize("tilt", [0.0, 1e-3, -1e-3])
def test_an_approach_counts_with_its_tilt(tilt):
    assert not feasible(problem(approach=-1e-3, tilt=0.0), EDGES)
    reached = 7.5 * abs(tilt) - 7.5**2 / 1000.0  # above the outer centre
    assert feasible(problem(approach=-reached + 1e-6, tilt=tilt), EDGES)
    lifted = max(2.5 * abs(tilt) - 2.5**2 / 1000.0, reached)
    assert not feasible(problem(approach=-lifted - 1e-6, tilt=tilt), EDGES)
