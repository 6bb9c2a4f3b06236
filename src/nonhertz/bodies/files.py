"""Files kept between processes: moved to their place when complete, and missing where their digest is wrong."""

from __future__ import annotations

import contextlib
import functools
import hmac
import logging
import os
from pathlib import Path


def folder() -> Path | None:
    """Return the folder: ``NONHERTZ_CACHE_DIR`` if set, else one in the user's cache; None where neither is known."""
    if chosen := os.environ.get("NONHERTZ_CACHE_DIR"):
        return Path(chosen).absolute()
    # Without a home folder the tilde stays; a relative folder would be created wherever the program runs.
    of_user = Path(os.environ.get("XDG_CACHE_HOME") or os.path.expanduser("~/.cache"))  # noqa: PTH111
    return of_user / "nonhertz" if of_user.is_absolute() else None


def read(name: str, key: bytes) -> bytes | None:
    """Return the content written under a name and a key, or None if it is missing or damaged."""
    place = folder()
    if place is not None:
        with contextlib.suppress(OSError):
            data = (place / name).read_bytes()
            if data[:32] == hmac.digest(key, data[32:], "sha256"):
                return data[32:]
    return None


def write(name: str, key: bytes, content: bytes) -> None:
    """Write a file; if that fails, log the reason once."""
    place = folder()
    if place is None:
        _log_once("no home folder is known")
        return
    draft = place / f".draft-{os.urandom(16).hex()}"
    try:
        place.mkdir(parents=True, exist_ok=True)
        draft.write_bytes(hmac.digest(key, content, "sha256") + content)
        draft.replace(place / name)
    except OSError as error:
        _log_once(f"nothing can be written in {place} ({error.strerror or error})")
    finally:
        with contextlib.suppress(OSError):
            draft.unlink(missing_ok=True)


@functools.cache
def _log_once(why: str) -> None:
    """Log a warning once per process; it is shown on standard error unless logging is set up."""
    logging.getLogger("nonhertz").warning(
        "Tables of materials and shapes cannot be cached, so every process computes them again, which takes up to some "
        "seconds: %s. Set NONHERTZ_CACHE_DIR to a writable folder.", why,
    )  # fmt: skip
