// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/patch/charts/defect_cuts.hpp"

#include <algorithm>

namespace tensortopo {

namespace {

using Edge = std::array<std::size_t, 2>;
using Cut = ChartTriangulation::Cut;

/// So many times the defects may become no fewer.
constexpr int kPatience = 3;

Edge undirected(std::size_t a, std::size_t b) { return {std::min(a, b), std::max(a, b)}; }

}  // namespace

std::vector<Cut> DefectCuts::operator()(std::span<const ChartTriangulation::Triangle> triangles,
                                        std::span<const Vector3<double>> points,
                                        std::span<const Edge> segments) {
  std::vector<Edge> directed(segments.begin(), segments.end()), either;
  for (const auto& [a, b] : segments) either.push_back(undirected(a, b));
  std::sort(directed.begin(), directed.end());
  std::sort(either.begin(), either.end());
  const auto is_in = [](const std::vector<Edge>& list, const Edge& e) {
    return std::binary_search(list.begin(), list.end(), e);
  };
  // The chart may be a mirror image: then boundary loops run the other way.
  std::ptrdiff_t same = 0;
  for (const auto& t : triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      same += is_in(directed, {t[i], t[(i + 1) % 3]});
      same -= is_in(directed, {t[(i + 1) % 3], t[i]});
    }
  PlacedPatch patch;
  patch.points.assign(points.begin(), points.end());
  for (const auto& t : triangles) {
    const auto at = [&](std::size_t i) { return static_cast<std::uint32_t>(t[i]); };
    patch.triangles.push_back({at(0), at(same >= 0 ? 1 : 2), at(same >= 0 ? 2 : 1)});
  }
  const auto defects = defects_of(patch, test_);
  std::vector<char> has_defect(triangles.size(), 0);
  for (const auto i : defects.against) has_defect[i] = 1;
  for (const auto& pair : defects.intersecting)
    for (const auto i : pair) has_defect[i] = 1;
  std::vector<Cut> cuts(triangles.size(), Cut::none);
  const auto count =
      static_cast<std::size_t>(std::count(has_defect.begin(), has_defect.end(), char{1}));
  if (count < fewest_)
    fewest_ = count, since_ = 0;
  else if (++since_ > kPatience)
    return cuts;
  constexpr Cut edges[3] = {Cut::edge0, Cut::edge1, Cut::edge2};
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    if (!has_defect[k]) continue;
    const auto& t = triangles[k];
    double longest = -1;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto a = t[(i + 1) % 3], b = t[(i + 2) % 3];
      const auto d = points[b] - points[a];
      if (!(dot(d, d) > longest)) continue;
      longest = dot(d, d);
      cuts[k] = is_in(either, undirected(a, b)) ? Cut::amid : edges[i];
    }
  }
  return cuts;
}

}  // namespace tensortopo
