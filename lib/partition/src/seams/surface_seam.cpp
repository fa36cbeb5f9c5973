// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/partition/surface_seam.hpp"

#include <algorithm>
#include <utility>

#include "tensortopo/extract/meshing_message.hpp"
#include "tensortopo/mesh/surface_invariants.hpp"
#include "tensortopo/mesh/union_find.hpp"

namespace tensortopo {

namespace {

using Index = TetMesh::Index;

/// Of all numbers of a vertex that pieces agree on.
std::uint64_t digest_of_vertex(const SurfaceMesh& surface, std::size_t v) {
  const auto &p = surface.points[v], &n = surface.normal[v], &m = surface.medium_eigenvector[v],
             &d = surface.dominant_eigenvector[v];
  return digest_of(std::array{p.x, p.y, p.z, n.x, n.y, n.z, m.x, m.y, m.z, d.x, d.y, d.z,
                              surface.residual[v], surface.mode[v],
                              static_cast<double>(surface.carrier[v])});
}

/// Whether both carriers are within one edge of the mesh.
bool is_on_edge(const std::array<Index, 4>& a, const std::array<Index, 4>& b) {
  const auto larger = a[1] >= 0 ? a : b;
  if (larger[1] < 0) return a[0] == b[0];
  const auto is_within = [&](Index v) { return v < 0 || v == larger[0] || v == larger[1]; };
  return larger[2] < 0 && std::all_of(a.begin(), a.end(), is_within) &&
         std::all_of(b.begin(), b.end(), is_within);
}

class SeamFinder {
 public:
  explicit SeamFinder(const PieceSurface& piece)
      : piece_(piece), surface_(piece.surface), seam_vertex_(surface_.points.size(), -1) {}

  SurfaceSeam run() {
    count_components();
    find_sides();
    find_borders();
    seam_.owned_ids = piece_.owned_ids;
    seam_.whole_tets = piece_.whole_tets;
    seam_.told = piece_.told, seam_.heard = piece_.heard;
    for (const UnresolvedOwnedCell& cell : piece_.unresolved)
      seam_.unresolved.push_back(cell.cell_id);
    return std::move(seam_);
  }

 private:
  void count_components() {
    const SurfaceInvariants known = surface_invariants(surface_);
    component_ = known.component;
    component_of_vertex_.assign(surface_.points.size(), -1);
    for (const auto& part : known.parts) {
      auto& component = seam_.components.emplace_back();
      component.triangles = static_cast<std::int64_t>(part.triangles);
      component.euler_characteristic = part.euler_characteristic;
    }
    std::vector<Index> tets;  // with first triangles, in the piece's `cells`
    for (std::size_t i = 0; i < component_.size(); ++i) {
      auto& component = seam_.components[as_size(component_[i])];
      if (component.first_tet < 0) {
        if (tets.empty() || tets.back() != surface_.tet[i]) tets.push_back(surface_.tet[i]);
        component.first_tet = static_cast<Index>(tets.size() - 1);
      }
      for (const Index v : surface_.triangles[i])
        if (std::exchange(component_of_vertex_[as_size(v)], component_[i]) < 0)
          ++component.vertices;
    }
    add_cells(tets);
  }

  void add_cells(const std::vector<Index>& tets) {
    std::vector<Index> number(piece_.vertex_ids.size(), -1);
    for (const Index t : tets)
      for (const Index v : piece_.cells.tets[as_size(t)]) number[as_size(v)] = 0;
    for (std::size_t v = 0; v < number.size(); ++v) {
      if (number[v] < 0) continue;
      number[v] = static_cast<Index>(seam_.vertex_ids.size());
      seam_.vertex_ids.push_back(piece_.vertex_ids[v]);
      seam_.cells.points.push_back(piece_.cells.points[v]);
      seam_.cells.tensors.push_back(piece_.cells.tensors[v]);
    }
    for (const Index t : tets) {
      auto corners = piece_.cells.tets[as_size(t)];
      for (Index& v : corners) v = number[as_size(v)];
      seam_.cells.tets.push_back(corners);
      seam_.cells.cell_ids.push_back(piece_.cells.cell_ids[as_size(t)]);
    }
  }

  Index add_vertex(Index v) {
    Index& number = seam_vertex_[as_size(v)];
    if (number >= 0) return number;
    number = static_cast<Index>(seam_.vertices.size());
    auto& vertex = seam_.vertices.emplace_back();
    const auto& carrier = surface_.carrier_vertices[as_size(v)];
    const auto end = std::find(carrier.begin(), carrier.end(), -1);
    const auto last = std::transform(carrier.begin(), end, vertex.carrier_ids.begin(),
                                     [&](Index c) { return piece_.vertex_ids[as_size(c)]; });
    std::sort(vertex.carrier_ids.begin(), last);
    vertex.ordinal = piece_.ordinals[as_size(v)];
    vertex.component = component_of_vertex_[as_size(v)];
    vertex.digest = digest_of_vertex(surface_, as_size(v));
    return number;
  }

  void find_sides() {
    const auto& carriers = surface_.carrier_vertices;
    for (std::size_t i = 0; i < surface_.triangles.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        const Index from = surface_.triangles[i][k], to = surface_.triangles[i][(k + 1) % 3];
        const std::int64_t ghost = piece_.ghost_across[i][k];
        if (ghost < 0 && !is_on_edge(carriers[as_size(from)], carriers[as_size(to)])) {
          others_.push_back({std::min(from, to), std::max(from, to)});
          continue;
        }
        const Index first = add_vertex(from), second = add_vertex(to);
        seam_.sides.push_back(
            {first, second, piece_.cells.cell_ids[as_size(surface_.tet[i])], ghost});
      }
  }

  /// Of sides that no other piece has.
  void find_borders() {
    std::sort(others_.begin(), others_.end());
    UnionFind borders(surface_.points.size());
    std::vector<Index> ends;
    for (std::size_t i = 0; i < others_.size();) {
      std::size_t next = i + 1;
      while (next < others_.size() && others_[next] == others_[i]) ++next;
      if (next == i + 1) {
        const auto& [u, v] = others_[i];
        borders.unite(static_cast<std::uint32_t>(u), static_cast<std::uint32_t>(v));
        ends.push_back(u), ends.push_back(v);
      }
      i = next;
    }
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    std::vector<Index> number(surface_.points.size(), -1);  // of classes that meet the seam
    Index count = 0;
    const auto border_of = [&](Index v) -> Index& {
      return number[borders.find(static_cast<std::uint32_t>(v))];
    };
    for (const Index v : ends) {
      const Index vertex = seam_vertex_[as_size(v)];
      if (vertex < 0) continue;
      Index& border = border_of(v);
      if (border < 0) border = count++;
      seam_.vertices[as_size(vertex)].border = border;
    }
    for (const Index v : ends)
      if (std::exchange(border_of(v), 0) < 0)
        ++seam_.components[as_size(component_of_vertex_[as_size(v)])].closed_borders;
  }

  const PieceSurface& piece_;
  const SurfaceMesh& surface_;
  std::vector<Index> component_, component_of_vertex_;
  std::vector<Index> seam_vertex_;            ///< of each vertex, or -1
  std::vector<std::array<Index, 2>> others_;  ///< sides off the seam, by their vertices ascending
  SurfaceSeam seam_;
};

}  // namespace

SurfaceSeam seam_of(const PieceSurface& piece) { return SeamFinder(piece).run(); }

}  // namespace tensortopo
