"""How much of a campaign runs: a part that two cores do in minutes, or as much as NONHERTZ_CAMPAIGN_CASES says."""

import os


def extent(whole: int, part: int) -> int:
    """Return how many cases run: ``part``, the whole with ``all``, or the number that is asked for."""
    wish = os.environ.get("NONHERTZ_CAMPAIGN_CASES", "")
    if wish == "all":
        return whole
    return min(int(wish), whole) if wish else part
