// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "extract/level/tet_geometry.hpp"
#include "extract/patch/patch.hpp"

namespace tensortopo {

/// A tetrahedron seen along the lines of a direction (see `SimplexProof::direction`).
///
/// With weights w in the scaled vertex tensors the lines are w + k d. Let phi be a linear form that
/// is positive on the tetrahedron and vanishes at d. The weights phi_i w_i, made to have sum one,
/// are barycentric coordinates of another place in the tetrahedron; this map is projective, and the
/// lines become parallel to the sum of phi_i d_i p_i.
template <class Scalar>
class LineView {
 public:
  using Weights = std::array<double, 4>;

  /// Nothing if no such form exists: all lines go through a corner, an edge or a face.
  static std::optional<LineView> along(const TetWithCurves<Scalar>& tet,
                                       const std::array<Scalar, 4>& direction);

  /// The weights after the map of a place in the tetrahedron.
  Weights mapped(const Vector3<double>& position) const;
  /// Where that is seen: a linear function of these weights.
  std::array<double, 2> seen(const Weights& mapped) const;
  /// The point of the level on the line through a place given by its mapped weights; nothing if the
  /// line does not cross the level well inside.
  std::optional<InnerVertex<Scalar>> on_level(const Weights& mapped,
                                              const Level<Scalar>& level) const;
  /// The mapped weights of the level's point.
  Weights mapped(const InnerVertex<Scalar>& vertex) const;

 private:
  LineView(const TetWithCurves<Scalar>& tet, const std::array<Scalar, 4>& direction);

  const TetWithCurves<Scalar>& tet_;
  std::array<Scalar, 4> direction_;
  TetGeometry geometry_;
  Weights scale_;  ///< from weights in the scaled vertex tensors to mapped ones, up to a factor
  Weights form_;   ///< phi, for barycentric coordinates
  std::array<std::array<double, 2>, 4> corner_;  ///< where the corners are seen
};

}  // namespace tensortopo
