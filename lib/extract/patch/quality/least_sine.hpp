// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "tensortopo/tensor/vector3.hpp"

namespace tensortopo {

/// The sine of the least angle of a triangle, which is at most 60 degrees; 0 if it is a point.
inline double least_sine(const Vector3<double>& p, const Vector3<double>& q,
                         const Vector3<double>& r, double twice_area) {
  std::array<double, 3> edges{dot(q - p, q - p), dot(r - q, r - q), dot(p - r, p - r)};
  std::sort(edges.begin(), edges.end());
  const double product = std::sqrt(edges[1]) * std::sqrt(edges[2]);
  return product > 0 ? twice_area / product : 0;
}

}  // namespace tensortopo
