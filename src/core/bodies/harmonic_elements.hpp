// Spectral finite elements for a body of revolution under pressure that varies as cos(n theta) around it.
//
// In the plane of radius r and axial position z, displacement is (u cos, v sin, w cos) of n theta. Elements are
// products of polynomials through Gauss-Lobatto nodes; nonhertz/bodies/harmonic_elements.py lays them and explains
// their use. Unknowns are eliminated from inside elements to their borders, and from one end of the body to the other,
// line by line of nodes across it. Loads are included as unknowns that are never eliminated: the remaining matrix
// between them is their work.
#pragma once

#include <array>
#include <vector>

#include "numbers/cholesky.hpp"

namespace nonhertz {

inline constexpr Index DEGREE_OF_ELEMENTS = 6, NODES = DEGREE_OF_ELEMENTS + 1;

/// The elements of a body, and the quadrature rule for each.
struct Mesh {
  Numbers across, along;  ///< borders: fractions of the wall from bore or axis to surface, and axial positions [radii]
  Matrix outer, inner;    ///< radii of surface and bore at the rule's points of each element along the axis
  Matrix outer_slope, inner_slope;  ///< and their slopes there
  Matrix values, slopes;            ///< of the nodes' polynomials (columns) at the rule's points (rows), -1 to 1
  Numbers points, weights;          ///< of the rule, -1 to 1
  bool bored, symmetric;            ///< symmetric: only the half from z = 0 on is meshed
};

class HarmonicElements {
 public:
  HarmonicElements(Mesh mesh, double poisson);

  Index rows() const { return DEGREE_OF_ELEMENTS * across() + 1; }    ///< nodes through the wall
  Index columns() const { return DEGREE_OF_ELEMENTS * along() + 1; }  ///< nodes along the axis

  /// Return the work of each reading on each load's displacement, readings^T K^-1 loads, shape (readings, loads).
  ///
  /// waves: number of waves around, not 1; loads, readings: nodal forces on the surface, by component (u, w), then
  /// along the axis: shape (loads, 2 columns()); even and odd ones in turn where the mesh is symmetric. Without waves,
  /// a rib is assumed to take up forces along the axis.
  Matrix work(int waves, const Matrix& loads, const Matrix& readings) const;
  /// The same for several numbers of waves, by several threads.
  std::vector<Matrix> works(const std::vector<int>& waves, const Matrix& loads, const Matrix& readings,
                            int threads) const;

  /// Return the nodal displacements under loads, shape (loads, 3 rows() columns()): by component (u, v, w), then
  /// through the wall, then along the axis.
  Matrix displacement(int waves, const Matrix& loads) const;

 private:
  /// Integrals over one element of products of two of d/dr, 1/r and d/dz of the nodes' polynomials.
  struct Products {
    Matrix rr, tt, zz, rt, rz, tz;
  };
  /// The factors for one number of waves, from high y to low, for back-substitution.
  struct Factors {
    std::vector<Front> elements, strips;  ///< of each strip of elements across the body
    std::array<Front, 2> last;            ///< of the last line, for even loads, or all, and for odd ones
  };

  Index across() const { return count_of(mesh_.across) - 1; }
  Index along() const { return count_of(mesh_.along) - 1; }
  Index line() const { return 3 * rows(); }             // unknowns across the body
  Index inside() const { return 15 * (across() + 1); }  // of a strip, between its two lines
  Products products(Index across, Index along) const;
  Front element(const Products& products, int waves) const;
  Index place(Index across, Index node, Index component) const;
  void hold_axis(Front& front, Index first, Index nodes_between, int waves) const;
  Factors eliminate(int waves, const Matrix& loads, bool keep) const;

  Mesh mesh_;
  double poisson_, lambda_;         // and Lame's first constant over the shear modulus
  std::vector<Products> products_;  // by place along the axis, then across
};

}  // namespace nonhertz
