// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <vector>

#include "tensortopo/mesh/surface_mesh.hpp"

namespace tensortopo::test {

/// The vertices of a simplex of the mesh; -1 fills up.
using Simplex = std::array<TetMesh::Index, 4>;

/// How many vertices lie in each simplex of one kind, different places only.
template <class Output>
std::map<Simplex, std::size_t> crossings_of(const Output& output, Carrier kind) {
  std::map<Simplex, std::vector<std::array<double, 3>>> places;
  for (std::size_t v = 0; v < output.points.size(); ++v)
    if (output.carrier[v] == kind)
      places[output.carrier_vertices[v]].push_back(
          {output.points[v].x, output.points[v].y, output.points[v].z});
  std::map<Simplex, std::size_t> counts;
  for (auto& [simplex, found] : places) {
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    counts[simplex] = found.size();
  }
  return counts;
}

}  // namespace tensortopo::test
