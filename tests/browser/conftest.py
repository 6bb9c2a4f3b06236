"""The page in a real browser: one server and one browser for all tests, a fresh page for each."""

import os
import re
import shutil
import subprocess
import sys
import threading
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from desk import Desk

BROWSERS = {
    "chromium": ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome"),
    "firefox": ("firefox", "firefox-esr"),
}
QUIET = [
    "--no-sandbox",
    "--disable-gpu",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--no-first-run",
]
STARTING = 300.0  # s, on a busy machine
SCREENSHOTS = Path(__file__).parents[2] / "out" / "screenshots"


def executable(engine: str) -> str | None:
    return os.environ.get(f"NONHERTZ_{engine.upper()}") or next(filter(None, map(shutil.which, BROWSERS[engine])), None)


@pytest.fixture(scope="session")
def browser():
    """A headless browser, NONHERTZ_ENGINE; tests are skipped without one, unless NONHERTZ_BROWSER is "required"."""
    engine = os.environ.get("NONHERTZ_ENGINE", "chromium")
    path = executable(engine)
    try:
        from playwright.sync_api import sync_playwright
    except ModuleNotFoundError:
        path = None
    if path is None:
        reason = f"no {engine} (set NONHERTZ_{engine.upper()}), or no playwright"
        if os.environ.get("NONHERTZ_BROWSER") == "required":
            pytest.fail(reason)
        pytest.skip(reason)
    with sync_playwright() as playwright:
        if engine == "firefox":
            # As its makers ship it; another channel would want a build of playwright's own.
            started = playwright.firefox.launch(executable_path=path, channel="moz-firefox")
        else:
            started = playwright.chromium.launch(executable_path=path, args=QUIET)
        yield started
        started.close()


@pytest.fixture(scope="session")
def address():
    """The address of a page that the command line serves."""
    yield from served()


def served(*arguments: str) -> Iterator[str]:
    """Serve a page as the command line does, and yield its address."""
    command = [sys.executable, "-m", "nonhertz", "serve", *arguments, "--port", "0", "--no-browser"]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    assert process.stdout is not None
    guard = threading.Timer(STARTING, process.kill)
    guard.start()
    said = ""
    for line in process.stdout:
        said += line
        found = re.search(r"http://127\.0\.0\.1:\d+/", line)
        if found:
            guard.cancel()
            drain = threading.Thread(target=process.stdout.read, daemon=True)
            drain.start()
            yield found[0]
            break
    else:
        pytest.fail(f"nonhertz serve ended without an address: {said}")
    process.terminate()
    process.wait(10.0)
    drain.join(10.0)
    process.stdout.close()


def context_of(browser: Any, **options: Any) -> Any:
    if "color_scheme" in options and browser.browser_type.name == "firefox":
        pytest.skip("playwright cannot tell Firefox which colours its user prefers")
    settings = {"viewport": {"width": 1400, "height": 1000}, "reduced_motion": "reduce"} | options
    context = browser.new_context(**settings)
    context.set_default_timeout(20_000)
    return context


@pytest.fixture(scope="session")
def usual(browser):
    """The context of most pages, which compiles the page's programs once for all of them."""
    context = context_of(browser)
    yield context
    context.close()


@pytest.fixture
def open_desk(browser, usual, address):
    """Open pages that must make no complaint in the console and ask no other machine for anything."""
    yield from desks(browser, usual, address)


def desks(browser: Any, usual: Any, address: str) -> Iterator[Any]:
    """Yield what opens pages of an address, and look at their complaints when all is done."""
    opened: list[tuple[Any, Desk]] = []

    def opening(fragment: str = "", **options: Any) -> Desk:
        context = context_of(browser, **options) if options else usual
        page = context.new_page()
        desk = Desk(page, SCREENSHOTS)
        complain = desk.complaints.append
        page.on("console", lambda message: complain(message.text) if message.type == "error" else None)
        page.on("pageerror", lambda error: complain(str(error)))
        page.on("request", lambda request: complain(request.url) if is_foreign(request.url, address) else None)
        opened.append((context, desk))
        page.goto(address + fragment)
        desk.settle(within=STARTING)
        return desk

    yield opening
    for context, desk in opened:
        desk.page.evaluate("() => localStorage.clear()")  # colours and units that were chosen
        desk.page.close()
        if context is not usual:
            context.close()
        assert desk.complaints == []


@pytest.fixture
def desk(open_desk):
    return open_desk()


def is_foreign(url: str, address: str) -> bool:
    return not url.startswith((address, "data:", "blob:" + address))
