// Correction for a free side face, from a load to a table; nonhertz/bodies/quarter_space_field.py has the theory.
#pragma once

#include "numbers/array.hpp"

namespace nonhertz {

/// Panels on which a load is a polynomial, and its nodes on each.
struct LoadPanels {
  View edges;              ///< distances from the edge times k
  const Matrix& to_nodes;  ///< matrix from integrals of Legendre polynomials to the nodes' parts, (polynomials, nodes)
  View weights;            ///< Gauss's, of the nodes
};

/// Parts of a load at the nodes of all panels, (wave numbers, panels * nodes). The load is constant along y between
/// `edges` [mm]; `steps` (wave numbers, edges) are the load before each edge minus that beyond it [N/mm].
Matrix at_nodes(const LoadPanels& panels, View k, View edges, const Matrix& steps);

/// Values of cubic splines of these knots: of the logarithms log_k + log_r, (wave numbers * radii, columns), where the
/// splines of each wave number have a row of `coefficients`, (wave numbers, splines' length * columns). Values are
/// constant below the first knot, and zero beyond the last.
Matrix between_distances(View knots, View log_k, View log_r, const Matrix& coefficients);

}  // namespace nonhertz
