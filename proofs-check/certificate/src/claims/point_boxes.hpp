// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The boxes in which a certificate says that the degenerate points of a face are.
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "claims/compare_curves.hpp"

namespace certificate {

/// A claimed point [v, i, j, k] of a face: |2^k b - i| <= 1 and |2^k c - j| <= 1 for its weights at
/// the second and third vertex.
struct PointBox {
  /// Throws Malformed.
  explicit PointBox(const Json& claim);

  mpz_class middle(std::size_t n) const { return static_cast<unsigned long>(at[n]); }
  mpz_class one() const { return mpz_class(1) << static_cast<unsigned long>(k); }

  Number vertex;
  std::array<Number, 2> at{};
  Number k;
};

/// Is a point in a box? Unsure if it is on its edge.
/// @param face  the vertices to which the box refers
/// @param corner  of each of these, which corner it is of those to which the point refers
Answer holds(const CurveCase& c, const PointBox& box, const std::array<Vertex, 3>& face,
             const std::array<std::size_t, 3>& corner, FacePoint point);

/// Of each claimed point of a face, a number that does not depend on how a mesh numbers the face's
/// vertices: which one it is among the points that are derived with the corners in the order of their
/// places. Nothing if that is not told.
/// @param claim  a face with its points, as compared by `compare_face_points`
std::optional<std::vector<std::size_t>> point_numbers(const CurveCase& c, const CurveFace& face,
                                                      const Json& claim);

}  // namespace certificate
