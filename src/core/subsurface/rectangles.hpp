// The field below a plane grid of cells, each under a uniform pressure; nonhertz/subsurface/rectangles.py has the
// method.
#pragma once

#include <vector>

#include "numbers/array.hpp"

namespace nonhertz {

/// The pressure on panels of columns: the halves of panel k are 2 k + 1 and 2 k + 2.
struct Panels {
  struct Range {
    Index first, end;
  };

  Numbers x_edges, y_edges;    ///< of the cells of the smallest block that contains all pressure [mm]
  Matrix pressure;             ///< in that block [MPa], (columns, rows)
  std::vector<Range> columns;  ///< of each panel
  std::vector<Range> rows;     ///< of each panel: the loaded ones
  Numbers middle, half;        ///< of the panels [mm]
  std::vector<Index> starts;   ///< offsets of the nodes of each rule, and their total number
  Matrix nodes;                ///< positions of the nodes of all rules [mm], (panels, nodes)
  Matrix weights;              ///< load on each node per unit length along y [N/mm], (panels * rows, nodes)
  Matrix ellipses;  ///< squared half-axes of the ellipse outside which a rule suffices, in half-lengths, (rules, 2)
};

/// Six components of the stress [MPa] at points (x, y, z in a row), or of the shear modulus times the displacement.
void below_rectangles(const Panels& panels, double poisson, bool displaced, View points, Row out);

}  // namespace nonhertz
