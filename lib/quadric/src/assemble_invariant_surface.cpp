// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "assemble_invariant_surface.hpp"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "tensortopo/mesh/complete_normals.hpp"
#include "tensortopo/mesh/surface_invariants.hpp"

namespace tensortopo {
namespace {

using Index = SurfaceMesh::Index;

/// A vertex in a cell, to be sorted by its key.
struct Use {
  const CellVertex* vertex;
  std::size_t cell;
  std::size_t slot;  ///< of the vertex among those of all cells
  std::size_t corners;

  bool operator<(const Use& other) const {
    return std::tie(corners, vertex->key, cell) <
           std::tie(other.corners, other.vertex->key, other.cell);
  }
};

std::size_t corners_of(const VertexKey& key) {
  return static_cast<std::size_t>(
      std::count_if(key.ids.begin(), key.ids.end(), [](Index id) { return id >= 0; }));
}

}  // namespace

SurfaceMesh assemble_invariant_surface(std::span<const CellLevel> cells,
                                       std::span<const TetMesh::Index> tets, double value) {
  std::vector<Use> uses;
  std::vector<std::size_t> first;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    first.push_back(uses.size());
    for (const auto& v : cells[c].vertices) uses.push_back({&v, c, uses.size(), corners_of(v.key)});
  }
  tbb::parallel_sort(uses.begin(), uses.end());
  SurfaceMesh surface;
  std::vector<Index> number(uses.size());
  Index carriers = -1;
  for (std::size_t i = 0; i < uses.size(); ++i) {
    const VertexKey& key = uses[i].vertex->key;
    const bool is_new = i == 0 || key != uses[i - 1].vertex->key;
    if (is_new) {
      if (surface.points.size() >= as_size(std::numeric_limits<Index>::max()))
        throw std::length_error("extract_invariant_surface: more vertices than 32 bits can number");
      const bool is_new_kind = i == 0 || uses[i].corners != uses[i - 1].corners;
      if (is_new_kind)
        carriers = 0;
      else if (key.ids != uses[i - 1].vertex->key.ids)
        ++carriers;
      const std::size_t corners = uses[i].corners;
      surface.points.push_back(uses[i].vertex->position);
      surface.carrier.push_back(corners == 2   ? Carrier::edge
                                : corners == 3 ? Carrier::face
                                               : Carrier::tet);
      surface.carrier_id.push_back(corners == 4 ? tets[uses[i].cell] : carriers);
      surface.carrier_vertices.push_back(key.ids);
      surface.residual.push_back(uses[i].vertex->value - value);
    }
    number[uses[i].slot] = static_cast<Index>(surface.points.size() - 1);
  }
  surface.value.assign(surface.points.size(), value);
  for (std::size_t c = 0; c < cells.size(); ++c)
    for (const auto& triangle : cells[c].triangles) {
      std::array<Index, 3> ids;
      for (std::size_t k = 0; k < 3; ++k) ids[k] = number[first[c] + triangle[k]];
      surface.triangles.push_back(ids);
      surface.tet.push_back(tets[c]);
    }
  surface.component = surface_components(surface);
  return surface;
}

void add_normals(std::span<const CellLevel> cells, SurfaceMesh& surface) {
  surface.normal.assign(surface.points.size(), {});
  constexpr auto kNone = static_cast<std::size_t>(-1);
  std::vector<std::size_t> last_cell(surface.points.size(), kNone);
  std::size_t t = 0;
  for (std::size_t c = 0; c < cells.size(); ++c)
    for (const auto& triangle : cells[c].triangles) {
      const auto& corners = surface.triangles[t++];
      for (std::size_t k = 0; k < 3; ++k) {
        const auto v = as_size(corners[k]);
        if (std::exchange(last_cell[v], c) != c)
          surface.normal[v] += cells[c].vertices[triangle[k]].normal;
      }
    }
  for (auto& normal : surface.normal) normal = unit_or_zero(normal);
  complete_normals(surface);
}

}  // namespace tensortopo
