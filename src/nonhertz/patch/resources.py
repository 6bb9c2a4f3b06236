"""The peak memory of a solve, estimated before it is started."""

from __future__ import annotations

import contextlib
import os
import sys
from pathlib import Path

import numpy as np

from nonhertz.bodies.influence import influence_of
from nonhertz.bodies.shape import HERTZ
from nonhertz.errors import InputError
from nonhertz.model.contact import Contact
from nonhertz.patch.cascade import FEWEST
from nonhertz.patch.free_faces import most_nodes
from nonhertz.patch.surface import refuse_no_bodies
from nonhertz.patch.transform import fast_half

FIELDS = 14.0
"""Arrays of the grid's size alive at once: gaps, pressure, residual, search direction and its displacement, the two
responses to approach and tilt, the spectrum of rows, and a temporary or two."""
FEW, MAKING = 3.0, 2.25  # during setup: fields, and copies of the matrix of displacements at depth
DOUBLE = 8
SHARE = 0.8  # of the machine's available memory
_UNKNOWN = 8.0 * 2**30  # bytes assumed for a machine that does not report its memory


def memory(cells: tuple[int, int], contact: Contact | None = None) -> int:
    """Return the peak memory of a solve in bytes, to within a fifth unless the grid is small or slender.

    Free side faces that the contact does not reach take less than the estimate includes for them.

    Parameters
    ----------
    cells : tuple of int
        Number of cells (across, along).
    contact : Contact, optional
        The bodies, for their side faces and depths; half-spaces if left out.

    Returns
    -------
    int

    Examples
    --------
    >>> round(memory((512, 1024)) / 2**20)  # MiB
    60
    """
    nx, ny = check_cells(cells)
    if contact is not None:
        refuse_no_bodies(contact)
    spectra = DOUBLE * (fast_half(nx) + 1) * (fast_half(ny) + 1)
    fields, depth, ends = DOUBLE * nx * ny, 0, 0
    if contact is not None:
        influence = influence_of(contact, HERTZ)
        mirrored = bool((influence.terms[:, 0] < 0.0).any())
        shifted = int((influence.terms[:, 0] > 0.0).sum()) > 1
        spectra *= 1 + 2 * mirrored + 2 * shifted  # complex
        depth = DOUBLE * ny * ny * bool(influence.references)
        places = len({(face.y, face.side) for face in influence.faces})
        ends = DOUBLE * places * (fast_half(nx) + 1) * most_nodes(ny) ** 2
    # The peak is either during the iterations, or before, when the matrix of displacements at depth is being built.
    return int(spectra + ends + max(FIELDS * fields + depth, FEW * fields + MAKING * depth))


def check_cells(cells: tuple[int, int]) -> tuple[int, int]:
    """Return numbers of cells, or refuse them."""
    remedy = "give two whole numbers, such as (128, 512)"
    if not isinstance(cells, (tuple, list)) or len(cells) != 2:
        raise InputError("cells", cells, "be a pair (across, along)", remedy)
    for number in cells:
        if isinstance(number, bool) or not isinstance(number, (int, np.integer)) or number < FEWEST:
            raise InputError("cells", cells, f"be whole numbers of at least {FEWEST}", remedy)
    return int(cells[0]), int(cells[1])


def refuse_excess(cells: tuple[int, int], contact: Contact) -> None:
    """Refuse cells that need more memory than the machine has available.

    Raises
    ------
    InputError
    """
    needed, available = memory(cells, contact), SHARE * available_memory()
    if needed > available:
        condition = f"need less than the {available / 2**30:.1f} GiB of memory available, not {needed / 2**30:.1f} GiB"
        raise InputError("cells", cells, condition, "give fewer cells, or a smaller region")


def available_memory() -> float:
    """Return the bytes of free memory, or the machine's total where only that is known."""
    # A pseudo-file of Linux.
    with contextlib.suppress(OSError, ValueError), Path("/proc/meminfo").open(encoding="ascii") as lines:
        for line in lines:
            if line.startswith("MemAvailable:"):
                return 1024.0 * int(line.split()[1])
    if sys.platform == "win32":
        return _UNKNOWN
    try:
        return float(os.sysconf("SC_PHYS_PAGES")) * os.sysconf("SC_PAGE_SIZE")
    except (OSError, ValueError):
        return _UNKNOWN
