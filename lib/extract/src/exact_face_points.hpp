// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "certified_zero.hpp"

namespace tensortopo {

/// The tensors of a triangle as rationals, and its forms by the columns given.
struct ExactFace {
  explicit ExactFace(const std::array<ScaledTensor, 3>& input);

  std::array<ScaledTensor, 3> tensors;
  int rank = 0;  ///< of the three deviators; the forms are there if it is 3
  std::array<std::size_t, 5> columns{};
  FieldForms<Rational, 3> forms;

  /// The forms as enclosures of one number each.
  std::array<SymmetricTensor<RationalInterval>, 2> across() const;
  std::array<SymmetricTensor<RationalInterval>, 3> weight() const;

  /// The zero of the forms near a place of a chart, in a tiny box with rational ends.
  std::optional<std::array<RationalInterval, 2>> zero_near(const DirectionChart& chart,
                                                           const std::array<double, 2>& at) const;
};

/// Degenerate points by rationals and 100 digits; see `degenerate_points_on_face`.
FacePoints exact_face_points(const std::array<ScaledTensor, 3>& tensors);

/// Directions with the same zero among them as in the box given: far fewer if 100 digits suffice
/// for that, else those of the box.
Vector3<RationalInterval> refined(const ExactFace& face, const DirectionBox& box);

}  // namespace tensortopo
