"""``nonhertz schema``: what files hold, for editors and other programs."""

from __future__ import annotations

from pathlib import Path

from nonhertz.cli.printing import print_written
from nonhertz.files.folder import refuse_unwritable_file, write_files
from nonhertz.files.schemas import KINDS, schema_text
from nonhertz.inputs.descriptions import unknown_word_error


def schema(kind: str, /, *, out: Path | None = None) -> None:
    """Print the JSON schema of files that are read or of JSON that is written.

    Parameters
    ----------
    kind : str
        case, bearing or plan, which are read; or what commands print: result, bearing-result, stress, life, profile,
        map, comparison, bearing-comparison, sweep, diagram, tolerance, design, front, materials or nodes.
    out : Path
        The file to write it to instead; an existing one is replaced.
    """
    if kind not in KINDS:
        raise unknown_word_error("KIND", kind, "kind of file with a schema", KINDS)
    if out is None:
        print(schema_text(kind), end="")
    else:
        refuse_unwritable_file(out)
        print_written(write_files(out.parent, {out.name: schema_text(kind)}))
