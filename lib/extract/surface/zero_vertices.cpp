// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <bit>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>

#include "extract/level/critical/zero_inside.hpp"
#include "extract/run/extractor_scalars.hpp"
#include "extract/surface/cone_points.hpp"
#include "extract/surface/pipeline.hpp"
#include "tensortopo/mesh/union_find.hpp"

namespace tensortopo {

namespace {

/// The edge between the two corners that are not among these.
std::size_t edge_without(unsigned corners) {
  for (std::size_t e = 0; e < kTetEdges.size(); ++e)
    if (((1u << kTetEdges[e][0] | 1u << kTetEdges[e][1]) & corners) == 0) return e;
  return 0;
}

std::size_t edge_between(unsigned corners) { return edge_without(15u & ~corners); }

/// Whether an order of the corners of a tetrahedron is an even permutation.
bool is_even(const std::array<int, 4>& order) {
  bool even = true;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) even ^= order[i] > order[j];
  return even;
}

}  // namespace

/// Whether the level may meet a tetrahedron that has vertices isotropic: what decides is the
/// opposite face or edge. With one other vertex the mode is constant.
template <class Scalar>
bool Pipeline<Scalar>::may_be_crossed_from_zero(const std::array<Index, 4>& tet) const {
  const unsigned zeros = zero_corners(tet);
  if (std::popcount(zeros) > 2) return false;
  // Also where the edge is free of crossings: they tell which stretches belong together.
  if (std::popcount(zeros) == 2) return true;
  std::array<Deviator<Scalar>, 3> corners;
  bool some_above = false, some_below = false;
  for (std::size_t i = 0, k = 0; i < 4; ++i) {
    if (zeros >> i & 1) continue;
    corners[k++] = field_.tensors[as_size(tet[i])];
    (above_[as_size(tet[i])] ? some_above : some_below) = true;
  }
  if (some_above && some_below) return true;
  return !screen::excludes(rounded(corners), level_.lode_angle) &&
         !is_proved_empty(corners, level_);
}

/// Whether the deviator vanishes in a face, whose vertices have one.
template <class Scalar>
bool Pipeline<Scalar>::vanishes_inside(const std::array<Index, 3>& face) const {
  std::array<Deviator<Scalar>, 3> scaled;
  for (std::size_t i = 0; i < 3; ++i) scaled[i] = field_.tensors[as_size(face[i])];
  if (!may_have_zero_inside(rounded(scaled))) return false;
  return has_zero_inside(tensors_of(face));
}

/// A tetrahedron with one or two vertices isotropic: one sheet for each curve of the
/// opposite face, or for each crossing of the opposite edge.
template <class Scalar>
bool Pipeline<Scalar>::prove_cone(std::size_t t) {
  auto& state = tets_[t];
  const unsigned zeros = zero_corners(vertices_of(t));
  std::size_t sheets = 0;
  if (std::popcount(zeros) == 1) {
    const auto& arcs = arcs_[as_size(complex_.tet_faces[t][as_size(std::countr_zero(zeros))])];
    if (!arcs) {
      state.unresolved = unproved(t);
      return false;
    }
    sheets = arcs->size();
  } else {
    const auto& crossings = crossings_[as_size(complex_.tet_edges[t][edge_without(zeros)])];
    if (!crossings) {
      state.unresolved = unproved(t);
      return false;
    }
    sheets = crossings->size();
  }
  if (sheets == 0) return false;
  state.method = Method::cone;
  state.proved = std::make_unique<CellTopology<Scalar>>();
  state.proved->sheets.assign(sheets, {{}, 1, -1});
  return true;
}

/// Gives each vertex isotropic a number, after those of the edges.
template <class Scalar>
void Pipeline<Scalar>::number_zero_vertices() {
  zero_vertex_.assign(mesh_.points.size(), -1);
  for (std::size_t t = 0; t < tets_.size(); ++t) {
    if (tets_[t].method != Method::cone) continue;
    const auto& v = vertices_of(t);
    for (std::size_t i = 0; i < 4; ++i) {
      auto& id = zero_vertex_[as_size(v[i])];
      if (!field_.is_zero[as_size(v[i])] || id >= 0) continue;
      id = static_cast<Index>(boundary_position_.size());
      boundary_position_.push_back(mesh_.points[as_size(v[i])]);
      boundary_medium_.push_back({0, 0, 0});
      boundary_dominant_.push_back({0, 0, 0});
    }
  }
}

template <class Scalar>
void Pipeline<Scalar>::mesh_cone(std::size_t t) {
  const auto& v = vertices_of(t);
  const unsigned zeros = zero_corners(v);
  auto& triangles = tets_[t].patch.triangles;
  if (std::popcount(zeros) == 2) {
    const auto edge = edge_without(zeros);
    const auto ends = kTetEdges[edge], apex = kTetEdges[edge_between(zeros)];
    const auto& vertices = complex_.edges[as_size(complex_.tet_edges[t][edge])];
    const auto e = as_size(complex_.tet_edges[t][edge]);
    const std::array<Index, 2> tips{zero_vertex_[as_size(v[as_size(apex[0])])],
                                    zero_vertex_[as_size(v[as_size(apex[1])])]};
    // Counter-clockwise seen from the second end if this order of the corners is even.
    const bool even =
        is_even({ends[0], ends[1], apex[0], apex[1]}) == (v[as_size(ends[0])] == vertices[0]);
    for (std::size_t k = 0; k < crossings_[e]->size(); ++k) {
      const Index foot = edge_vertex_[e] + static_cast<Index>(k);
      if ((*crossings_[e])[k].rising == even)
        triangles.push_back({foot, tips[0], tips[1]});
      else
        triangles.push_back({foot, tips[1], tips[0]});
    }
    return;
  }
  const auto f = as_size(std::countr_zero(zeros));
  const Index apex = zero_vertex_[as_size(v[f])];
  const auto tet = tet_with_curves(t);
  const auto vertices = arc_vertices(t, tet);
  for (std::size_t a = 0; a < tet.arcs[f].size(); ++a) {
    const BoundaryArc piece{static_cast<int>(f), static_cast<int>(a), tet.outward[f]};
    const auto boundary = loop_vertices({&piece, 1}, vertices);
    const std::size_t n = boundary.size(), sides = tet.arcs[f][a].closed ? n : n - 1;
    for (std::size_t i = 0; i < sides; ++i)
      triangles.push_back({boundary[i].id, boundary[i + 1 < n ? i + 1 : 0].id, apex});
  }
}

/// For each triangle, in the order of the tetrahedra, that reaches an edge between two vertices
/// isotropic: a label that it shares with the triangle on the other side of the same stretch
/// of larger modes around that edge, if there is one. -1 for all others.
template <class Scalar>
std::vector<TetMesh::Index> Pipeline<Scalar>::sectors(std::size_t triangles) const {
  // Stretches of larger modes, as classes of triangles and of faces between tetrahedra.
  UnionFind stretches(triangles + complex_.faces.size());
  const auto find = [&](std::size_t i) { return stretches.find(static_cast<std::uint32_t>(i)); };
  const auto unite = [&](std::size_t i, std::size_t j) {
    stretches.unite(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j));
  };
  std::vector<std::size_t> reaching;
  std::size_t first = 0;
  for (std::size_t t = 0; t < tets_.size(); first += tets_[t].patch.triangles.size(), ++t) {
    const auto& v = vertices_of(t);
    const unsigned zeros = zero_corners(v);
    if (std::popcount(zeros) != 2 || tets_[t].unresolved) continue;
    const auto edge = edge_without(zeros);
    const auto& crossings = *crossings_[as_size(complex_.tet_edges[t][edge])];
    auto ends = kTetEdges[edge];
    if (v[as_size(ends[0])] > v[as_size(ends[1])]) std::swap(ends[0], ends[1]);
    // The face that holds both vertices isotropic and one end is opposite the other end.
    const auto face_at = [&](int end) {
      return triangles + as_size(complex_.tet_faces[t][as_size(ends[end == 0 ? 1 : 0])]);
    };
    std::size_t last = face_at(0);
    bool is_above = above_[as_size(v[as_size(ends[0])])] != 0;
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

/// The vertices of the surface where the mode is undefined: one for each fan at a vertex of the
/// mesh isotropic, and those halfway between two. Marks them all in `is_apex`.
template <class Scalar>
void Pipeline<Scalar>::add_cone_points(SurfaceMesh& surface, std::vector<char>& is_apex) {
  if (std::find(is_apex.begin(), is_apex.end(), char{1}) == is_apex.end()) return;
  const auto old_count = surface.points.size();
  const auto made = separate_fans(surface, is_apex, sectors(surface.triangles.size()));
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
    const auto edge = std::lower_bound(complex_.edges.begin(), complex_.edges.end(), ends);
    surface.carrier[id] = Carrier::edge;
    surface.carrier_id[id] = static_cast<Index>(edge - complex_.edges.begin());
    surface.carrier_vertices[id] = {ends[0], ends[1], -1, -1};
  }
  statistics_.cone_points = static_cast<std::size_t>(
      std::count(surface.carrier.begin(), surface.carrier.end(), Carrier::vertex));
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                                         \
  template bool Pipeline<Scalar>::may_be_crossed_from_zero(const std::array<Index, 4>&) const; \
  template bool Pipeline<Scalar>::vanishes_inside(const std::array<Index, 3>&) const;          \
  template bool Pipeline<Scalar>::prove_cone(std::size_t);                                     \
  template void Pipeline<Scalar>::number_zero_vertices();                                      \
  template void Pipeline<Scalar>::mesh_cone(std::size_t);                                      \
  template std::vector<TetMesh::Index> Pipeline<Scalar>::sectors(std::size_t) const;           \
  template void Pipeline<Scalar>::add_cone_points(SurfaceMesh&, std::vector<char>&);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
