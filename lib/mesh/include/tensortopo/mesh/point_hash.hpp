// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>

#include "tensortopo/tensor/vector3.hpp"

namespace tensortopo {

/// A hash of points for unordered containers: points that compare equal have the same one,
/// whichever sign their zeros have.
struct PointHash {
  /// @param p  finite
  std::size_t operator()(const Vector3<double>& p) const {
    std::size_t h = 0;
    for (const double c : {p.x, p.y, p.z}) {
      h ^= std::hash<double>{}(c);  // equal for both zeros
      h *= 0x9e3779b97f4a7c15u;
      h ^= h >> 29;
    }
    return h;
  }
};

}  // namespace tensortopo
