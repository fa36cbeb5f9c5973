// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/surface/cone_points.hpp"
#include "tensortopo/mesh/union_find.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <utility>

namespace tensortopo {

namespace {

using Index = SurfaceMesh::Index;
using Origins = std::vector<std::array<Index, 2>>;

/// Cuts the triangles with two isotropic vertices. Those made halfway count as others: there
/// is no more than one fan at each.
void cut_at_halfway(SurfaceMesh& surface, std::vector<char>& is_zero, std::span<const Index> sector,
                    Origins& origins) {
  std::vector<Index> halfway;
  decltype(surface.triangles) triangles;
  decltype(surface.tet) tet;
  triangles.reserve(surface.triangles.size());
  tet.reserve(surface.tet.size());
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    auto corners = surface.triangles[i];
    tet.push_back(surface.tet[i]);
    if (sector[i] < 0) {
      triangles.push_back(corners);
      continue;
    }
    while (is_zero[as_size(corners[0])])
      std::rotate(corners.begin(), corners.begin() + 1, corners.end());
    const auto [foot, from, to] = corners;
    if (as_size(sector[i]) >= halfway.size()) halfway.resize(as_size(sector[i]) + 1, -1);
    Index& middle = halfway[as_size(sector[i])];
    if (middle < 0) {
      middle = static_cast<Index>(surface.points.size());
      const auto &p = surface.points[as_size(from)], &q = surface.points[as_size(to)];
      // Half of each: a sum could overflow.
      surface.points.push_back(p + 0.5 * (q - p));
      is_zero.push_back(0);
      origins.push_back({from, to});
    }
    triangles.push_back({foot, from, middle});
    triangles.push_back({foot, middle, to});
    tet.push_back(surface.tet[i]);
  }
  surface.triangles = std::move(triangles);
  surface.tet = std::move(tet);
}

/// One side of a triangle that ends at an isotropic vertex.
struct Ray {
  Index apex, other;
  std::uint32_t corner;  ///< 3 * triangle + which of its corners the apex is
};

}  // namespace

std::vector<std::array<Index, 2>> separate_fans(SurfaceMesh& surface, std::vector<char>& is_zero,
                                                std::span<const Index> sector) {
  Origins origins;
  cut_at_halfway(surface, is_zero, sector, origins);
  std::vector<Ray> rays;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& corners = surface.triangles[i];
      if (!is_zero[as_size(corners[k])]) continue;
      const auto corner = static_cast<std::uint32_t>(3 * i + k);
      rays.push_back({corners[k], corners[(k + 1) % 3], corner});
      rays.push_back({corners[k], corners[(k + 2) % 3], corner});
    }
  // Fans, as classes of corners.
  UnionFind fans(rays.size() / 2);
  std::vector<std::uint32_t> order(rays.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::tie(rays[a].apex, rays[a].other, a) < std::tie(rays[b].apex, rays[b].other, b);
  });
  for (std::size_t i = 1; i < order.size(); ++i) {
    const Ray &a = rays[order[i - 1]], &b = rays[order[i]];
    if (a.apex != b.apex || a.other != b.other) continue;
    fans.unite(order[i - 1] / 2, order[i] / 2);
  }
  // The first fan at a vertex keeps it.
  std::vector<char> taken(is_zero.size(), 0);
  std::vector<Index> vertex_of(fans.size(), -1);
  for (std::uint32_t i = 0; i < fans.size(); ++i) {
    const Ray& ray = rays[2 * i];
    Index& vertex = vertex_of[fans.find(i)];
    if (vertex < 0) {
      vertex = ray.apex;
      if (std::exchange(taken[as_size(ray.apex)], char{1})) {
        vertex = static_cast<Index>(surface.points.size());
        const auto point = surface.points[as_size(ray.apex)];
        surface.points.push_back(point);
        is_zero.push_back(1);
        origins.push_back({ray.apex, ray.apex});
      }
    }
    surface.triangles[ray.corner / 3][ray.corner % 3] = vertex;
  }
  return origins;
}

}  // namespace tensortopo
