"""From pressures to displacements in O(n log n).

The displacement is the convolution of the pressure with `kernel.rectangles`, done by Fourier transforms on a grid of
twice the size, so that nothing wraps around from one side of the region to the other.

The kernel is even across the contact, and the direct effect along it too: its spectrum is a cosine transform, real,
and a quarter of the doubled grid. Side faces add terms (`nonhertz.bodies.influence`). A shifted copy of the pressure
changes the spectrum, which is then complex. A mirrored copy is a convolution with the mirrored pressure, whose spectrum
is the conjugate, reversed in x: one more product, and no further transform. The correction for free side faces is a
convolution across only: a small matrix for every wave number there (`nonhertz.patch.free_faces`). The displacement at
depth below the centre line depends only on the line loads: a matrix, subtracted from all cells of a row.

References
----------
S. Liu, Q. Wang and G. Liu, A versatile method of discrete convolution and FFT (DC-FFT) for contact analyses, Wear 243
(2000) 101-111, doi:10.1016/S0043-1648(00)00427-0.
"""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import Executor

import numpy as np
from numpy.typing import NDArray

from nonhertz.bodies.influence import Influence
from nonhertz.patch.free_faces import free_ends
from nonhertz.patch.grid import Grid
from nonhertz.patch.kernel import edges_from, rectangles
from nonhertz.patch.transform import ROWS, fast_half, filter_blocks, run_in_blocks, times_even

Array = NDArray[np.float64]
Spectrum = NDArray[np.complex128]


class Convolution:
    """The displacement of both surfaces on one grid, as a function of the pressure.

    Parameters
    ----------
    grid : Grid
        The cells.
    influence : Influence
        Side faces and depths.
    pool : Executor or None
        Threads to share the work.

    Attributes
    ----------
    count : int
        Number of convolutions so far.
    own : float
        Displacement at a cell's centre per unit of its own pressure times K [mm].
    """

    def __init__(self, grid: Grid, influence: Influence, pool: Executor | None = None) -> None:
        from scipy import fft

        self.grid = grid
        self.count = 0
        self._pool = pool
        self._half = fast_half(grid.cells[0]), fast_half(grid.cells[1])
        self._shifted, self._mirrored = self._spectra(influence.terms)
        self.own = float(rectangles(edges_from(0.0, 1, grid.dx), edges_from(0.0, 1, grid.dy))[0, 0])
        self._ends = [
            (end, fft.dct(self._kernel(end.kernel, 2 * end.nodes.shape), type=1, axis=0, overwrite_x=True))
            for end in free_ends(influence.faces, grid.y, grid.dy)
        ]
        self._at_depth = grid.dx * influence.at_depth(grid.y, grid.y_edges) if influence.references else None

    def __call__(self, pressure: Array) -> Array:
        """Return the displacement [mm] under a pressure times K [-], both of shape (nx, ny)."""
        self.count += 1
        displacement = filter_blocks(pressure, (2 * self._half[0], 2 * self._half[1]), self._product, self._pool)
        for end, spectrum in self._ends:
            displacement += self._across(end.gathered(pressure), spectrum) @ end.weights.T
        if self._at_depth is not None:
            displacement -= self._at_depth @ pressure.sum(axis=0)
        return displacement

    def _across(self, loads: Array, spectrum: Array) -> Array:
        """Return the displacement at the nodes of a free end under loads there, both of shape (nx, nodes)."""
        from scipy import fft

        count = 2 * self._half[0]
        waves = fft.rfft(loads, count, axis=0)
        # Real matrices: products of real and imaginary parts are half those of complex numbers.
        moved = spectrum @ np.stack([waves.real, waves.imag], axis=-1)
        displacement: Array = fft.irfft(moved[..., 0] + 1j * moved[..., 1], count, axis=0)[: loads.shape[0]]
        return displacement

    def _kernel(self, of: Callable[[Array], Array], shape: tuple[int, ...]) -> Array:
        """Return a kernel of given shape at distances from x = 0 across, from a function of the edges across."""
        x_edges = edges_from(0.0, self._half[0] + 1, self.grid.dx)
        kernel = np.empty((x_edges.size - 1, *shape))

        def fill(rows: slice) -> None:
            kernel[rows] = of(x_edges[rows.start : rows.stop + 1])

        run_in_blocks(fill, kernel.shape[0], ROWS, self._pool)
        return kernel

    def _product(self, columns: Spectrum, at: slice) -> Spectrum:
        if self._mirrored is None:
            return times_even(columns, self._shifted[:, at])
        reversed_ = np.roll(columns[::-1], 1, axis=0).conj()
        product = times_even(columns, self._shifted[:, at])
        product += times_even(reversed_, self._mirrored[:, at])
        return product

    def _spectra(self, terms: Array) -> tuple[Array | Spectrum, Spectrum | None]:
        """Return the spectra of all shifted terms, real without images, and of all mirrored terms."""
        from scipy import fft

        shifts = [(offset, weight) for sign, offset, weight in terms.tolist() if sign > 0.0]
        mirrors = [(offset, weight) for sign, offset, weight in terms.tolist() if sign < 0.0]
        shifted: Array | Spectrum
        if shifts == [(0.0, 1.0)]:
            shifted = fft.dctn(self._cells(0.0, self._half[1] + 1), type=1, overwrite_x=True)
        else:
            # The distance from y_j to y_i is (i - j) dy - offset, with i - j of either sign.
            shifted = self._complex_spectrum(shifts, 0.0, 2 * self._half[1] - self.grid.cells[1])
        # The distance from the mirror image of y_j to y_i is 2 y_0 + (i + j) dy - offset.
        return shifted, self._complex_spectrum(mirrors, 2.0 * float(self.grid.y[0]), 0) if mirrors else None

    def _complex_spectrum(self, terms: list[tuple[float, float]], first: float, before: int) -> Spectrum:
        """Return the spectrum of weighted kernels at first - offset + k dy, k starting at -``before``, cyclic."""
        from scipy import fft

        count = 2 * self._half[1]
        kernel = np.zeros((self._half[0] + 1, count))
        for offset, weight in terms:
            kernel += weight * self._cells(first - offset - before * self.grid.dy, count)
        kernel = np.roll(kernel, -before, axis=1)
        return np.asarray(fft.dct(fft.rfft(kernel, axis=1), type=1, axis=0, overwrite_x=True))

    def _cells(self, start: float, count: int) -> Array:
        """Return the kernel of cells at ``count`` distances from ``start`` along."""
        y_edges = edges_from(start, count, self.grid.dy)
        return self._kernel(lambda x_edges: rectangles(x_edges, y_edges), (count,))
