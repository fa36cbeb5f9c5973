// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "touched_maxima.hpp"

#include <algorithm>
#include <cstdint>

#include "tensortopo/field/critical_points.hpp"
#include "tensortopo/tensor/deviator.hpp"

namespace tensortopo::persistence {
namespace {

constexpr std::size_t kMostTets = 2000;

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
                             SimplexMaxima& along, const CurveMesh& curves)
    : mesh_(mesh), stars_(stars), ascent_(ascent), along_(along) {
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
  bounds_.insert({maximum, {point.high, point.gap_low}});
}

bool TouchedMaxima::may_be_above(const ModeBound& bound, const MeshCriticalPoint& point) {
  return bound.high >= point.low && !(point.low > 0 && bound.gap_low > point.gap_high);
}

void TouchedMaxima::add_maxima(const std::set<std::size_t>& maxima, const MeshCriticalPoint& point,
                               Region& region) const {
  for (const std::size_t maximum : maxima) {
    const auto found = bounds_.find(maximum);
    if (found == bounds_.end() || may_be_above(found->second, point)) region.maxima.insert(maximum);
  }
}

void TouchedMaxima::look_at(Index tet, const MeshCriticalPoint& point, Region& region) {
  if (const auto found = in_tets_.find(tet); found != in_tets_.end())
    add_maxima(found->second, point, region);
  const auto& corners = mesh_.tets[as_size(tet)];
  for (const Index v : corners) {
    if (point.dimension == 0 && v == point.vertices[0]) continue;
    const SymmetricTensor<double>& t = mesh_.tensors[as_size(v)];
    if (!region.seen_vertices.insert(v).second || deviator(t) == Deviator<double>{}) continue;
    const CriticalPoint vertex = critical_vertex(t, {});
    if (!may_be_above({vertex.high, vertex.gap_low}, point)) continue;
    if (const auto maximum = ascent_.from_vertex(v))
      region.maxima.insert(*maximum);
    else
      region.add(stars_.around(std::array{v}));
  }
  for (const Simplex& simplex : simplices_of(mesh_, tet)) {
    if (!region.seen.insert(simplex).second) continue;
    if (const auto found = on_carriers_.find(simplex); found != on_carriers_.end())
      region.maxima.insert(found->second.begin(), found->second.end());
    const auto& maxima = along_.along(simplex);
    if (std::any_of(maxima.begin(), maxima.end(), [&](const SimplexMaximum& maximum) {
          return may_be_above(maximum.bound, point);
        }))
      region.add(stars_.around(vertices_of(simplex)));
  }
}

std::optional<std::vector<std::size_t>> TouchedMaxima::at(const MeshCriticalPoint& point) {
  Region region;
  region.add(stars_.around(point.vertices));
  if (!look_around(region, point, SIZE_MAX)) return std::nullopt;
  return std::vector<std::size_t>(region.maxima.begin(), region.maxima.end());
}

std::optional<std::size_t> TouchedMaxima::only_one_from(Index tet, const MeshCriticalPoint& point) {
  Region region;
  region.add({tet});
  if (!look_around(region, point, 1) || region.maxima.empty()) return std::nullopt;
  return *region.maxima.begin();
}

/// False if there is too much to look at, or more maxima.
bool TouchedMaxima::look_around(Region& region, const MeshCriticalPoint& point,
                                std::size_t most_maxima) {
  for (std::size_t i = 0; i < region.tets.size(); ++i) {
    if (region.tets.size() > kMostTets) return false;
    look_at(region.tets[i], point, region);
    if (region.maxima.size() > most_maxima) return false;
  }
  return true;
}

}  // namespace tensortopo::persistence
