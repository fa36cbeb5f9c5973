// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "tensortopo/tensor/deviator.hpp"
#include "tensortopo/tensor/symmetric_tensor.hpp"

namespace tensortopo {

/// What a simplex of the mesh is to the extraction: its vertex tensors, each scaled by a power of
/// two to P in [3, 12), and the sides of its vertices.
template <class Scalar, std::size_t Vertices>
struct LevelSimplex {
  std::array<Deviator<Scalar>, Vertices> tensors;  ///< at its vertices
  std::array<bool, Vertices> above;  ///< mode > mu at the vertex (a vertex on the level is below)
  std::array<const SymmetricTensor<double>*, Vertices> exact;  ///< the input's tensors
  std::array<int, Vertices> exponents;  ///< tensors[i] = deviator of exact[i] * 2^exponents[i]
};

/// The field of a simplex at homogeneous weights.
template <class Scalar, std::size_t Vertices, class Weight>
Deviator<Scalar> tensor_at(const std::array<Deviator<Scalar>, Vertices>& tensors,
                           const std::array<Weight, Vertices>& weights) {
  Deviator<Scalar> t = Scalar(weights[0]) * tensors[0];
  for (std::size_t i = 1; i < Vertices; ++i) t = t + Scalar(weights[i]) * tensors[i];
  return t;
}

}  // namespace tensortopo
