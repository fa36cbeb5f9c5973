// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "touched_maxima.hpp"

#include <algorithm>

#include "tensortopo/field/critical_points.hpp"
#include "tensortopo/tensor/deviator.hpp"

namespace tensortopo::persistence {
namespace {

constexpr std::size_t kMostTets = 2000;
constexpr double kNone = -2;  // below all modes

/// The largest mode at which one of the points may be a maximum along its simplex.
double largest_mode(const std::vector<CriticalPoint>& points, int dimension) {
  double largest = kNone;
  for (const CriticalPoint& point : points)
    if (!point.is_certain || point.index == dimension) largest = std::max(largest, point.high);
  return largest;
}

}  // namespace

struct TouchedMaxima::Region {
  std::vector<Index> tets;
  std::set<Index> has, seen_vertices;
  std::set<Simplex> seen;
  std::set<std::size_t> maxima;

  void add(const std::vector<Index>& more) {
    for (const Index tet : more)
      if (has.insert(tet).second) tets.push_back(tet);
  }
};

TouchedMaxima::Simplex TouchedMaxima::sorted(Simplex simplex) {
  std::sort(simplex.begin(), simplex.end());
  return simplex;
}

TouchedMaxima::TouchedMaxima(const TetMesh& mesh, const VertexStars& stars, Ascent& ascent,
                             const CurveMesh& curves)
    : mesh_(mesh), stars_(stars), ascent_(ascent) {
  for (std::size_t line = 0; line < curves.lines.size(); ++line) {
    const std::size_t component = as_size(curves.component[line]);
    in_tets_[static_cast<Index>(curves.tet[line])].insert(component);
    for (const auto v : curves.lines[line]) {
      Simplex carrier;
      for (std::size_t i = 0; i < 4; ++i)
        carrier[i] = static_cast<Index>(curves.carrier_vertices[as_size(v)][i]);
      on_carriers_[sorted(carrier)].insert(component);
    }
  }
}

void TouchedMaxima::add(const MeshCriticalPoint& point, std::size_t maximum) {
  for (const Index tet : stars_.around(point.vertices)) in_tets_[tet].insert(maximum);
}

bool TouchedMaxima::may_have_maximum(const Simplex& simplex, double low) {
  const auto [found, is_new] = largest_.try_emplace(simplex, kNone);
  if (is_new) {
    const auto tensor = [&](std::size_t i) { return mesh_.tensors[as_size(simplex[i])]; };
    found->second =
        simplex[1] < 0
            ? largest_mode(critical_points_on_edge({tensor(2), tensor(3)}, {}), 1)
            : largest_mode(critical_points_on_face({tensor(1), tensor(2), tensor(3)}, {}), 2);
  }
  return found->second >= low;
}

void TouchedMaxima::look_at(Index tet, const MeshCriticalPoint& point, Region& region) {
  if (const auto found = in_tets_.find(tet); found != in_tets_.end())
    region.maxima.insert(found->second.begin(), found->second.end());
  const auto& corners = mesh_.tets[as_size(tet)];
  for (const Index v : corners) {
    if (point.dimension == 0 && v == point.vertices[0]) continue;
    const SymmetricTensor<double>& t = mesh_.tensors[as_size(v)];
    if (!region.seen_vertices.insert(v).second || deviator(t) == Deviator<double>{}) continue;
    if (mode_range(deviator_box({t, t, t, t}, {1, 0, 0, 0}))[1] < point.low) continue;
    if (const auto maximum = ascent_.from_vertex(v))
      region.maxima.insert(*maximum);
    else
      region.add(stars_.around(std::array{v}));
  }
  for (int used = 1; used < 15; ++used) {
    Simplex simplex{-1, -1, -1, -1};
    int count = 0;
    for (std::size_t i = 0; i < 4; ++i)
      if ((used >> i & 1) != 0) simplex[i] = corners[i], ++count;
    if (count < 2) continue;
    simplex = sorted(simplex);
    if (!region.seen.insert(simplex).second) continue;
    if (const auto found = on_carriers_.find(simplex); found != on_carriers_.end())
      region.maxima.insert(found->second.begin(), found->second.end());
    if (!may_have_maximum(simplex, point.low)) continue;
    std::vector<Index> vertices(simplex.begin() + (4 - count), simplex.end());
    region.add(stars_.around(vertices));
  }
}

std::optional<std::vector<std::size_t>> TouchedMaxima::at(const MeshCriticalPoint& point) {
  Region region;
  region.add(stars_.around(point.vertices));
  for (std::size_t i = 0; i < region.tets.size(); ++i) {
    if (region.tets.size() > kMostTets) return std::nullopt;
    look_at(region.tets[i], point, region);
  }
  return std::vector<std::size_t>(region.maxima.begin(), region.maxima.end());
}

}  // namespace tensortopo::persistence
