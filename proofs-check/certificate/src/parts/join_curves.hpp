// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "parts/part_curves.hpp"
#include "run/ledger.hpp"

namespace certificate {

/// The polylines that parts form together.
struct JoinedCurves {
  std::size_t vertices = 0, lines = 0, closed = 0;
  std::vector<Component> components;  ///< in the order of the parts, and of the lines in these
  bool has_numbers = false;           ///< the array `whole_component` of lines was compared
};

/// Faces that two parts have: with one tetrahedron on each side, equal tensors at their points, and
/// the same degenerate points, at which both have vertices at the same places. One claim for each.
///
/// Points are known by what both parts derive of the face, so vertices at one place are not mistaken
/// for each other. Nothing is given if something is refuted, or open.
/// @param parts  all of them, whose claims are all certified, with nothing left out
std::optional<JoinedCurves> join_curves(const std::vector<PartCurves>& parts, Ledger& ledger);

}  // namespace certificate
