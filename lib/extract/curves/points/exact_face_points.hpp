// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "extract/curves/points/certified_zero.hpp"

namespace tensortopo {

/// A triangle in intervals of 150 digits, its forms by the columns that suit best.
struct MultiprecisionFace {
  explicit MultiprecisionFace(const std::array<ScaledTensor, 3>& input);

  /// The zero of the forms near a place of a chart, in a tiny box.
  std::optional<std::array<MultiprecisionInterval, 2>> zero_near(
      const DirectionChart& chart, const std::array<double, 2>& at) const;

  std::array<ScaledTensor, 3> tensors;
  std::array<std::size_t, 5> columns{};
  FieldForms<MultiprecisionInterval, 3> forms;
  FieldForms<Real100, 3> rounded;
};

/// A common zero of the forms of a face, in a box of a chart that holds no other.
struct IsolatedZero {
  DirectionChart chart;
  std::array<MultiprecisionInterval, 2> place;
  Vector3<MultiprecisionInterval> direction;
};

/// The degenerate directions of a face's plane that are found and that 150 digits prove, each apart
/// from the others: all of them, if as many as counted. They are sought in doubles, and with 100
/// digits if these do not find as many as expected.
std::vector<IsolatedZero> isolated_zeros(const MultiprecisionFace& face, std::size_t expected);

/// Degenerate points by 100 digits, intervals of 150 and, where it is about zero, rationals; see
/// `degenerate_points_on_face`.
FacePoints exact_face_points(const std::array<ScaledTensor, 3>& tensors);

/// Directions with the same zero among them as in the box given: far fewer if 100 digits suffice
/// for that, else those of the box.
Vector3<MultiprecisionInterval> refined(const MultiprecisionFace& face, const DirectionBox& box);

}  // namespace tensortopo
