// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "algebra/matrix.hpp"

namespace proofs {

inline Matrix2 any_matrix() {
  return {{{variable("a11"), variable("a12")}, {variable("a21"), variable("a22")}}};
}

inline Matrix3 any_symmetric() {
  return symmetric(variable("xx"), variable("yy"), variable("zz"), variable("xy"), variable("yz"),
                   variable("xz"));
}

inline Matrix3 any_traceless() {
  const auto xx = variable("xx"), yy = variable("yy");
  return symmetric(xx, yy, -(xx + yy), variable("xy"), variable("yz"), variable("xz"));
}

/// A unit vector, by a relation: normal forms have no square of vz.
struct UnitVector {
  Vector3 v{variable("vx"), variable("vy"), variable("vz")};

  static Polynomial reduced(const Polynomial& f) {
    return f.with_square("vz", Polynomial(1) - square(variable("vx")) - square(variable("vy")));
  }
};

}  // namespace proofs
