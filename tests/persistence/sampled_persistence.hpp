// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo::test {

/// A component of superlevel sets, in signed Lode angles.
struct SampledPair {
  double birth = 0, death = 0;
};

struct SampledPersistence {
  /// One a component; what meets no older one dies at the least value of all.
  std::vector<SampledPair> superlevel, sublevel;
  /// By how much the field's angle may differ from the sampled function: twice the largest
  /// difference in the middle of an edge. Measured, not proved.
  double error = 0;
};

/// Brute force: the persistence in dimension 0 of the function that is linear on each tetrahedron
/// of the mesh cut in eight so many times, and has the field's signed Lode angle at the vertices.
SampledPersistence sampled_persistence(TetMesh mesh, int cuts);

/// How many pairs are born at or above a and die at or below b.
int rank_between(const std::vector<SampledPair>& pairs, double a, double b);

}  // namespace tensortopo::test
