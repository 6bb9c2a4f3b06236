"""Case and bearing files changed at random: each is read, or refused in a sentence for each mistake, soon."""

import os
from collections import Counter
from functools import partial

import pytest
from case_texts import read_all
from extent import extent
from pool import of_each

CASES = {"case": extent(100_000, 1_000), "bearing": extent(30_000, 400)}
PORTION = 200
SLOWEST = 2.0
"""s of computing, for any file."""
MEMORY = 500.0
"""MB, of a process that has read thousands."""


@pytest.mark.campaign
@pytest.mark.skipif(os.name != "posix", reason="files are devices, and memory is asked for, as on Unix")
@pytest.mark.parametrize("kind", CASES)
def test_changed_files(kind, tmp_path, capsys):
    count = CASES[kind]
    portions = [range(start, min(start + PORTION, count)) for start in range(0, count, PORTION)]
    outcomes = of_each(partial(read_all, folder=str(tmp_path), kind=kind), portions, "spawn")
    counts = sum((outcome.counts for outcome in outcomes), Counter[str]())
    seconds, number = max(outcome.slowest for outcome in outcomes)
    memory = max(outcome.memory for outcome in outcomes)
    with capsys.disabled():
        print(f"\n{count} {kind} files: {dict(counts)}, dearest {seconds:.2f} s (number {number}), {memory:.0f} MB")
    assert [each for outcome in outcomes for each in outcome.amiss] == []
    assert counts["sound"] > count // 50
    assert counts["refused"] > count // 2
    assert seconds < SLOWEST
    assert memory < MEMORY
