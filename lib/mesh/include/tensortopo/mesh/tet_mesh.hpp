// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tensortopo/mesh/as_size.hpp"
#include "tensortopo/tensor/symmetric_tensor.hpp"

namespace tensortopo {

/// A tetrahedral mesh with a symmetric tensor at each vertex: the input, bit for bit.
/// The field is the piecewise linear one that the vertex tensors span.
struct TetMesh {
  using Index = std::int32_t;  ///< of a vertex or a tetrahedron

  std::vector<Vector3<double>> points;           ///< coordinates, in any unit of length
  std::vector<SymmetricTensor<double>> tensors;  ///< one per point
  std::vector<std::array<Index, 4>> tets;        ///< positively oriented once validated
  std::vector<std::int64_t> cell_ids;            ///< id in the input file, one per tetrahedron
};

}  // namespace tensortopo
