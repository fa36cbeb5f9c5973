// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/surface/cone_tips.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <utility>

#include "extract/run/extractor_scalars.hpp"
#include "extract/surface/cells/cone_edges.hpp"
#include "extract/surface/cone_points.hpp"
#include "tensortopo/mesh/union_find.hpp"

namespace tensortopo {

namespace {

using Index = TetMesh::Index;

/// For each triangle, in the order of the tetrahedra, that reaches an edge between two isotropic
/// vertices: a label that it shares with the triangle on the other side of the same stretch
/// of larger modes around that edge, if there is one. -1 for all others.
template <class Scalar>
std::vector<Index> sectors(const SurfaceInput<Scalar>& input, const VertexSides& sides,
                           const TetComplex& cells, const CellMeshes<Scalar>& meshes,
                           std::size_t triangles) {
  // Stretches of larger modes, as classes of triangles and of faces between tetrahedra.
  UnionFind stretches(triangles + cells.faces.size());
  const auto find = [&](std::size_t i) { return stretches.find(static_cast<std::uint32_t>(i)); };
  const auto unite = [&](std::size_t i, std::size_t j) {
    stretches.unite(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j));
  };
  std::vector<std::size_t> reaching;
  std::size_t first = 0;
  for (std::size_t t = 0; t < meshes.cells.size();
       first += meshes.cells[t].patch.triangles.size(), ++t) {
    const auto& v = input.vertices_of(cells, t);
    const unsigned zeros = input.zero_corners(v);
    if (std::popcount(zeros) != 2 || meshes.cells[t].unresolved) continue;
    const auto edge = edge_without(zeros);
    const auto crossings = meshes.boundary.crossings.rows[as_size(cells.tet_edges[t][edge])];
    auto ends = kTetEdges[edge];
    if (v[as_size(ends[0])] > v[as_size(ends[1])]) std::swap(ends[0], ends[1]);
    // The face that holds both isotropic vertices and one end is opposite the other end.
    const auto face_at = [&](int end) {
      return triangles + as_size(cells.tet_faces[t][as_size(ends[end == 0 ? 1 : 0])]);
    };
    std::size_t last = face_at(0);
    bool is_above = sides.above[as_size(v[as_size(ends[0])])] != 0;
    for (std::size_t k = 0; k < crossings.size(); ++k) {
      if (is_above) unite(last, first + k);
      is_above = crossings[k].rising;
      last = first + k;
      reaching.push_back(first + k);
    }
    if (is_above) unite(last, face_at(1));
  }
  std::vector<Index> label(triangles, -1), of_class(stretches.size(), -1);
  Index next = 0;
  for (const auto i : reaching) {
    auto& known = of_class[find(i)];
    if (known < 0) known = next++;
    label[i] = known;
  }
  return label;
}

}  // namespace

template <class Scalar>
std::size_t add_cone_tips(const SurfaceInput<Scalar>& input, const VertexSides& sides,
                          const TetComplex& cells, const CellMeshes<Scalar>& meshes,
                          SurfaceMesh& surface, std::vector<char>& is_apex) {
  if (std::find(is_apex.begin(), is_apex.end(), char{1}) == is_apex.end()) return 0;
  const auto old_count = surface.points.size();
  const auto made = separate_fans(surface, is_apex,
                                  sectors(input, sides, cells, meshes, surface.triangles.size()));
  const auto count = surface.points.size();
  surface.carrier.resize(count, Carrier::vertex);
  surface.carrier_id.resize(count);
  surface.carrier_vertices.resize(count);
  surface.medium_eigenvector.resize(count, {0, 0, 0});
  surface.dominant_eigenvector.resize(count, {0, 0, 0});
  for (std::size_t i = 0; i < made.size(); ++i) {
    const auto id = old_count + i;
    const auto [from, to] = made[i];
    surface.carrier_id[id] = surface.carrier_id[as_size(from)];
    surface.carrier_vertices[id] = surface.carrier_vertices[as_size(from)];
    is_apex[id] = 1;
    if (from == to) continue;
    const Index u = surface.carrier_id[as_size(from)], w = surface.carrier_id[as_size(to)];
    const std::array<Index, 2> ends{std::min(u, w), std::max(u, w)};
    const auto edge = std::lower_bound(cells.edges.begin(), cells.edges.end(), ends);
    surface.carrier[id] = Carrier::edge;
    surface.carrier_id[id] = static_cast<Index>(edge - cells.edges.begin());
    surface.carrier_vertices[id] = {ends[0], ends[1], -1, -1};
  }
  return static_cast<std::size_t>(
      std::count(surface.carrier.begin(), surface.carrier.end(), Carrier::vertex));
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                                           \
  template std::size_t add_cone_tips(const SurfaceInput<Scalar>&, const VertexSides&,            \
                                     const TetComplex&, const CellMeshes<Scalar>&, SurfaceMesh&, \
                                     std::vector<char>&);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
