"""``python -m nonhertz``, the same as the command ``nonhertz``."""

import sys

from nonhertz.cli import main

if __name__ == "__main__":
    sys.exit(main())
