// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "tensortopo/extract/level_simplex.hpp"

namespace tensortopo::detail {

/// The input's tensors at the vertices of a simplex of the mesh, as they are in the file.
template <class Scalar, std::size_t Vertices>
std::array<SymmetricTensor<double>, Vertices> exact_tensors(
    const LevelSimplex<Scalar, Vertices>& simplex) {
  std::array<SymmetricTensor<double>, Vertices> tensors;
  for (std::size_t i = 0; i < Vertices; ++i) tensors[i] = *simplex.exact[i];
  return tensors;
}

}  // namespace tensortopo::detail
