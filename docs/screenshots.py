"""Take the pictures of the page that the documents show: docs/figures/page*.png, from the page as it runs.

Needs Chromium or Chrome, and playwright (the dependency group "browser"). Run from the repository:

    python docs/screenshots.py
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from playwright.sync_api import sync_playwright

FIGURES = Path(__file__).parent / "figures"
BROWSERS = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome")
WIDE = {"width": 1400, "height": 1000}


@contextmanager
def page_served() -> Iterator[str]:
    """Serve the page as the command line does, and yield its address."""
    command = [sys.executable, "-m", "nonhertz", "serve", "--port", "0", "--no-browser"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        try:
            lines = (re.search(r"http://127\.0\.0\.1:\d+/", line) for line in process.stdout)
            yield next(found[0] for found in lines if found)
        finally:
            process.terminate()


@contextmanager
def browser_started() -> Iterator[Any]:
    """Start a browser without a window."""
    path = os.environ.get("NONHERTZ_CHROMIUM") or next(filter(None, map(shutil.which, BROWSERS)), None)
    with sync_playwright() as playwright:
        started = playwright.chromium.launch(executable_path=path, args=["--no-sandbox", "--disable-gpu"])
        yield started
        started.close()


def opened(browser: Any, address: str, viewport: dict[str, int]) -> Any:
    """Open the page and wait until the starting case is drawn."""
    page = browser.new_page(viewport=viewport)
    page.goto(address)
    settle(page)
    return page


def settle(page: Any) -> None:
    """Wait until what was edited last has been answered and drawn."""
    page.wait_for_timeout(300)  # until the edit before has begun to be answered
    page.locator("html[data-state=settled]").wait_for(state="attached")


def photograph_bearing(browser: Any, address: str) -> None:
    """Take the picture of the page of bearings, with the bearing of 'nonhertz new --bearing'."""
    page = browser.new_page(viewport=WIDE, color_scheme="light")
    page.goto(f"{address}bearing")
    page.locator("html[data-state=settled]").wait_for(state="attached", timeout=120_000)  # strips take seconds
    page.screenshot(path=FIGURES / "page-bearing.png")


def main() -> None:
    """Take all pictures."""
    with page_served() as address, browser_started() as browser:
        page = opened(browser, address, WIDE)
        page.locator("#pin").click()
        for load in ("24", "26"):  # the first is solved by a worker that has just started
            page.locator('[name="load.load"]').fill(load)
            settle(page)
        page.screenshot(path=FIGURES / "page.png")
        # What the body bears follows the stress in seconds.
        page.locator("#strength[data-state=done]").wait_for(timeout=120_000)
        # High enough that nothing has to be scrolled below the line of state; a margin keeps words from the edge.
        page.set_viewport_size(WIDE | {"height": 3000})
        page.locator(".stress[aria-labelledby=stress-title]").screenshot(
            path=FIGURES / "page-stress.png", style=".stress { padding: 12px }"
        )
        page.locator("#results").evaluate("each => each.scrollTo(0, 0)")

        photograph_bearing(browser, address)


if __name__ == "__main__":
    main()
