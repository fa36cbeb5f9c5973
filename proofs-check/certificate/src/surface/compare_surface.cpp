// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "surface/compare_surface.hpp"

#include <algorithm>
#include <map>
#include <numeric>

#include "claims/half_edges.hpp"
#include "surface/pieces.hpp"

namespace certificate {

namespace {

/// Vertices of the level's range only, and all of them.
void check_range(const LevelCase& c, std::span<const HalfEdges::Triangle> triangles) {
  std::vector<bool> used(c.vertices.count);
  for (const auto& triangle : triangles) {
    for (const std::uint32_t v : triangle) {
      if (v - c.vertices.first >= used.size())
        throw Wrong("vertex " + std::to_string(v) + " of another level");
      used[v - c.vertices.first] = true;
    }
  }
  if (const auto unused = std::find(used.begin(), used.end(), false); unused != used.end())
    throw Wrong("vertex " + std::to_string(c.vertices.first + static_cast<Number>(
                                               unused - used.begin())) + " in no triangle");
}

/// Where triangles with one vertex for each crossing have other neighbours.
std::string joined_by_names(std::span<const HalfEdges::Triangle> triangles,
                            std::span<const HalfEdges::Triangle> renamed) {
  std::map<std::array<std::uint32_t, 2>, std::array<std::uint32_t, 2>> before;  // of edges
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      const auto key = std::minmax(renamed[t][i], renamed[t][j]);
      const auto edge = std::minmax(triangles[t][i], triangles[t][j]);
      const std::array own{edge.first, edge.second};
      const auto [known, is_new] = before.try_emplace({key.first, key.second}, own);
      if (key.first == key.second || (!is_new && known->second != own))
        return "further vertices of crossings: the edges " + Json(known->second).dump() + " and " +
               Json(own).dump() + " of triangles have the same crossings at their ends";
    }
  return "further vertices of crossings: two of " + std::to_string(triangles.size()) +
         " triangles become neighbours";
}

}  // namespace

std::optional<PlacedSurface> compare_surface(const LevelCase& c, const CrossingVertices& vertices,
                                             Ledger& ledger) {
  const std::span triangles =
      std::span(c.surface.triangles).subspan(c.triangles.first, c.triangles.count);
  const char* const claimed = "a surface with pieces as in the tetrahedra's sheets";
  std::vector<Piece> components;
  const HalfEdges mesh(triangles);
  try {
    check_range(c, triangles);
    mesh.require_manifold();
    std::vector<std::size_t> all(triangles.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    components = mesh.pieces(all, [](std::size_t, std::size_t, std::size_t) { return true; });
  } catch (const Wrong& wrong) {
    return ledger.refute("triangles", claimed, wrong.what()), std::nullopt;
  }
  const Json& claims = c.claims["components"];
  for (std::size_t i = 0; i < std::max(components.size(), claims.size()); ++i) {
    Json derived, claim;
    if (i < claims.size()) claim = claims[i];
    if (i < components.size())
      derived = {{"euler_characteristic", components[i].euler_characteristic},
                 {"boundary_loops", components[i].loops.size()},
                 {"orientable", true},
                 {"triangles", components[i].triangles},
                 {"first_vertex", components[i].vertices[0]}};
    ledger.settle(claim == derived, "component " + std::to_string(i), claim.dump(), derived.dump());
    if (i < components.size())
      ledger.of_level().components.push_back({components[i].euler_characteristic,
                                              components[i].loops.size(), false,
                                              components[i].triangles});
  }
  // Sheets are claimed in terms of a crossing's first vertex, whichever fan has that.
  std::vector<HalfEdges::Triangle> renamed;
  if (!vertices.original.empty()) renamed.assign(triangles.begin(), triangles.end());
  for (auto& triangle : renamed)
    for (auto& v : triangle)
      if (const auto copy = vertices.original.find(v); copy != vertices.original.end())
        v = static_cast<std::uint32_t>(copy->second);
  const HalfEdges glued(renamed);
  try {
    if (!renamed.empty() && !glued.has_neighbours_of(mesh))
      throw Wrong(joined_by_names(triangles, renamed));
    Pieces pieces(c, vertices, renamed.empty() ? mesh : glued);
    pieces.compare();
    ledger.certify();
    return std::move(pieces).place();
  } catch (const Wrong& wrong) {
    return ledger.refute("triangles", claimed, wrong.what()), std::nullopt;
  }
}

}  // namespace certificate
