// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "analyze/persistence/curve_transitions.hpp"

#include <algorithm>

#include "tensortopo/mesh/as_size.hpp"

namespace tensortopo {
namespace {

void count_line(const LineSeparation& line, CurveArcCounts& counts) {
  counts.zeros += line.zeros.size();
  if (line.obstacle)
    ++counts.not_proved;
  else if (!line.zeros.empty())
    ++counts.mixed;
  else
    ++(line.begin > 0 ? counts.wedges : counts.trisectors);
}

}  // namespace

CurveArcCounts& CurveArcCounts::operator+=(const CurveArcCounts& other) {
  wedges += other.wedges, trisectors += other.trisectors, mixed += other.mixed;
  not_proved += other.not_proved, zeros += other.zeros, jumps += other.jumps;
  return *this;
}

double CurveTransition::radius() const {
  const auto middle = place.middle();
  // Rounded by less than the last factor.
  return std::max(length(place.high - middle), length(middle - place.low)) * (1 + 0x1p-48);
}

std::vector<CurveArcCounts> count_arcs(const CurveArcs& arcs, std::size_t components,
                                       std::size_t first,
                                       std::vector<CurveTransition>& transitions) {
  const CurveMesh& curves = arcs.curves();
  const CurveSeparation separation = curve_separation(arcs);
  std::vector<CurveArcCounts> counts(components);
  // A jump is said where its second line begins, or where that ends, if it closes the curve.
  std::vector<std::vector<CurveTransition>> of_component(components);
  std::vector<std::vector<const SeparationJump*>> at_line(curves.lines.size());
  for (const SeparationJump& jump : separation.jumps) at_line[jump.lines[1]].push_back(&jump);
  for (std::size_t i = 0; i < curves.lines.size(); ++i) {
    const auto c = as_size(curves.component[i]);
    count_line(separation.lines[i], counts[c]);
    const auto add_jumps = [&](CurveMesh::Index v) {
      for (const SeparationJump* found : at_line[i]) {
        if (found->vertex != v) continue;
        ++counts[c].jumps;
        of_component[c].push_back({first + c,
                                   true,
                                   {curves.tet[found->lines[0]], curves.tet[found->lines[1]]},
                                   found->place});
      }
    };
    add_jumps(curves.lines[i].front());
    for (const PlaceBox& zero : separation.lines[i].zeros)
      of_component[c].push_back({first + c, false, {curves.tet[i]}, zero});
    add_jumps(curves.lines[i].back());
  }
  for (auto& own : of_component) transitions.insert(transitions.end(), own.begin(), own.end());
  return counts;
}

}  // namespace tensortopo
