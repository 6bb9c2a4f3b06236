"""``nonhertz schema``: what files hold, for editors and other programs."""

from __future__ import annotations

from pathlib import Path

from nonhertz.cli.printing import print_written
from nonhertz.errors import InputError
from nonhertz.files.folder import refuse_unwritable_file, write_files
from nonhertz.files.schemas import KINDS, schema_text


def schema(kind: str, /, *, out: Path | None = None) -> None:
    """Print the JSON schema of case, bearing, plan or result files.

    Parameters
    ----------
    kind : str
        case, bearing, plan or result.
    out : Path
        The file to write it to instead; an existing one is replaced.
    """
    if kind not in KINDS:
        raise InputError("KIND", kind, "be a kind of file that has a schema", f"choose from {', '.join(KINDS)}")
    if out is None:
        print(schema_text(kind), end="")
    else:
        refuse_unwritable_file(out)
        print_written(write_files(out.parent, {out.name: schema_text(kind)}))
