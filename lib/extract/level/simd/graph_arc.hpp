// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "tensortopo/tensor/deviator.hpp"

namespace tensortopo {

/// A mode curve of a triangle that is monotone along a direction, from one edge to another.
struct GraphArc {
  std::array<Deviator<double>, 3> tensors;      ///< at the corners of the triangle
  std::array<double, 3> direction, begin, end;  ///< barycentric
};

/// How far neighbouring samples of a curve may turn: cosines of the largest angles.
struct LeastCosines {
  double medium;  ///< between medium eigenvectors
  double tensor;  ///< between tensors
};

}  // namespace tensortopo
