// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "distances/isotopic_tets.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <utility>

#include "distances/enclosed_triangles.hpp"
#include "run/for_each.hpp"

namespace tensortopo {

namespace {

using Index = TetMesh::Index;
using detail::Enclosed;

/// How far a vertex may be from the point that it stands for, in parts of the largest coordinate of
/// the tetrahedra around: sixteen times what a checker allows for rounding.
constexpr double kRounding = 0x1p-46;

std::array<Index, 3> face_opposite(std::array<Index, 4> tet, std::size_t corner) {
  std::sort(tet.begin(), tet.end());
  std::array<Index, 3> face{};
  for (std::size_t i = 0, n = 0; i < 4; ++i)
    if (i != corner) face[n++] = tet[i];
  return face;
}

/// By the topology alone: tetrahedra whose sheets are discs, and curves of faces told apart by
/// their ends.
std::vector<char> are_of_discs(const TetMesh& mesh, const LevelTopology& topology) {
  std::set<std::array<Index, 3>> mixed;
  for (const auto& face : topology.faces)
    if (face.loops.size() > 1 || (face.loops.size() == 1 && !face.arcs.empty()))
      mixed.insert(face.vertices);
  std::vector<char> result(mesh.tets.size(), 0);
  for (const auto& tet : topology.tets) {
    bool is_simple =
        std::all_of(tet.sheets.begin(), tet.sheets.end(), [](const LevelTopology::Sheet& sheet) {
          return sheet.euler_characteristic == 1 && sheet.loops.size() == 1;
        });
    for (std::size_t i = 0; i < 4 && !mixed.empty(); ++i)
      is_simple = is_simple && !mixed.contains(face_opposite(mesh.tets[as_size(tet.tet)], i));
    result[as_size(tet.tet)] = is_simple;
  }
  return result;
}

/// Tetrahedra with other sheets, or curves, but near to the level, and without closed sheets but
/// spheres.
std::vector<Index> tets_near_other_sheets(const LevelTopology& topology,
                                          std::span<const char> of_discs,
                                          std::span<const Index> coarse) {
  std::vector<Index> result;
  for (const auto& tet : topology.tets) {
    if (of_discs[as_size(tet.tet)] || std::binary_search(coarse.begin(), coarse.end(), tet.tet))
      continue;
    if (std::none_of(tet.sheets.begin(), tet.sheets.end(), [](const LevelTopology::Sheet& sheet) {
          return sheet.loops.empty() && sheet.euler_characteristic != 2;
        }))
      result.push_back(tet.tet);
  }
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace

std::vector<Index> tets_not_isotopic(const TetMesh& mesh, const SurfaceMesh& surface,
                                     std::span<const std::size_t> triangles,
                                     const LevelTopology& topology, std::span<const Index> coarse,
                                     const MovedPlaces& moved) {
  auto is_shown = are_of_discs(mesh, topology);
  for (const Index t : tets_of_layers(surface, triangles,
                                      tets_near_other_sheets(topology, is_shown, coarse), moved))
    is_shown[as_size(t)] = 1;
  std::vector<Enclosed> points(surface.points.size());
  for (std::size_t v = 0; v < points.size(); ++v) points[v].value = surface.points[v];
  for (const auto t : triangles) {
    double largest = 0;
    for (const Index corner : mesh.tets[as_size(surface.tet[t])])
      largest = std::max(largest, max_norm(mesh.points[as_size(corner)]));
    for (const auto v : surface.triangles[t]) {
      const double error = std::max(points[as_size(v)].error.x, kRounding * largest);
      points[as_size(v)].error = {error, error, error};
    }
  }
  std::vector<char> is_misplaced(points.size(), 0);
  for (const auto& [vertex, copy] : topology.copies)
    is_misplaced[as_size(vertex)] = is_misplaced[as_size(copy)] = 1;
  for (const auto& edge : topology.edges)
    for (std::size_t k = 1; k < edge.crossings.size(); ++k) {
      const auto v = as_size(edge.crossings[k - 1].vertex), w = as_size(edge.crossings[k].vertex);
      const auto along =
          mesh.points[as_size(edge.vertices[1])] - mesh.points[as_size(edge.vertices[0])];
      if (!detail::is_on_side(along, std::array{detail::minus(points[w], points[v])}))
        is_misplaced[v] = is_misplaced[w] = 1;
    }
  for (const auto t : triangles)
    for (const auto v : surface.triangles[t])
      if (is_misplaced[as_size(v)]) is_shown[as_size(surface.tet[t])] = 0;

  std::vector<PatchTriangle> asked;
  std::vector<Index> tets;
  std::vector<AxisBox> boxes;
  for (const auto t : triangles) {
    if (!is_shown[as_size(surface.tet[t])]) continue;
    tets.push_back(surface.tet[t]);
    auto& triangle = asked.emplace_back();
    for (std::size_t i = 0; i < 3; ++i)
      triangle[i] = static_cast<std::uint32_t>(surface.triangles[t][i]);
    boxes.push_back(detail::box_of(points, triangle));
  }
  const auto pairs = meeting_boxes(boxes);
  std::vector<char> is_apart(pairs.size()), has_area(asked.size());
  detail::for_each(pairs.size(), [&](std::size_t i) {
    is_apart[i] = detail::are_apart(points, asked[pairs[i][0]], asked[pairs[i][1]]);
  });
  detail::for_each(asked.size(), [&](std::size_t i) {
    has_area[i] = detail::have_common_side(std::array{detail::normal_of(points, asked[i])});
  });
  for (std::size_t i = 0; i < pairs.size(); ++i)
    for (const auto t : pairs[i])
      if (!is_apart[i]) is_shown[as_size(tets[t])] = 0;
  for (std::size_t i = 0; i < asked.size(); ++i)
    if (!has_area[i]) is_shown[as_size(tets[i])] = 0;
  std::vector<Index> result;
  for (const auto t : triangles)
    if (!is_shown[as_size(surface.tet[t])]) result.push_back(surface.tet[t]);
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

}  // namespace tensortopo
