"""The report on paper, which a browser prints as PDF; Chromium alone does."""

import os
import re
from pathlib import Path

import pytest

import nonhertz as nh
from nonhertz.report import compose

pytestmark = pytest.mark.browser
EXAMPLE = Path(__file__).parents[2] / "examples" / "nu206-classes.toml"


@pytest.mark.skipif(os.environ.get("NONHERTZ_ENGINE", "chromium") != "chromium", reason="no other browser prints")
def test_a_bearing_with_all_that_is_known_of_it_takes_five_pages(browser, tmp_path):
    path = tmp_path / "report.html"
    path.write_text(compose([nh.read_bearing(EXAMPLE)]), encoding="utf-8")
    page = browser.new_page()
    page.goto(path.as_uri())
    printed = page.pdf(prefer_css_page_size=True)
    page.close()
    assert len(re.findall(rb"/Type\s*/Page\b", printed)) == 5
