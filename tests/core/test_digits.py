"""Builds for other processors and with other optimisation give the same numbers, to the last digit."""

import os
import platform
import subprocess
import sys
from functools import cache
from pathlib import Path

import pytest
from variants import BASELINE, O2, built, can_build, environment

pytestmark = [
    pytest.mark.skipif(not can_build(), reason="nothing to build the core with, or of"),
    pytest.mark.skipif(platform.system() == "Windows", reason="the options are those of GCC and clang"),
]
SCRIPT = Path(__file__).with_name("digits.py")


@cache
def numbers_of(module, times):
    words = [sys.executable, SCRIPT, str(times)]
    done = subprocess.run(words, env=environment(module), capture_output=True, encoding="utf-8", check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout.splitlines()


def assert_the_same(name, *definitions, times):
    """Compare a build with the one that is installed, which is for this processor, with -O3."""
    found, installed = numbers_of(built(name, *definitions), times), numbers_of(None, times)
    assert len(installed) >= 50
    assert [one for one, other in zip(found, installed, strict=True) if one != other] == []


@pytest.mark.slow
def test_the_baseline_of_the_processors_optimised_less_has_the_same_digits():
    assert_the_same("baseline-O2", BASELINE, O2, times=1)


# Each is a build of the core, so that they run with the campaigns that are run whole.
@pytest.mark.campaign
@pytest.mark.skipif(os.environ.get("NONHERTZ_CAMPAIGN_CASES") != "all", reason="run by make campaign-all")
@pytest.mark.parametrize(("name", "definitions"), {"baseline": [BASELINE], "O2": [O2], "both": [BASELINE, O2]}.items())
def test_every_build_has_the_same_digits(name, definitions):
    assert_the_same(name, *definitions, times=10)
