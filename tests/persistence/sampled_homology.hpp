// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "sampled_persistence.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo::test {

/// Brute force in all dimensions: the persistence of the superlevel sets of a function that is
/// linear on each tetrahedron, by the reduction of the boundary matrix modulo 2.
struct SampledHomology {
  /// Of each dimension, in signed Lode angles. A class that lasts dies at -2. Of pairs at one value
  /// none.
  std::array<std::vector<SampledPair>, 3> pairs;
  double error = 0;  ///< see `SampledPersistence`
};

/// Of the field's signed Lode angle at the vertices of the mesh cut in eight so many times, or of
/// its opposite.
SampledHomology sampled_homology(TetMesh mesh, int cuts, bool is_opposite);

}  // namespace tensortopo::test
