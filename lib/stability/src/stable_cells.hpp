// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <functional>

#include "box_simplex.hpp"
#include "tensortopo/stability/level_stability.hpp"

namespace tensortopo::stability {

/// What makes a tetrahedron stable: the same question, asked of it, its faces, edges and vertices.
struct CellTests {
  double lode_angle = 0;  ///< tetrahedra whose members do not have it are stable
  /// Of a vertex' deviator, scaled, and its number.
  std::function<bool(const Traceless&, std::size_t)> vertex;
  // With the most parts to look at.
  std::function<bool(const BoxSimplex<2>&, int)> edge;
  std::function<bool(const BoxSimplex<3>&, int)> face;
  std::function<bool(const BoxSimplex<4>&, int)> tet;
  std::array<Stability, 4> reasons;  ///< of a tetrahedron with a vertex, ... for which it fails
};

/// Asks of all simplices; each reason is looked for only where none was found in a simplex of
/// smaller dimension. Does not depend on the number of threads.
LevelStability stable_cells(const UncertainField& field, const CellTests& tests,
                            const ExtractOptions& options);

}  // namespace tensortopo::stability
