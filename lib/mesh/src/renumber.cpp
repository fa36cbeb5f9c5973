// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/mesh/renumber.hpp"

#include <algorithm>
#include <array>

namespace tensortopo {

namespace {

using Index = TetMesh::Index;

void renumber_carrier(std::array<Index, 4>& carrier, std::span<const Index> vertices) {
  const auto end = std::find(carrier.begin(), carrier.end(), -1);
  for (auto i = carrier.begin(); i != end; ++i) *i = vertices[as_size(*i)];
  std::sort(carrier.begin(), end);
}

}  // namespace

void renumber(SurfaceMesh& surface, std::span<const Index> vertices, std::span<const Index> tets) {
  for (auto& carrier : surface.carrier_vertices) renumber_carrier(carrier, vertices);
  for (std::size_t v = 0; v < surface.carrier_id.size(); ++v) {
    Index& id = surface.carrier_id[v];
    if (surface.carrier[v] == Carrier::vertex) id = vertices[as_size(id)];
    if (surface.carrier[v] == Carrier::tet) id = tets[as_size(id)];
  }
  for (Index& t : surface.tet) t = tets[as_size(t)];
}

void renumber(CurveMesh& curves, std::span<const Index> vertices, std::span<const Index> tets) {
  for (auto& carrier : curves.carrier_vertices) renumber_carrier(carrier, vertices);
  for (Index& t : curves.tet) t = tets[as_size(t)];
}

}  // namespace tensortopo
