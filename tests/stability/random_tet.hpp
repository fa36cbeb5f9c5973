// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/fields/random_fields.hpp"

namespace tensortopo::test {

/// Four tensors: independent, or an average and small differences, as in a mesh that resolves its
/// field.
inline TetMesh random_tet(Random& random) {
  TetTensors tensors = random.tet_tensors();
  if (random.integer(0, 1) == 0) {
    const auto common = random.tensor();
    for (auto& t : tensors) t = common + (0.3 * random.uniform()) * t;
  }
  return reference_tet_mesh(tensors);
}

}  // namespace tensortopo::test
