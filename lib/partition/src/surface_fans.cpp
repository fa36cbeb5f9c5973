// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "surface_fans.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "crossed_cells.hpp"
#include "tensortopo/mesh/union_find.hpp"

namespace tensortopo {

namespace {

using Index = SurfaceMesh::Index;

bool is_crossing(const SurfaceMesh& surface, std::size_t v) {
  return surface.carrier[v] == Carrier::edge &&
         !(surface.medium_eigenvector[v] == Vector3<double>{});
}

/// Classes of the corners of triangles, 3 * triangle + corner: those of one fan.
/// @param apart  pairs of triangles, ascending, that share a side and are not of one fan there
UnionFind fans_of(const SurfaceMesh& surface, const std::set<std::array<std::size_t, 2>>& apart) {
  struct Side {
    Index low, high;
    std::uint32_t at_low, at_high;  // corners
  };
  std::vector<Side> sides;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t l = (k + 1) % 3;
      Side side{surface.triangles[i][k], surface.triangles[i][l],
                static_cast<std::uint32_t>(3 * i + k), static_cast<std::uint32_t>(3 * i + l)};
      if (side.high < side.low)
        std::swap(side.low, side.high), std::swap(side.at_low, side.at_high);
      sides.push_back(side);
    }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.low, a.high, a.at_low) < std::tie(b.low, b.high, b.at_low);
  });
  UnionFind fans(3 * surface.triangles.size());
  for (std::size_t i = 1; i < sides.size(); ++i) {
    const Side &a = sides[i - 1], &b = sides[i];
    if (a.low != b.low || a.high != b.high) continue;
    const std::size_t first = a.at_low / 3, second = b.at_low / 3;
    if (apart.contains({std::min(first, second), std::max(first, second)})) continue;
    fans.unite(a.at_low, b.at_low), fans.unite(a.at_high, b.at_high);
  }
  return fans;
}

/// Sheets of cones get the tips of their triangles.
/// @param before  the triangles with the vertices that the sheets name
/// @param tips  that some triangles had and do not have any more
void name_tips(const std::vector<std::array<Index, 3>>& before, const SurfaceMesh& surface,
               const std::set<Index>& tips, std::vector<LevelTopology::Cone>& cones) {
  const auto is_isotropic = [&](Index v) {
    return surface.carrier[as_size(v)] == Carrier::vertex ||
           (surface.carrier[as_size(v)] == Carrier::edge && !is_crossing(surface, as_size(v)));
  };
  std::map<Index, std::vector<std::uint32_t>> by_tet;
  for (std::uint32_t i = 0; i < before.size(); ++i) by_tet[surface.tet[i]].push_back(i);
  for (LevelTopology::Cone& cone : cones) {
    const std::vector<std::uint32_t>& triangles = by_tet[cone.tet];
    UnionFind pieces(triangles.size());
    std::map<std::array<Index, 2>, std::uint32_t> sides;
    for (std::uint32_t n = 0; n < triangles.size(); ++n)
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [low, high] =
            std::minmax(before[triangles[n]][k], before[triangles[n]][(k + 1) % 3]);
        if (is_isotropic(low) && is_isotropic(high)) continue;
        pieces.unite(sides.try_emplace({low, high}, n).first->second, n);
      }
    std::map<std::pair<std::uint32_t, Index>, Index> now;  // of a piece's vertices
    for (std::uint32_t n = 0; n < triangles.size(); ++n)
      for (std::size_t k = 0; k < 3; ++k)
        now[{pieces.find(n), before[triangles[n]][k]}] = surface.triangles[triangles[n]][k];
    for (LevelTopology::ConeSheet& sheet : cone.sheets) {
      std::uint32_t n = 0;
      while (!now.contains({pieces.find(n), sheet[0]})) ++n;
      for (Index& v : sheet)
        if (tips.contains(v)) v = now.at({pieces.find(n), v});
    }
  }
}

/// Another vertex like v, after all others.
Index add_copy(PieceSurface& piece, std::size_t v, std::int32_t ordinal) {
  SurfaceMesh& surface = piece.surface;
  const auto repeat = [&](auto& values) {
    const auto value = values[v];
    values.push_back(value);
  };
  repeat(surface.points), repeat(surface.carrier), repeat(surface.carrier_vertices);
  repeat(surface.medium_eigenvector), repeat(surface.dominant_eigenvector);
  repeat(surface.normal), repeat(surface.mode), repeat(surface.residual);
  piece.ordinals.push_back(ordinal);
  return static_cast<Index>(surface.points.size() - 1);
}

}  // namespace

void join_copies(PieceSurface& piece) {
  SurfaceMesh& surface = piece.surface;
  std::vector<Index> order(surface.points.size()), original(order.size());
  std::iota(order.begin(), order.end(), 0);
  std::iota(original.begin(), original.end(), 0);
  std::erase_if(order, [&](Index v) { return !is_crossing(surface, as_size(v)); });
  const auto key = [&](Index v) {
    return std::tie(surface.carrier_vertices[as_size(v)], piece.ordinals[as_size(v)]);
  };
  std::sort(order.begin(), order.end(), [&](Index a, Index b) { return key(a) < key(b); });
  for (std::size_t i = 0, first = 0; i < order.size(); ++i) {
    const auto v = as_size(order[i]);
    if (surface.carrier_vertices[v] != surface.carrier_vertices[as_size(order[first])]) first = i;
    for (std::size_t j = first; j < i; ++j) {
      const auto u = as_size(order[j]);
      if (!same_bits(surface.points[u], surface.points[v]) ||
          !same_bits(surface.medium_eigenvector[u], surface.medium_eigenvector[v]))
        continue;
      original[v] = original[u];
      break;
    }
  }
  for (auto& triangle : surface.triangles)
    for (Index& v : triangle) v = original[as_size(v)];
}

void separate_copies(PieceSurface& piece, const std::set<std::array<std::size_t, 2>>& apart) {
  SurfaceMesh& surface = piece.surface;
  const std::vector<std::array<Index, 3>> before = surface.triangles;
  UnionFind fans = fans_of(surface, apart);
  std::map<std::array<Index, 4>, std::int32_t> next;  // ordinals, by carrier
  for (std::size_t v = 0; v < surface.points.size(); ++v) {
    if (surface.carrier[v] != Carrier::edge && surface.carrier[v] != Carrier::vertex) continue;
    auto& ordinal = next[surface.carrier_vertices[v]];
    ordinal = std::max(ordinal, piece.ordinals[v] + 1);
  }
  constexpr auto kNone = static_cast<std::uint32_t>(-1);
  std::vector<std::uint32_t> first(surface.points.size(), kNone);  // the fan that keeps a vertex
  std::map<std::uint32_t, Index> copies;                           // of other fans
  std::set<Index> tips;                                            // that have copies
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      Index& corner = surface.triangles[i][k];
      const auto v = as_size(corner);
      const std::uint32_t fan = fans.find(static_cast<std::uint32_t>(3 * i + k));
      if (first[v] == kNone) first[v] = fan;
      if (first[v] == fan) continue;
      if (!is_crossing(surface, v)) tips.insert(corner);
      const auto [copy, is_new] = copies.try_emplace(fan, -1);
      if (is_new) copy->second = add_copy(piece, v, next[surface.carrier_vertices[v]]++);
      corner = copy->second;
    }
  if (piece.topology && !tips.empty()) name_tips(before, surface, tips, piece.topology->cones);
}

}  // namespace tensortopo
