// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "baselines/triangle_soup.hpp"

#include <bit>
#include <cstdint>
#include <tuple>
#include <unordered_map>

#include "tensortopo/mesh/surface_invariants.hpp"

namespace tensortopo::baselines {

namespace {

struct Place {
  std::array<std::uint64_t, 3> bits;
  bool operator==(const Place&) const = default;
};

struct PlaceHash {
  std::size_t operator()(const Place& p) const {
    std::uint64_t h = 0;
    for (const auto b : p.bits) {
      h = (h ^ b) * 0x9e3779b97f4a7c15ull;
      h ^= h >> 29;
    }
    return static_cast<std::size_t>(h);
  }
};

Place place_of(const Vector3<double>& p) {
  // Adding zero makes -0 equal to 0.
  return {{std::bit_cast<std::uint64_t>(p.x + 0.0), std::bit_cast<std::uint64_t>(p.y + 0.0),
           std::bit_cast<std::uint64_t>(p.z + 0.0)}};
}

}  // namespace

SurfaceMesh merge(const std::vector<std::vector<SoupTriangle>>& by_tet, double mode) {
  SurfaceMesh surface;
  std::unordered_map<Place, SurfaceMesh::Index, PlaceHash> vertex;
  for (const auto& triangles : by_tet)
    for (const auto& triangle : triangles) {
      std::array<SurfaceMesh::Index, 3> corners;
      for (std::size_t i = 0; i < 3; ++i) {
        const auto next = static_cast<SurfaceMesh::Index>(surface.points.size());
        const auto [found, is_new] = vertex.emplace(place_of(triangle.corners[i]), next);
        if (is_new) surface.points.push_back(triangle.corners[i]);
        corners[i] = found->second;
      }
      if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0])
        continue;
      surface.triangles.push_back(corners);
      surface.tet.push_back(triangle.tet);
    }
  surface.mode.assign(surface.points.size(), mode);
  surface.component = surface_components(surface);
  return surface;
}

bool comes_first(const Vector3<double>& p, const Vector3<double>& q) {
  return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
}

}  // namespace tensortopo::baselines
