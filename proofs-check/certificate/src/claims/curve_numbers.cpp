// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "claims/curve_numbers.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "union_find.hpp"

namespace certificate {
namespace {

/// A face without the level falls into regions. In each part of its refinement the points on one
/// side are in one of them.
class Regions {
 public:
  using Region = std::optional<std::size_t>;

  explicit Regions(const Refinement& refinement) : refinement_(refinement) {
    for (const Refinement::Cell& cell : refinement.cells())
      for (std::size_t i = 0; i < 3 && !cell.cut; ++i)
        for (std::size_t j = 0; j < i; ++j)
          if (is_above(cell.points[i]) == is_above(cell.points[j]))
            classes_.join(cell.points[i], cell.points[j]);
  }

  Region of(Refinement::Id point) { return classes_.find(point); }
  /// @param above  the side of the point at that place
  Region at(const Place<3>& place, bool above) {
    for (const Refinement::Cell& cell : refinement_.cells()) {
      if (cell.cut) continue;
      std::array<Place<3>, 3> tile;
      for (std::size_t i = 0; i < 3; ++i)
        tile[i] = without(refinement_.points()[cell.points[i]].weights, 3);
      const Place<3> inside = weights_at(tile, place);
      if (inside[0] < 0 || inside[1] < 0 || inside[2] < 0) continue;
      for (std::size_t i = 0; i < 3; ++i)
        if (is_above(cell.points[i]) == above) return of(cell.points[i]);
    }
    return std::nullopt;
  }

 private:
  bool is_above(Refinement::Id point) const { return refinement_.points()[point].above; }

  const Refinement& refinement_;
  UnionFind classes_;
};

}  // namespace

/// A curve is the only one between the regions on both sides of it, as these are joined like the
/// vertices of a tree. An edge that it crosses tells which these are, in any other refinement.
std::vector<std::size_t> curve_numbers(const LevelCase& c, const FaceTopology& face) {
  std::array<std::size_t, 3> order{0, 1, 2};
  const auto place = [&](std::size_t i) {
    const auto& p = c.input.points[face.vertices[i]];
    return std::array{p[0] + 0.0, p[1] + 0.0, p[2] + 0.0};  // both zeros are one
  };
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t j) { return place(i) < place(j); });
  std::array<Corner, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vertex v = face.vertices[order[k]];
    corners[k] = c.field.corner(v, c.topology.above[v] != 0);
  }
  const EdgeLevel first = level_in_edge(c.level, {corners[0], corners[1]}),
                  middle = level_in_edge(c.level, {corners[0], corners[2]}),
                  last = level_in_edge(c.level, {corners[1], corners[2]});
  const FaceLevel ordered = level_in_face(c.level, corners, {&first, &middle, &last});
  const std::size_t count = face.level.loops.size();
  if (!ordered.decided || ordered.loops.size() != count) return {};
  Regions regions(*ordered.refinement);
  using Sides = std::array<Regions::Region, 2>;
  std::map<Sides, std::size_t> number;  // by the regions on both sides, ascending
  for (std::size_t n = 0; n < count; ++n) {
    const auto& [a, b] = ordered.loops[n].front();
    Sides sides{regions.of(a), regions.of(b)};
    std::sort(sides.begin(), sides.end());
    number[sides] = n;
  }
  std::vector<std::size_t> result;
  for (const auto& curve : face.level.loops) {
    Sides sides;
    for (std::size_t end = 0; end < 2; ++end) {
      const Refinement::Point& p = face.level.refinement->points()[curve.front()[end]];
      sides[end] =
          regions.at({p.weights[order[0]], p.weights[order[1]], p.weights[order[2]]}, p.above);
    }
    std::sort(sides.begin(), sides.end());
    const auto found = number.find(sides);
    if (found == number.end()) return {};
    result.push_back(found->second);
  }
  return result;
}

}  // namespace certificate
