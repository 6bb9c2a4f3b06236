"""The page as whoever works at it sees it."""

import base64
import json
import re
import zlib
from pathlib import Path
from typing import Any

import pytest

PLAIN = re.compile(r"[-+.\d]+(e[-+]?\d+)?")


class Desk:
    """A page that is open in a browser."""

    def __init__(self, page: Any, screenshots: Path) -> None:
        self.page = page
        self.screenshots = screenshots
        #: What the browser wrote to its console as an error.
        self.complaints: list[str] = []

    @property
    def is_firefox(self) -> bool:
        """Whether the browser is Firefox, of which playwright sees less than of others."""
        name: str = self.page.context.browser.browser_type.name
        return name == "firefox"

    def settle(self, within: float | None = None) -> None:
        """Wait until what was asked has been answered and drawn, stresses included; seconds, if not the page's own."""
        timeout = None if within is None else 1000 * within
        self.page.locator("html[data-state=settled]:not([data-drawing])").wait_for(state="attached", timeout=timeout)

    def field(self, path: str) -> Any:
        """The input of a key."""
        return self.page.locator(f'#case [name="{path}"]')

    def slider(self, path: str) -> Any:
        """The slider beside the input of a key."""
        return self.page.locator(f'#case .field[data-path="{path}"] .slider')

    def write(self, path: str, text: str) -> None:
        """Write into a field and wait for what comes of it; a plain number is in the base unit of the quantity."""
        before = self.answers
        choice = self.page.locator(f'#case .field[data-path="{path}"] select.unit')
        base = self.field(path).get_attribute("data-unit") if choice.count() else None
        self.type(self.field(path), f"{text} {base}" if base and PLAIN.fullmatch(text) else text)
        self.wait_for_answer(before)

    def type(self, control: Any, text: str) -> None:
        """Write into a control so that leaving it is a change made by the user: to Firefox, a script's text is none."""
        control.fill(text)
        if self.is_firefox:
            control.press("End")
            control.press("Space")
            control.press("Backspace")

    def value(self, path: str) -> float:
        """The number in a field, in the base unit of the quantity."""
        units = self.page.locator(f'#case .field[data-path="{path}"] select.unit option:checked')
        return float(self.field(path).input_value()) * float(units.get_attribute("data-factor"))

    def shown(self, path: str) -> str:
        """The number in a field and the unit beside it, as files have them."""
        unit = self.page.locator(f'#case .field[data-path="{path}"] select.unit').input_value()
        return f"{self.field(path).input_value()} {unit}"

    def press(self, selector: str) -> None:
        """Press a button that changes the case, and wait for what comes of it."""
        before = self.answers
        self.page.locator(selector).click()
        self.wait_for_answer(before)

    def wait_for_answer(self, before: int) -> None:
        self.page.locator(f'html:not([data-answers="{before}"])').wait_for(state="attached")
        self.settle()

    @property
    def answers(self) -> int:
        """How many answers have been drawn."""
        return int(self.page.locator("html").get_attribute("data-answers") or 0)

    @property
    def numbers(self) -> dict[str, float]:
        """The key numbers by name, with all digits."""
        shown = self.page.locator(".key-number")
        pairs = shown.evaluate_all("all => all.map(each => [each.dataset.key, Number(each.dataset.number)])")
        return dict(pairs)

    @property
    def mistakes(self) -> list[str]:
        """The sentences in the list on top."""
        return [text.strip() for text in self.page.locator("#mistakes-list li").all_text_contents()]

    def round_trips(self) -> list[float]:
        """Milliseconds from edits to redrawn figures, so far."""
        durations: list[float] = self.page.evaluate(
            "() => performance.getEntriesByName('nonhertz round trip').map(entry => entry.duration)"
        )
        return durations

    def photograph(self, name: str, *, whole: bool = False) -> None:
        """Keep a picture of the page."""
        self.screenshots.mkdir(parents=True, exist_ok=True)
        self.page.screenshot(path=self.screenshots / f"{name}.png", full_page=whole)

    def forgive(self, words: str) -> None:
        """Take a complaint of the browser for granted; not every browser makes it."""
        self.complaints[:] = [complaint for complaint in self.complaints if words not in complaint]

    def download(self, name: str) -> bytes:
        """Return a file of the download menu."""
        self.page.locator('[popovertarget="downloads"]').click()
        return self.saved(self.page.locator(f'[data-download="{name}"]'))[1]

    def saved(self, button: Any) -> tuple[str, bytes]:
        """Return name and content of the file that a button saves."""
        if self.is_firefox:
            pytest.skip("playwright is told of no downloads by Firefox")
        with self.page.expect_download() as waiting:
            button.click()
        return waiting.value.suggested_filename, Path(waiting.value.path()).read_bytes()

    def drop(self, selector: str, name: str, content: str) -> None:
        """Drop a file of text on an element."""
        self.page.locator(selector).first.evaluate(
            """(target, [name, content]) => {
              const dataTransfer = new DataTransfer();
              dataTransfer.items.add(new File([content], name));
              target.dispatchEvent(new DragEvent("drop", { dataTransfer, bubbles: true, cancelable: true }));
            }""",
            [name, content],
        )


def packed(document: dict[str, Any]) -> str:
    """Return what a link holds for a document, made independently of the page."""
    compress = zlib.compressobj(wbits=-15)
    content = compress.compress(json.dumps(document).encode()) + compress.flush()
    return base64.urlsafe_b64encode(content).decode().rstrip("=")


def unpacked(text: str) -> dict[str, Any]:
    content = zlib.decompress(base64.urlsafe_b64decode(text + "=" * (-len(text) % 4)), wbits=-15)
    value: dict[str, Any] = json.loads(content)
    return value
