// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "algebra/matrix.hpp"
#include "certificates/constants.hpp"

namespace proofs {

/// A deviator in the coordinates a = xx - yy, b = yy - zz, xy, yz, xz.
struct Deviator {
  Polynomial a, b, xy, yz, xz;

  /// With variables named after the coordinates and a suffix.
  static Deviator generic(const std::string& suffix = "") {
    return {variable("a" + suffix), variable("b" + suffix), variable("xy" + suffix),
            variable("yz" + suffix), variable("xz" + suffix)};
  }
};

/// The traceless tensor.
inline Matrix3 tensor(const Deviator& d) {
  const Polynomial third(rational(1, 3));
  return symmetric(third * (d.a + d.a + d.b), third * (d.b - d.a), -third * (d.a + d.b + d.b), d.xy,
                   d.yz, d.xz);
}

/// The form P as the extraction computes it.
inline Polynomial norm_form(const Deviator& d, Constants& k) {
  return k(2) * (d.a * d.a + d.b * d.b) + k(2) * d.a * d.b +
         k(6) * (d.xy * d.xy + d.yz * d.yz + d.xz * d.xz);
}

/// The form Q as the extraction computes it.
inline Polynomial determinant_form(const Deviator& d, Constants& k) {
  const Polynomial x = k(2) * d.a + d.b, y = d.b - d.a, z = -(d.a + k(2) * d.b);
  return x * (y * z - k(9) * d.yz * d.yz) - k(9) * (y * d.xz * d.xz + z * d.xy * d.xy) +
         k(54) * d.xy * d.yz * d.xz;
}

}  // namespace proofs
