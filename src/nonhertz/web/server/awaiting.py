"""Slow jobs, done for as long as the browser waits for them."""

from __future__ import annotations

from typing import Any, Final

import anyio
from starlette.requests import Request
from starlette.responses import Response

from nonhertz.web.server.workers import Job, TooSlowError, Workers
from nonhertz.web.view.replies import broken, reply

_LISTENING: Final = 0.1  # s between looks whether the browser still waits


async def while_awaited(
    request: Request, workers: Workers, job: Job, *arguments: Any, seconds: float, too_slow: str
) -> Response:
    """Answer with what a slow job returns, and kill it when the browser goes away.

    Parameters
    ----------
    request : Request
        Whose sender waits.
    workers : Workers
        The processes that do such jobs.
    job : callable
        A module-level function that returns JSON.
    *arguments
        Its arguments.
    seconds : float
        Its time limit.
    too_slow : str
        The sentence if it takes longer.

    Raises
    ------
    RefusedError, FailedError, EndedError
        As `Workers.run` does.
    """
    outcome: list[Response | Exception] = []
    async with anyio.create_task_group() as tasks:

        async def work() -> None:
            try:
                text = await workers.run(job, *arguments, seconds=seconds)
                outcome.append(Response(text, media_type="application/json"))
            except TooSlowError:
                outcome.append(reply(broken([("", too_slow)])))
            except Exception as error:  # noqa: BLE001  (raised below, not as one of a group)
                outcome.append(error)
            tasks.cancel_scope.cancel()

        tasks.start_soon(work)
        while not await request.is_disconnected():
            await anyio.sleep(_LISTENING)
        tasks.cancel_scope.cancel()
    if not outcome:
        return Response(status_code=204)
    if isinstance(outcome[0], Exception):
        raise outcome[0]
    return outcome[0]
