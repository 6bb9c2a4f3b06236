"""From displacements to approximate pressures, at a third of the cost of a convolution: the preconditioner.

The inverse of a periodic kernel (on a torus) costs one division in Fourier space. Restricted to the contact set A, it
is nearly K_AA^-1: it is wrong only near the boundary of the set, by a factor between 0.8 and 6, whatever the number of
cells. So conjugate gradients gain half a digit per step on every grid. The torus is a few cells larger than the region,
so that the two ends of a contact that fills it do not become neighbours.

References
----------
E. A. H. Vollebregt, The bound-constrained conjugate gradient method for non-negative matrices, Journal of Optimization
Theory and Applications 162 (2014) 931-953, doi:10.1007/s10957-013-0499-x: there the FAI preconditioner.
"""

from __future__ import annotations

from concurrent.futures import Executor

import numpy as np
from numpy.typing import NDArray

from nonhertz.patch.grid import Grid
from nonhertz.patch.kernel import edges_from, rectangles
from nonhertz.patch.transform import fast_half, filter_blocks, times_even

Array = NDArray[np.float64]

APART = 4  # cells between the ends of the region on the torus
LEAST = 1e-3  # of the median spectrum: a floor, because a preconditioner must be positive; never reached on grids tried


class Inverse:
    """An approximate inverse of `Convolution` without side faces and depth.

    Parameters
    ----------
    grid : Grid
        The cells.
    pool : Executor or None
        Threads to share the work.
    """

    def __init__(self, grid: Grid, pool: Executor | None = None) -> None:
        from scipy import fft

        self._pool = pool
        half = [fast_half(-(-(cells + APART) // 2)) for cells in grid.cells]
        self._size = 2 * half[0], 2 * half[1]
        kernel = rectangles(edges_from(0.0, half[0] + 1, grid.dx), edges_from(0.0, half[1] + 1, grid.dy))
        spectrum = fft.dctn(kernel, type=1, overwrite_x=True)
        self._symbol = 1.0 / np.maximum(spectrum, LEAST * float(np.median(spectrum)))

    def __call__(self, displacement: Array) -> Array:
        """Return approximately the pressure times K [-] for a displacement [mm], both of shape (nx, ny)."""
        return filter_blocks(
            displacement, self._size, lambda waves, at: times_even(waves, self._symbol[:, at]), self._pool
        )
