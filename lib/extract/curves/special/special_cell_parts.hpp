// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "extract/curves/points/conic_samples.hpp"
#include "extract/curves/points/degenerate_forms.hpp"
#include "extract/curves/special/special_cell.hpp"
#include "extract/curves/special/turning_arcs.hpp"
#include "tensortopo/scalar/extended.hpp"

/// \file
/// What `special_cell` is made of; see there.

namespace tensortopo {

/// The vertices of a simplex, one bit each.
template <std::size_t Vertices>
inline constexpr unsigned kAllVertices = (1u << Vertices) - 1;

/// The forms of a cell with independent tensors, exact, enclosed and rounded.
template <std::size_t Vertices>
struct SpecialForms {
  SpecialForms(const std::array<ScaledTensor, Vertices>& tensors, bool linear);

  /// Whether a direction's degenerate tensor is of the kind sought and has positive weights only:
  /// negative if one weight certainly is not.
  Verdict inside(const ExactDirection& e) const;
  /// The signs of the weights there, as far as certain.
  std::array<Verdict, Vertices> signs(const ExactDirection& e) const;
  /// The weights, with sum 1, rounded.
  CurveSample sample(const Vector3<Extended>& e) const;
  SpecialPoint point(const ExactDirection& e) const;

  std::array<std::size_t, 5> columns{};
  FieldForms<Rational, Vertices> exact;
  FieldForms<MultiprecisionInterval, Vertices> enclosed;
  FieldForms<Extended, Vertices> rounded;
  bool positive = true;  ///< a form of a positive weight is positive
};
extern template struct SpecialForms<3>;
extern template struct SpecialForms<4>;

/// Arcs of directions across a normal as pieces between the stops named.
/// @return false if what is inside is not certain
template <std::size_t Vertices>
bool add_turning_pieces(const SpecialForms<Vertices>& forms, const ExactDirection& normal,
                        const std::vector<std::size_t>& stops,
                        const std::vector<ExactDirection>& directions, double largest_turn,
                        bool across_axis, SpecialCell& cell) {
  const auto arcs =
      arcs_inside(normal, directions, [&](const ExactDirection& e) { return forms.inside(e); });
  if (!arcs) return false;
  for (const TurningArc& arc : *arcs) {
    SpecialPiece piece;
    piece.ends = {stops[arc.begin], stops[arc.end]};
    for (const auto& e : directions_along(normal, arc, largest_turn))
      piece.inner.push_back(forms.sample(e));
    piece.across_axis = across_axis;
    cell.pieces.push_back(std::move(piece));
  }
  return true;
}

}  // namespace tensortopo
