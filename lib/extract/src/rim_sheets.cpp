// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>

#include "extractor_scalars.hpp"
#include "tensortopo/extract/tet_sheets.hpp"

namespace tensortopo {

namespace {

using Rim = std::vector<RimVertex>;

constexpr std::size_t kMarks = 4;  // beside four faces, in eight bits

/// Two triangles between an edge of one rim, from `from` on, and an edge of another, up to `to`.
struct Bridge {
  double length;
  std::size_t from, to;

  auto operator<=>(const Bridge&) const = default;
};

constexpr std::size_t kBridges = 6;  // tried one after the other

std::vector<Bridge> shortest_bridges(const Rim& first, const Rim& second) {
  const auto may_join = [](const RimVertex& v, const RimVertex& w) {
    return (v.faces & w.faces) == 0;
  };
  std::vector<Bridge> bridges;
  for (std::size_t i = 0; i < first.size(); ++i)
    for (std::size_t j = 0; j < second.size(); ++j) {
      const auto &a = first[i], &next = first[(i + 1) % first.size()];
      const auto &last = second[(j + second.size() - 1) % second.size()], &w = second[j];
      if (!may_join(a, w) || !may_join(a, last) || !may_join(next, last)) continue;
      bridges.push_back(
          {length(w.position - a.position) + length(next.position - last.position), i, j});
      if (bridges.size() < 4096) continue;
      std::nth_element(bridges.begin(), bridges.begin() + kBridges, bridges.end());
      bridges.resize(kBridges);
    }
  std::sort(bridges.begin(), bridges.end());
  return bridges;
}

using Triangles = std::vector<std::array<std::int32_t, 3>>;

/// One closed way along both rims and the sides of the bridge, with each vertex once. The diagonal
/// of the bridge must not be drawn again: its ends share a mark that stands for a face.
Rim joined(const Rim& first, const Rim& second, const Bridge& bridge, std::uint8_t mark,
           Triangles& triangles) {
  Rim way;
  way.reserve(first.size() + second.size());
  for (std::size_t k = 1; k <= first.size(); ++k)
    way.push_back(first[(bridge.from + k) % first.size()]);
  for (std::size_t k = 0; k < second.size(); ++k)
    way.push_back(second[(bridge.to + k) % second.size()]);
  auto &next = way.front(), &a = way[first.size() - 1], &w = way[first.size()], &last = way.back();
  triangles.push_back({a.id, next.id, last.id});
  triangles.push_back({a.id, last.id, w.id});
  a.faces |= mark, last.faces |= mark;
  return way;
}

/// By the shortest bridge to any of the other rims, but for the first few.
bool join_nearest(Rim& way, std::vector<Rim>& others, std::size_t skipped, Triangles& triangles) {
  if (others.size() > kMarks) return false;
  std::vector<std::pair<Bridge, std::size_t>> shortest;
  for (std::size_t k = 0; k < others.size(); ++k) {
    const auto bridges = shortest_bridges(way, others[k]);
    if (skipped < bridges.size()) shortest.push_back({bridges[skipped], k});
  }
  if (shortest.empty()) return false;
  const auto [bridge, k] = *std::min_element(shortest.begin(), shortest.end());
  const auto mark = static_cast<std::uint8_t>(1u << (3 + others.size()));
  way = joined(way, others[k], bridge, mark, triangles);
  others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
  return true;
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
  for (std::size_t skipped = 0; skipped < (loops > 1 ? kBridges : 1); ++skipped) {
    TetTriangles<Scalar> drawn;
    std::vector<Rim> others(rims.begin() + 1, rims.end());
    Rim way = rims[0];
    while (!others.empty())
      if (!join_nearest(way, others, skipped, drawn.triangles)) return false;
    if (!mesh_within_rim(way, drawn)) continue;
    out.triangles.insert(out.triangles.end(), drawn.triangles.begin(), drawn.triangles.end());
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
