"""Builds for other processors and with other optimisation give the same numbers, to the last digit.

One of them is compared by sanitized.py whenever it runs.
"""

import os
import platform

import pytest
from variants import BASELINE, O2, built, can_build, numbers_of

pytestmark = [
    pytest.mark.skipif(not can_build(), reason="nothing to build the core with, or of"),
    pytest.mark.skipif(platform.system() == "Windows", reason="the options are those of GCC and clang"),
]


# Each is a build of the core, so that they run with the campaigns that are run whole.
@pytest.mark.campaign
@pytest.mark.skipif(os.environ.get("NONHERTZ_CAMPAIGN_CASES") != "all", reason="run by make campaign-all")
@pytest.mark.parametrize(("name", "definitions"), {"baseline": [BASELINE], "O2": [O2], "both": [BASELINE, O2]}.items())
def test_every_build_has_the_same_digits(name, definitions):
    """Compare builds with the one that is installed, which is for this processor, with -O3."""
    found, installed = numbers_of(built(name, *definitions), 10), numbers_of(None, 10)
    assert len(installed) >= 500
    assert [one for one, other in zip(found, installed, strict=True) if one != other] == []
