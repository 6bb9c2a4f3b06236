"""Reading requests: bodies up to their size limit and strict JSON; and writing documents into pages and files."""

from __future__ import annotations

import json
from typing import Any

import anyio
from starlette.exceptions import HTTPException
from starlette.requests import ClientDisconnect, Request

from nonhertz.files.bounds import NESTING, is_deeper
from nonhertz.web.limits import BODY_SECONDS


async def content(request: Request, kind: str, most: int) -> bytes:
    """Return the body of a request.

    Parameters
    ----------
    request : Request
        The request.
    kind : str
        The content type that it must have.
    most : int
        Size limit in bytes. Reading stops there; the declared content length is not trusted.

    Raises
    ------
    HTTPException
        If it is of another type, too long, takes too long to arrive, or ends early.
    """
    media_type = request.headers.get("content-type", "").partition(";")[0].strip().lower()
    if media_type != kind:
        raise HTTPException(415, f"The content type must be {kind}.")
    read = bytearray()
    try:
        with anyio.fail_after(BODY_SECONDS):
            async for chunk in request.stream():
                read += chunk
                if len(read) > most:
                    raise HTTPException(413, f"This is more than the {most // 1024} kB that the page accepts.")
    except TimeoutError:
        raise HTTPException(408, "The request took too long to arrive: send it again.") from None
    except ClientDisconnect:
        raise HTTPException(400, "The request ended before it was complete.") from None
    return bytes(read)


def json_object(text: bytes) -> dict[str, Any]:
    """Return the object in a JSON text.

    Raises
    ------
    HTTPException
        If it is not JSON, not an object, repeats a key, holds a malformed number, or is nested too deeply.
    """
    try:
        value = json.loads(text.decode("utf-8"), object_pairs_hook=_no_key_twice)
        # Neither NaN and infinity nor lone surrogates, which JSON can escape but no text can hold.
        json.dumps(value, allow_nan=False, ensure_ascii=False).encode()
    except RecursionError:
        raise HTTPException(400, "The JSON is nested too deeply.") from None
    except UnicodeEncodeError:
        raise HTTPException(400, "The request must hold whole characters only.") from None
    except ValueError as error:  # not UTF-8, not JSON, or a number with thousands of digits
        reason = str(error).partition("\n")[0][:120].rstrip(".")
        raise HTTPException(400, f"The request must be JSON ({reason}).") from None
    if not isinstance(value, dict):
        raise HTTPException(400, "The request must be a JSON object.")
    if is_deeper(value, NESTING):
        raise HTTPException(400, "The JSON is nested too deeply.")
    return value


def _no_key_twice(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    table: dict[str, Any] = {}
    for name, value in pairs:
        if name in table:
            raise ValueError(f"the key {name[:40]!r} occurs twice")
        table[name] = value
    return table


def in_script(value: Any) -> str:
    """Return JSON that is safe inside a script element: nothing in it can end the element."""
    text = json.dumps(value, allow_nan=False)
    for character in "<>&\u2028\u2029":
        text = text.replace(character, f"\\u{ord(character):04x}")
    return text


def as_attachment(name: str, document: dict[str, Any]) -> dict[str, str]:
    """Return the header that makes a browser save a file, named after the ASCII letters and digits of the title.

    Files other than the document's own file and the report have their own names appended.
    """
    title = str(document.get("title", ""))[:200].lower()
    words = "".join(c if c.isascii() and c.isalnum() else " " for c in title).split()
    usual, _, ending = name.partition(".")
    suffix = "" if ending in {"toml", "html"} else f"-{usual}"
    stem = "-".join(words)[:60].strip("-")
    return {"Content-Disposition": f'attachment; filename="{stem + suffix if stem else usual}.{ending}"'}
