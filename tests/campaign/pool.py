"""Cases of a campaign in processes of their own; what ends one names the case."""

import multiprocessing
import os
from collections.abc import Callable, Iterable
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from typing import Any


def of_each(function: Callable[..., Any], cases: Iterable[Any], start: str | None = None, **options: Any) -> list[Any]:
    """Return what a function makes of each case, in their order."""
    workers = os.cpu_count() or 1
    with ProcessPoolExecutor(workers, multiprocessing.get_context(start), **options) as pool:
        waiting = [(case, pool.submit(function, case)) for case in cases]
        found = []
        for case, each in waiting:
            try:
                found.append(each.result())
            except BrokenProcessPool as error:
                # Cases begin in their order: one of these ran when the process ended.
                ended = [case for case, each in waiting if each.done() and each.exception()][: workers + 1]
                raise AssertionError(f"a process of {function} ended in one of the cases {ended}") from error
            except Exception as error:
                pool.shutdown(wait=False, cancel_futures=True)
                raise AssertionError(f"case {case} of {function} ended in {error!r}") from error
    return found
