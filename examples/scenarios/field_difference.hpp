// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo::scenarios {

/// How far two fields on one mesh are from each other.
struct FieldDifference {
  std::size_t points = 0;
  std::size_t moved_points = 0;  ///< with other coordinates, by however little
  double largest_move = 0;       ///< of a coordinate
  bool same_tetrahedra = false;
  std::size_t different_tensors = 0;
  double largest = 0;            ///< difference of a component
  double largest_component = 0;  ///< of the first field
};

/// Throws  std::invalid_argument if the fields have different numbers of points.
FieldDifference compare_fields(const TetMesh& a, const TetMesh& b);

/// A few lines for people. Ends with a newline.
std::string to_text(const FieldDifference& difference);

}  // namespace tensortopo::scenarios
