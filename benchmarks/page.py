"""How long the page waits: medians of the round trip of a request to solve, and in a browser of a slider's every step.

    python benchmarks/page.py [OUT]

writes page.md and page.json into OUT, docs/benchmarks if left out. The server is the one of ``nonhertz serve``, in a
process of its own, that has loaded everything. Every request differs from the one before, as a slider's do, and the
next is sent when the answer is there. In the browser a mouse drags a slider; it needs Chromium or Chrome, and
playwright, and is left out without them. Leave the machine alone meanwhile.
"""

from __future__ import annotations

import json
import os
import re
import shutil
import signal
import subprocess
import sys
import time
import tomllib
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import httpx
import numpy as np
from machine import machine

from nonhertz.files.starting import starting_case

OUT = Path(__file__).resolve().parents[1] / "docs" / "benchmarks"
PAGE = Path("page.md")
REQUESTS, FIRST = 200, 20  # measured, and sent before that
BROWSERS = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome")
QUIET = ["--no-sandbox", "--disable-gpu", "--disable-background-networking", "--disable-component-update"]
DRAGS, MOVES, PAUSE = 4, 60, 16.0  # times across, steps each, ms between them: sixty a second
TARGET = 0.06  # s
SLIDERS = {"load": "load.load", "diameter": "body.a.diameter", "length": "body.a.length"}

Times = dict[str, float]


def main(out: Path) -> None:
    """Measure and write."""
    found: dict[str, Any] = {"machine": machine()}
    with serving() as client:
        for name, stress in {"solve with stress": True, "solve": False}.items():
            found[name] = summary(*requests(client, lambda number, wish=stress: solve(client, number, stress=wish)))
        found["form"] = summary(*requests(client, lambda number: form(client)))
        found["dragging"] = in_browser(str(client.base_url))
    (out / PAGE.with_suffix(".json")).write_text(json.dumps(found, indent=2) + "\n", encoding="utf-8")
    (out / PAGE).write_text(page(found), encoding="utf-8")
    print(page(found))


def requests(client: httpx.Client, ask: Callable[[int], float]) -> tuple[list[float], list[float]]:
    """Return how long requests take [s], and what the worker takes of it."""
    times, inside = [], []
    for number in range(FIRST + REQUESTS):
        begun = time.perf_counter()
        took = ask(number)
        times.append(time.perf_counter() - begun)
        inside.append(took)
    return times[FIRST:], inside[FIRST:]


def solve(client: httpx.Client, number: int, *, stress: bool) -> float:
    """Solve the starting case under a load of its own; return what the worker takes [s]."""
    document = tomllib.loads(starting_case())
    document["load"]["load"] = 15000.0 + 50.0 * number
    asked = {"document": document, "stress": stress, "body": "a"}
    answer = client.post("/solve", json=asked).raise_for_status().json()
    assert answer["ok"]
    assert ("planes" in answer) == stress
    return float(1e-3 * answer["ms"])


def form(client: httpx.Client) -> float:
    """Ask what the form takes from another geometry; no worker has a part in it."""
    client.post("/form", json={"document": tomllib.loads(starting_case())}).raise_for_status()
    return 0.0


def in_browser(address: str) -> dict[str, Times] | None:
    """Return round trips from a move of the mouse to redrawn figures by slider, None where there is no browser."""
    path = os.environ.get("NONHERTZ_CHROMIUM") or next(filter(None, map(shutil.which, BROWSERS)), None)
    try:
        from playwright.sync_api import sync_playwright
    except ModuleNotFoundError:
        return None
    if path is None:
        return None
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=path, args=QUIET)
        tab = browser.new_page(viewport={"width": 1400, "height": 1000})
        tab.goto(address)
        settle(tab)
        tab.locator("#stress-figures").scroll_into_view_if_needed()  # what is out of sight is not drawn in a drag
        tab.evaluate(COUNT_STRESSES)
        found = {name: dragged(tab, path) for name, path in SLIDERS.items()}
        browser.close()
    return found


def dragged(tab: Any, path: str) -> Times:
    """Return round trips while a slider is dragged to and fro."""
    drag(tab, path)  # everything is slower the first time
    before = tab.evaluate(TRIPS), tab.evaluate("window.stressDrawings")
    for _ in range(DRAGS):
        drag(tab, path)
    trips = tab.evaluate(TRIPS)[len(before[0]) :]
    drawings = tab.evaluate("window.stressDrawings") - before[1]
    return summary([1e-3 * trip for trip in trips]) | {"stress redrawn": min(1.0, drawings / len(trips))}


TRIPS = "performance.getEntriesByName('nonhertz round trip').map(entry => entry.duration)"
COUNT_STRESSES = """() => {
  window.stressDrawings = 0;
  const counted = new MutationObserver(() => (window.stressDrawings += 1));
  counted.observe(document.querySelector("[data-figure=section] .drawing"), { childList: true });
}"""


def drag(tab: Any, path: str) -> None:
    """Drag the slider of an input over a part of its way and back to where it was."""
    box = tab.locator(f'#case .field[data-path="{path}"] .slider').bounding_box()
    height = box["y"] + box["height"] / 2.0
    shares = 0.6 + 0.1 * np.sin(np.linspace(0.0, np.pi, MOVES))
    tab.mouse.move(box["x"] + shares[0] * box["width"], height)
    tab.mouse.down()
    for share in shares:
        tab.mouse.move(box["x"] + share * box["width"], height)
        tab.wait_for_timeout(PAUSE)
    tab.mouse.up()
    settle(tab)


def settle(tab: Any) -> None:
    """Wait until what was asked has been answered and drawn, stresses included."""
    tab.wait_for_timeout(500.0)
    tab.locator("html[data-state=settled]").wait_for(state="attached")


def summary(times: list[float], inside: list[float] | None = None) -> Times:
    """Return the median and the 95th percentile, and the median of what the worker takes."""
    found = {"median": float(np.median(times)), "95 % below": float(np.percentile(times, 95.0)), "count": len(times)}
    return found | ({"worker": float(np.median(inside))} if inside else {})


@contextmanager
def serving() -> Iterator[httpx.Client]:
    """Run the command and yield what talks to it once its workers have loaded everything."""
    command = [sys.executable, "-m", "nonhertz", "serve", "--port", "0", "--no-browser"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        try:
            assert process.stdout is not None
            address = re.search(r"http://\S+/", process.stdout.readline())
            assert address is not None
            with httpx.Client(base_url=address[0], timeout=300.0) as client:
                while not client.get("/status").raise_for_status().json()["ready"]:
                    time.sleep(0.1)
                time.sleep(5.0)  # the second worker loads after the first
                yield client
        finally:
            process.send_signal(signal.SIGINT)


def page(found: dict[str, Any]) -> str:
    """Return the page of what was found."""
    about = found["machine"]
    names = {
        "solve with stress": "solved, with the stress below",
        "solve": "solved",
        "form": "ranges of sliders",
    }
    rows = "\n".join(f"| {words} | {row(found[name])} |" for name, words in names.items())
    return f"""# How long the page waits

Measured by `benchmarks/page.py`. {about["processor"]}, {about["cores"]} cores, load average
{about["load"]}. The case that `nonhertz serve` begins with, under another load each time.

From a request to its whole answer over HTTP, {REQUESTS} of each in turn:

| | median | 95 % below | of which the worker |
|---|--:|--:|--:|
{rows}

{dragging(found["dragging"])}
"""


def row(times: Times) -> str:
    """Return times as cells of a table."""
    worker = shown(times["worker"]) if times.get("worker") else ""
    return f"{shown(times['median'])} | {shown(times['95 % below'])} | {worker}"


def dragging(sliders: dict[str, Times] | None) -> str:
    """Return a table of what was measured in the browser."""
    if sliders is None:
        return "No browser was there to measure in."
    rows = (
        f"| {name} | {times['count']} | {shown(times['median'])} | {shown(times['95 % below'])} "
        f"| {100.0 * times['stress redrawn']:.0f} % |"
        for name, times in sliders.items()
    )
    return "\n".join(
        (
            "A mouse drags a slider in a browser, 60 steps a second. From a step to its figures (target: a median of",
            f"{shown(TARGET)}):",
            "",
            "| slider | answers | median | 95 % below | stress redrawn |",
            "|---|--:|--:|--:|--:|",
            *rows,
        )
    )


def shown(seconds: float) -> str:
    """Return a time in milliseconds."""
    return f"{1e3 * seconds:.3g} ms"


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else OUT)
