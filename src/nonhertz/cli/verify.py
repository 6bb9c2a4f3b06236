"""``nonhertz verify``: whether this installation computes known numbers."""

from __future__ import annotations

import json
from itertools import groupby

from nonhertz import selfcheck
from nonhertz.cli.exit_codes import FINE, NOT_VERIFIED
from nonhertz.cli.options import AsJson
from nonhertz.cli.printing import Progress, print_result
from nonhertz.show.sections import Section, Table

HEADS = ("", "computed", "expected", "off by", "allowed", "", "expected by")


def verify(*, as_json: AsJson = False) -> int:
    """Check that this installation computes known numbers.

    Numbers from every part of the program are compared with closed forms, publications and other methods, in some five
    seconds; the exit code is 1 if one is off by more than its tolerance. Differences are relative, except from 0.
    """
    with Progress(len(selfcheck.SECTIONS)) as progress:
        checks = list(selfcheck.run(progress.announce))
    if as_json:
        print(json.dumps([_to_json(check) for check in checks], indent=2))
    else:
        rows: list[tuple[str, ...]] = []
        for section, members in groupby(checks, key=lambda check: check.section):
            rows += [(section,), *map(_row, members)]
        print_result("", [Section("", [Table(rows, HEADS, (0, 5, 6))])])
        failed = sum(not check.passed for check in checks)
        print(f"\n{len(checks)} numbers: " + (f"{failed} off by more than allowed" if failed else "all as expected"))
    return FINE if all(check.passed for check in checks) else NOT_VERIFIED


def _row(check: selfcheck.Check) -> tuple[str, ...]:
    claim = check.claim
    numbers = f"{check.computed:.6g}", f"{claim.expected:.6g}", f"{check.difference:.0e}", f"{claim.tolerance:.0e}"
    return f"  {claim.quantity}", *numbers, "pass" if check.passed else "FAIL", claim.source


def _to_json(check: selfcheck.Check) -> dict[str, str | float | bool]:
    claim = check.claim
    return {
        "section": check.section, "claim": claim.quantity, "source": claim.source, "expected": claim.expected,
        "computed": check.computed, "difference": check.difference, "tolerance": claim.tolerance,
        "passed": check.passed,
    }  # fmt: skip
