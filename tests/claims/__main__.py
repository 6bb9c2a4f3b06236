"""Compute all claims and write them: `python -m claims OUT` writes validation.md and verify.json into OUT."""

import sys

from claims import sections
from claims.page import summary, tally, write_page

found = list(sections(announce=print))
write_page(sys.argv[1], found, "python -m claims OUT")
print(summary(found))
sys.exit(1 if tally(found)["FAIL"] else 0)
