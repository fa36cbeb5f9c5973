// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "distances/layers.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>

#include "distances/enclosed_triangles.hpp"
#include "run/for_each.hpp"

namespace tensortopo {

namespace {

using detail::Enclosed;
using Index = TetMesh::Index;
using Vector = Vector3<double>;

/// A checker moves vertices in arithmetic of its own: how far its places may be from these, in
/// parts of the way from one to the other, and of the largest coordinate.
constexpr double kOfWay = 0x1p-10, kOfCoordinate = 0x1p-46;

class TetLayers {
 public:
  TetLayers(const SurfaceMesh& surface, Index tet, const MovedPlaces& moved)
      : surface_(surface), tet_(tet), moved_(moved) {}

  void add(std::size_t triangle) {
    auto& corners = triangles_.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) corners[i] = place_of(surface_.triangles[triangle][i]);
  }

  bool are_embedded() const {
    std::vector<AxisBox> boxes;
    for (const auto& triangle : triangles_) {
      const Enclosed normal = detail::normal_of(points_, triangle);
      for (const auto v : triangle)
        if (!(detail::least_product(normal, steps_[v]) > 0)) return false;
      boxes.push_back(detail::box_of(points_, triangle));
    }
    const auto pairs = meeting_boxes(boxes);
    return std::all_of(pairs.begin(), pairs.end(), [&](const auto& pair) {
      return detail::are_apart(points_, triangles_[pair[0]], triangles_[pair[1]]);
    });
  }

 private:
  std::uint32_t place_of(Index vertex) {
    const auto [known, is_new] =
        places_.emplace(vertex, static_cast<std::uint32_t>(points_.size()));
    if (is_new) {
      const auto moved = moved_(tet_, vertex);
      const Vector &behind = moved[0], &ahead = moved[1];
      const Vector& x = surface_.points[as_size(vertex)];
      const Vector step = ahead - behind;
      const double rounding = kOfCoordinate * (max_norm(x) + max_norm(step)),
                   margin = kOfWay * max_norm(step) + rounding;
      const auto spread = [&](double Vector::*axis) {
        return std::max(std::abs(ahead.*axis - x.*axis), std::abs(behind.*axis - x.*axis)) + margin;
      };
      points_.push_back({x, {spread(&Vector::x), spread(&Vector::y), spread(&Vector::z)}});
      steps_.push_back({step, {margin, margin, margin}});
    }
    return known->second;
  }

  const SurfaceMesh& surface_;
  Index tet_;
  const MovedPlaces& moved_;
  std::map<Index, std::uint32_t> places_;
  std::vector<Enclosed> points_, steps_;
  std::vector<PatchTriangle> triangles_;
};

}  // namespace

std::vector<Index> tets_of_layers(const SurfaceMesh& surface,
                                  std::span<const std::size_t> triangles,
                                  std::span<const Index> tets, const MovedPlaces& moved) {
  std::vector<std::vector<std::size_t>> members(tets.size());
  for (const auto t : triangles) {
    const auto at = std::lower_bound(tets.begin(), tets.end(), surface.tet[t]);
    if (at != tets.end() && *at == surface.tet[t])
      members[static_cast<std::size_t>(at - tets.begin())].push_back(t);
  }
  std::vector<char> are_embedded(tets.size());
  detail::for_each(tets.size(), [&](std::size_t i) {
    TetLayers layers(surface, tets[i], moved);
    for (const auto t : members[i]) layers.add(t);
    are_embedded[i] = layers.are_embedded();
  });
  std::vector<Index> result;
  for (std::size_t i = 0; i < tets.size(); ++i)
    if (are_embedded[i]) result.push_back(tets[i]);
  return result;
}

}  // namespace tensortopo
