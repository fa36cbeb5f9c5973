// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "tensors.hpp"

namespace tensortopo::theory {

/// Where the points of the complex domain's boundary lie that a linear field has in a tetrahedron.
struct BoundaryCurve {
  bool meets_inside = false;   ///< some of them are certainly inside
  bool meets_outside = false;  ///< some are certainly not in the tetrahedron
};

/// The curve of tensors whose medium eigenvector is on the boundary of the complex domain, against
/// a tetrahedron that it does not meet the faces of; that is proved on the way. Nothing if it does
/// meet a face, or too close to tell.
///
/// The sphere of medium eigenvectors, up to sign, is covered by boxes, which are halved until in
/// each the boundary function has a strict sign or the weights of the boundary's tensor show it
/// inside or outside. In intervals, so that either is certain.
///
/// @param n         orthogonal to the field
/// @param s         the parameter of the mode
/// @param vertices  a basis of the field's span
std::optional<BoundaryCurve> boundary_curve(const Tensor& n, const Rational& s,
                                            const std::array<Tensor, 4>& vertices,
                                            std::size_t budget = 1000000);

}  // namespace tensortopo::theory
