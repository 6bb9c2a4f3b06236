"""Case files changed at random: each is read, or refused in a sentence for each mistake, soon and in little memory."""

from __future__ import annotations

import multiprocessing
import os
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

import pytest
from case_texts import FILES, read_all, sound_texts
from extent import extent

from nonhertz.files.casefile import read_case

CASES, PORTION, PROCESSES = extent(100_000, 2_000), 1_000, 2
SLOWEST = 2.0
"""s of computing, for any file."""
MEMORY = 500.0
"""MB, of a process that has read thousands."""

pytestmark = [
    pytest.mark.campaign,
    pytest.mark.skipif(os.name != "posix", reason="files are devices, and memory is asked for, as on Unix"),
]


@pytest.mark.filterwarnings("ignore::nonhertz.AccuracyWarning")
def test_the_texts_that_are_changed_are_sound(tmp_path: Path) -> None:
    for name, content in FILES.items():
        (tmp_path / name).write_text(content, encoding="utf-8")
    for text in sound_texts():
        (tmp_path / "case.toml").write_text(text, encoding="utf-8")
        read_case(tmp_path / "case.toml")


def test_changed_case_files(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    portions = [range(start, start + PORTION) for start in range(0, CASES, PORTION)]
    spawning = multiprocessing.get_context("spawn")
    with ProcessPoolExecutor(PROCESSES, mp_context=spawning) as processes:
        outcomes = list(processes.map(read_all, portions, [str(tmp_path)] * len(portions)))
    counts = sum((outcome.counts for outcome in outcomes), Counter[str]())
    amiss = [each for outcome in outcomes for each in outcome.amiss]
    seconds, number = max(outcome.slowest for outcome in outcomes)
    memory = max(outcome.memory for outcome in outcomes)
    with capsys.disabled():
        print(f"\n{CASES} case files: {dict(counts)}, dearest {seconds:.2f} s (number {number}), {memory:.0f} MB")
    assert amiss == []
    assert counts["sound"] > CASES // 50
    assert counts["refused"] > CASES // 2
    assert seconds < SLOWEST
    assert memory < MEMORY
