// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tensortopo/tensor/vector3.hpp"

namespace tensortopo {

/// A vector rounded to double, for drawing and output.
template <class Scalar>
Vector3<double> narrow(const Vector3<Scalar>& u) {
  return {static_cast<double>(u.x), static_cast<double>(u.y), static_cast<double>(u.z)};
}

}  // namespace tensortopo
