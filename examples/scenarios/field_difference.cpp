// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "field_difference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace tensortopo::scenarios {

FieldDifference compare_fields(const TetMesh& a, const TetMesh& b) {
  if (a.points.size() != b.points.size())
    throw std::invalid_argument(
        fmt::format("one field has {} points, the other {}", a.points.size(), b.points.size()));
  FieldDifference d;
  d.points = a.points.size();
  d.same_tetrahedra = a.tets == b.tets;
  for (std::size_t i = 0; i < d.points; ++i) {
    if (a.points[i] != b.points[i]) ++d.moved_points;
    const auto move = a.points[i] - b.points[i];
    for (const double x : {move.x, move.y, move.z})
      d.largest_move = std::max(d.largest_move, std::abs(x));
    const auto& t = a.tensors[i];
    if (t != b.tensors[i]) ++d.different_tensors;
    const auto change = t - b.tensors[i];
    for (const double x : {change.xx, change.yy, change.zz, change.xy, change.yz, change.xz})
      d.largest = std::max(d.largest, std::abs(x));
    for (const double x : {t.xx, t.yy, t.zz, t.xy, t.yz, t.xz})
      d.largest_component = std::max(d.largest_component, std::abs(x));
  }
  return d;
}

std::string to_text(const FieldDifference& d) {
  return fmt::format(
      "tetrahedra           {}\n"
      "points               {} of {} differ, by up to {:.1e}\n"
      "tensors              {} of {} differ, by up to {:.1e} of the largest component\n",
      d.same_tetrahedra ? "the same" : "others", d.moved_points, d.points, d.largest_move,
      d.different_tensors, d.points,
      d.largest_component > 0 ? d.largest / d.largest_component : d.largest);
}

}  // namespace tensortopo::scenarios
