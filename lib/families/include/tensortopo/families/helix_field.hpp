// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "tensortopo/tensor/symmetric_tensor.hpp"

namespace tensortopo {

/// Cosine and sine of 2 pi `turns`, |turns| <= 2^20: to a few units of 2^-53, and the same bits on
/// every platform (+ - * only, unlike those of the mathematical library).
std::array<double, 2> unit_circle(double turns);

/// A field whose linear degenerate curve is the helix of the given radius around the z axis.
///
/// At height z let c be the helix's point, t its unit tangent, e the unit vector from the axis to c
/// and f = t x e. With u, v the first two coordinates of the position less c, times `slope`:
///   T = 3 t t^T - I + u (e e^T - f f^T) + v (e f^T + f e^T),
/// whose eigenvalues are 2 and -1 +- q, q^2 = u^2 + v^2. So for q < 3 (`slope` times the horizontal
/// distance to c) it is linear degenerate on the helix alone, and
/// **mode = 6 sqrt(6) (1 - q^2) / (6 + 2 q^2)^(3/2)**: the mode surfaces are tubes around the
/// helix, the neutral one at q = 1.
struct HelixField {
  double radius = 1;               ///< of the helix
  double turns_per_height = 0.25;  ///< how steep it is
  double slope = 0.5;              ///< how fast the field changes across it

  /// The helix's point at a height.
  Vector3<double> helix(double z) const;
  /// The tensor at a point.
  SymmetricTensor<double> operator()(const Vector3<double>& p) const;
};

}  // namespace tensortopo
