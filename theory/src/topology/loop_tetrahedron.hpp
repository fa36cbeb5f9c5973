// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "tensors.hpp"
#include "tensortopo/field/linear_field.hpp"

namespace tensortopo::theory {

/// A tetrahedron meant to hold one loop of the complex domain's boundary inside: in the
/// eigenvectors of its characteristic tensor.
struct LoopTetrahedron {
  std::array<Rational, 3> values;  ///< characteristic eigenvalues, descending
  Rational s;                      ///< the parameter of the mode
  std::array<Tensor, 4> vertices;  ///< orthogonal to the characteristic tensor, independent
  int side = 1;                    ///< of the loop: the sign of x z

  std::array<Deviator<Rational>, 4> deviators() const;
  /// With the opposite tensors: the surface of mode mu becomes that of -mu.
  LoopTetrahedron opposite() const;
};

/// One drawn around points of the loop, in doubles, and rounded to integers: whether the loop is
/// inside is to be proved of the result. Nothing if no plane at infinity was found that misses the
/// points. Requires 0 < s < (l1 - l2) / (l1 + l2).
std::optional<LoopTetrahedron> tetrahedron_around_loop(const std::array<Rational, 3>& values,
                                                       const Rational& s, int side, Random& random);

/// Fixed ones: with a handle; and with a sphere with holes, where the loop's tube joins a disc and
/// an annulus that the face curves show apart.
const LoopTetrahedron& loop_of_handle();
const LoopTetrahedron& loop_of_tube();
const LoopTetrahedron& loop_of_another_tube();
/// [[4x, y, -1-2x], [y, -5x, z], [-1-2x, z, x]] at (4, 12, 8), (4, -12, -8), ...
const LoopTetrahedron& loop_of_wide_handle();

/// For witnesses.
std::string text(const LoopTetrahedron& t);

}  // namespace tensortopo::theory
