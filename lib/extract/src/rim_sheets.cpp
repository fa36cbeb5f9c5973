// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>

#include "extractor_scalars.hpp"
#include "tensortopo/extract/polygon.hpp"
#include "tensortopo/extract/tet_sheets.hpp"

namespace tensortopo {

namespace {

using Rim = std::vector<RimVertex>;

constexpr std::size_t kMarks = 4;  // beside four faces, in eight bits

/// A segment from a corner of one rim to a corner of another, no two on one face.
struct Seam {
  double length;
  std::size_t from, to;

  auto operator<=>(const Seam&) const = default;
};

std::vector<Seam> seams_between(const Rim& first, const Rim& second) {
  std::vector<Seam> seams;
  for (std::size_t i = 0; i < first.size(); ++i)
    for (std::size_t j = 0; j < second.size(); ++j)
      if ((first[i].faces & second[j].faces) == 0)
        seams.push_back({length(second[j].position - first[i].position), i, j});
  std::sort(seams.begin(), seams.end());
  return seams;
}

/// One closed way around both, forth and back along the seam. No diagonal may run beside the seam:
/// its ends share a mark that stands for a face.
Rim joined(Rim first, Rim second, const Seam& seam, std::uint8_t mark) {
  first[seam.from].faces |= mark, second[seam.to].faces |= mark;
  Rim way;
  way.reserve(first.size() + second.size() + 2);
  way.insert(way.end(), first.begin(), first.begin() + static_cast<std::ptrdiff_t>(seam.from) + 1);
  for (std::size_t k = 0; k <= second.size(); ++k)
    way.push_back(second[(seam.to + k) % second.size()]);
  way.insert(way.end(), first.begin() + static_cast<std::ptrdiff_t>(seam.from), first.end());
  return way;
}

/// The shortest seam to any of the other rims, but for the first few.
bool join_nearest(Rim& way, std::vector<Rim>& others, std::size_t skipped) {
  if (others.size() > kMarks) return false;
  std::vector<std::pair<Seam, std::size_t>> shortest;
  for (std::size_t k = 0; k < others.size(); ++k) {
    const auto seams = seams_between(way, others[k]);
    if (skipped < seams.size()) shortest.push_back({seams[skipped], k});
  }
  if (shortest.empty()) return false;
  const auto [seam, k] = *std::min_element(shortest.begin(), shortest.end());
  way = joined(way, others[k], seam, static_cast<std::uint8_t>(1u << (3 + others.size())));
  others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
  return true;
}

/// No edge twice: pieces of a cut can meet in both copies of a seam's ends.
bool is_surface(const Rim& way, std::span<const std::array<int, 3>> triangles) {
  std::vector<std::pair<std::int32_t, std::int32_t>> sides;
  for (const auto& t : triangles)
    for (std::size_t i = 0; i < 3; ++i)
      sides.push_back({way[static_cast<std::size_t>(t[i])].id,
                       way[static_cast<std::size_t>(t[(i + 1) % 3])].id});
  std::sort(sides.begin(), sides.end());
  return std::adjacent_find(sides.begin(), sides.end()) == sides.end() &&
         std::none_of(sides.begin(), sides.end(),
                      [](const auto& s) { return s.first == s.second; });
}

}  // namespace

template <class Scalar>
bool mesh_from_rims(const TetPlan<Scalar>& plan, const SheetTopology& sheet,
                    const FaceArcVertices& vertices, TetTriangles<Scalar>& out) {
  const auto loops = static_cast<int>(sheet.loops.size());
  if (loops == 0 || sheet.euler_characteristic != 2 - loops) return false;
  std::vector<Rim> rims;
  for (const int loop : sheet.loops)
    rims.push_back(loop_vertices(plan.loops[static_cast<std::size_t>(loop)], vertices));
  constexpr std::size_t kSeams = 8;  // tried one after the other; without any, once
  for (std::size_t skipped = 0; skipped < (loops > 1 ? kSeams : 1); ++skipped) {
    std::vector<Rim> others(rims.begin() + 1, rims.end());
    Rim way = rims[0];
    while (!others.empty())
      if (!join_nearest(way, others, skipped)) return false;
    std::vector<PolygonCorner> corners;
    for (const auto& v : way) corners.push_back({v.position, v.faces});
    const auto triangles = cut_polygon(corners);
    if (triangles.empty() || !is_surface(way, triangles)) continue;
    for (const auto& t : triangles)
      out.triangles.push_back({way[static_cast<std::size_t>(t[0])].id,
                               way[static_cast<std::size_t>(t[1])].id,
                               way[static_cast<std::size_t>(t[2])].id});
    return true;
  }
  return false;
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                       \
  template bool mesh_from_rims(const TetPlan<Scalar>&, const SheetTopology&, \
                               const FaceArcVertices&, TetTriangles<Scalar>&);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
