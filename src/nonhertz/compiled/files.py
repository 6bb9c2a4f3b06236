"""Files kept between processes: moved to their place when complete, and missing where their digest is wrong."""

from __future__ import annotations

import contextlib
import functools
import hmac
import logging
import os
from pathlib import Path


def folders() -> tuple[Path, ...]:
    """Return the cache folders: in ``NUMBA_CACHE_DIR`` if that is set, else beside the package and of the user."""
    if chosen := os.environ.get("NUMBA_CACHE_DIR"):
        return (Path(chosen).absolute() / "nonhertz",)
    # Where no home is known, the tilde stays; a relative folder would be created wherever the program runs.
    of_user = os.environ.get("XDG_CACHE_HOME") or os.path.expanduser("~/.cache")  # noqa: PTH111
    places = Path(__file__).parents[1] / "__pycache__", Path(of_user, "nonhertz")
    return tuple(place / "machine-code" for place in places if place.is_absolute())


def read(name: str, key: bytes) -> bytes | None:
    """Return what was written under a name and a key, or None if it is missing or damaged."""
    for folder in folders():
        with contextlib.suppress(OSError):
            data = (folder / name).read_bytes()
            if data[:32] == hmac.digest(key, data[32:], "sha256"):
                return data[32:]
    return None


def write(name: str, key: bytes, content: bytes) -> None:
    """Write a file in the first folder that can be written to; if none can, log once why."""
    failures = []
    for folder in folders():
        draft = folder / f".draft-{os.urandom(16).hex()}"
        try:
            folder.mkdir(parents=True, exist_ok=True)
            draft.write_bytes(hmac.digest(key, content, "sha256") + content)
            draft.replace(folder / name)
            return
        except OSError as error:
            failures.append(f"{folder} ({error.strerror or error})")
        finally:
            with contextlib.suppress(OSError):
                draft.unlink(missing_ok=True)
    log_once(
        "The compiled solver cannot be kept, so every process compiles it again, which takes a minute or two: nothing "
        "can be written in %s. Set NUMBA_CACHE_DIR to a writable folder.", ", ".join(failures),
    )  # fmt: skip


@functools.cache
def log_once(sentence: str, *values: str) -> None:
    """Log a warning, once a process; unless logging is set up, standard error shows it."""
    logging.getLogger("nonhertz").warning(sentence, *values)
