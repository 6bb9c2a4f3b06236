"""Prints numbers of random contacts, bearings and stress fields to the last digit, a case a line.

    python tests/core/digits.py 3

Run by test_digits.py with one build of the core after another; the number is how many times more cases there are.
"""

import json
import sys

import other_core
from same_numbers import case_record

from nonhertz.bodies import stored

DRAWN = {"roller": 10, "extreme": 40, "bearing": 6, "stress": 3}
# Arrays on disk are those of the core that was first to need them.
for name in ("read", "write"):
    assert hasattr(stored, name)
    setattr(stored, name, lambda *_: None)
print(json.dumps({"of": "core", "path": getattr(other_core, "path", None)}), file=sys.stderr)
for kind, count in DRAWN.items():
    for number in range(count * int(sys.argv[1])):
        print(json.dumps(case_record((kind, number)), sort_keys=True))
