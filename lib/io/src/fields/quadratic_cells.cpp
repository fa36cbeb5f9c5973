// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "fields/quadratic_cells.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bytes/format_error.hpp"
#include "grids/cell_kind.hpp"
#include "tensortopo/scalar/elementary.hpp"

namespace tensortopo::detail {
namespace {

using Index = TetMesh::Index;
using Tets = std::vector<std::array<Index, 4>>;
using Edges = std::vector<std::array<std::size_t, 2>>;

constexpr std::uint8_t tetrahedron = 10, hexahedron = 12, wedge = 13, pyramid = 14;
constexpr std::uint8_t tetrahedron_10 = 24, hexahedron_20 = 25, wedge_15 = 26, pyramid_13 = 27,
                       hexahedron_27 = 29;

/// The corners that the nodes after the corners lie between, in VTK's order.
const Edges& edges_of(std::uint8_t vtk_type) {
  static const Edges of_tetrahedron{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
  static const Edges of_hexahedron{{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6},
                                   {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};
  static const Edges of_wedge{{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5},
                              {5, 3}, {0, 3}, {1, 4}, {2, 5}};
  static const Edges of_pyramid{{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {1, 4}, {2, 4}, {3, 4}};
  switch (vtk_type) {
    case tetrahedron_10:
      return of_tetrahedron;
    case wedge_15:
      return of_wedge;
    case pyramid_13:
      return of_pyramid;
    default:
      return of_hexahedron;
  }
}

void add_linear(std::uint8_t vtk_type, std::initializer_list<Index> corners, Tets& tets) {
  split_cell(vtk_type, std::span(corners.begin(), corners.size()), tets);
}

}  // namespace

QuadraticKind quadratic_kind(std::uint8_t vtk_type) {
  switch (vtk_type) {
    case tetrahedron_10:
      return {4, 10, tetrahedron};
    case hexahedron_20:
      return {8, 20, hexahedron};
    case wedge_15:
      return {6, 15, wedge};
    case pyramid_13:
      return {5, 13, pyramid};
    case hexahedron_27:
      return {8, 27, hexahedron};
    default:
      return {};
  }
}

void QuadraticSplitter::count_curved(std::uint8_t vtk_type, std::span<const Index> nodes) {
  const QuadraticKind kind = quadratic_kind(vtk_type);
  const Edges& edges = edges_of(vtk_type);
  for (std::size_t e = 0; e < edges.size(); ++e)
    count_curved(nodes[edges[e][0]], nodes[edges[e][1]], nodes[kind.corners + e]);
}

void QuadraticSplitter::split(std::uint8_t vtk_type, std::span<const Index> nodes, Tets& tets) {
  if (vtk_type == tetrahedron_10) split_tetrahedron(nodes, tets);
  if (vtk_type == hexahedron_20 || vtk_type == hexahedron_27) split_hexahedron(nodes, tets);
  if (vtk_type == wedge_15) split_wedge(nodes, tets);
  if (vtk_type == pyramid_13) split_pyramid(nodes, tets);
}

void QuadraticSplitter::count_curved(Index a, Index b, Index middle) {
  if (!middles_.try_emplace({std::min(a, b), std::max(a, b)}, middle).second) return;
  const auto at = [&](Index v) { return mesh_.points[static_cast<std::size_t>(v)]; };
  const Vector3<double> p = at(a), q = at(b), m = at(middle);
  const auto length = [](double x, double y, double z) { return elementary::hypot(x, y, z); };
  const double off =
      length(m.x - (p.x / 2 + q.x / 2), m.y - (p.y / 2 + q.y / 2), m.z - (p.z / 2 + q.z / 2));
  if (!(off <= 0.01 * length(q.x - p.x, q.y - p.y, q.z - p.z))) ++curved_;
}

/// A new vertex: the weighted sum of others, in the order of their numbers whatever the cell's.
Index QuadraticSplitter::vertex_at(const std::vector<std::pair<Index, double>>& weights) {
  auto sorted = weights;
  std::sort(sorted.begin(), sorted.end());
  Vector3<double> point{};
  SymmetricTensor<double> tensor{};
  for (const auto& [v, w] : sorted) {
    const auto i = static_cast<std::size_t>(v);
    point = point + w * mesh_.points[i];
    tensor = tensor + w * mesh_.tensors[i];
  }
  const auto& t = tensor;
  for (const double x : {point.x, point.y, point.z, t.xx, t.yy, t.zz, t.xy, t.yz, t.xz})
    if (!std::isfinite(x)) throw FormatError("the values around a face are too large to average");
  if (mesh_.points.size() >= INT32_MAX) throw FormatError("has too many points");
  mesh_.points.push_back(point);
  mesh_.tensors.push_back(tensor);
  ++added_;
  return static_cast<Index>(mesh_.points.size() - 1);
}

Index QuadraticSplitter::face_centre(std::array<Index, 4> corners, std::array<Index, 4> middles) {
  std::sort(corners.begin(), corners.end());
  std::sort(middles.begin(), middles.end());
  std::array<Index, 8> key{};
  std::copy(corners.begin(), corners.end(), key.begin());
  std::copy(middles.begin(), middles.end(), key.begin() + 4);
  if (const auto known = face_centres_.find(key); known != face_centres_.end())
    return known->second;
  std::vector<std::pair<Index, double>> weights;
  for (const Index v : corners) weights.emplace_back(v, -0.25);
  for (const Index v : middles) weights.emplace_back(v, 0.5);
  return face_centres_.emplace(key, vertex_at(weights)).first->second;
}

void QuadraticSplitter::split_tetrahedron(std::span<const Index> n, Tets& tets) {
  // Corner parts, then the octahedron around the middles of the edges.
  for (const auto& [corner, a, b, c] :
       {std::array<std::size_t, 4>{0, 4, 6, 7}, {1, 4, 5, 8}, {2, 5, 6, 9}, {3, 7, 8, 9}})
    tets.push_back({n[corner], n[a], n[b], n[c]});
  struct Diagonal {
    std::array<std::size_t, 2> ends;
    std::array<std::size_t, 4> around;
  };
  constexpr std::array<Diagonal, 3> diagonals{
      {{{4, 9}, {5, 6, 7, 8}}, {{5, 7}, {4, 6, 9, 8}}, {{6, 8}, {4, 5, 9, 7}}}};
  const auto smallest = [&](const Diagonal& d) { return std::min(n[d.ends[0]], n[d.ends[1]]); };
  const Diagonal& best =
      *std::min_element(diagonals.begin(), diagonals.end(),
                        [&](const auto& p, const auto& q) { return smallest(p) < smallest(q); });
  for (std::size_t i = 0; i < 4; ++i)
    tets.push_back(
        {n[best.ends[0]], n[best.ends[1]], n[best.around[i]], n[best.around[(i + 1) % 4]]});
}

void QuadraticSplitter::split_hexahedron(std::span<const Index> n, Tets& tets) {
  // The nodes on a lattice of 3 x 3 x 3.
  std::array<Index, 27> at{};
  const auto place = [](std::size_t i, std::size_t j, std::size_t k) { return i + 3 * j + 9 * k; };
  constexpr std::array<std::array<std::size_t, 3>, 8> corner{
      {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {2, 2, 2}, {0, 2, 2}}};
  for (std::size_t c = 0; c < 8; ++c) at[place(corner[c][0], corner[c][1], corner[c][2])] = n[c];
  const Edges& edges = edges_of(hexahedron_20);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto &p = corner[edges[e][0]], &q = corner[edges[e][1]];
    at[place((p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2)] = n[8 + e];
  }
  // Faces as VTK numbers their nodes: low and high along each axis.
  for (std::size_t f = 0; f < 6; ++f) {
    const std::size_t axis = f / 2, side = 2 * (f % 2);
    const auto on_face = [&](std::size_t u, std::size_t v) {
      std::array<std::size_t, 3> x{};
      x[axis] = side, x[(axis + 1) % 3] = u, x[(axis + 2) % 3] = v;
      return place(x[0], x[1], x[2]);
    };
    const auto node = [&](std::size_t u, std::size_t v) { return at[on_face(u, v)]; };
    at[on_face(1, 1)] = n.size() == 27
                            ? n[20 + f]
                            : face_centre({node(0, 0), node(2, 0), node(2, 2), node(0, 2)},
                                          {node(1, 0), node(2, 1), node(1, 2), node(0, 1)});
  }
  if (n.size() == 27) {
    at[place(1, 1, 1)] = n[26];
  } else {
    std::vector<std::pair<Index, double>> weights;
    for (std::size_t i = 0; i < 20; ++i) weights.emplace_back(n[i], i < 8 ? -0.25 : 0.25);
    at[place(1, 1, 1)] = vertex_at(weights);
  }
  for (std::size_t k = 0; k < 2; ++k)
    for (std::size_t j = 0; j < 2; ++j)
      for (std::size_t i = 0; i < 2; ++i) {
        const auto v = [&](std::size_t a, std::size_t b, std::size_t c) {
          return at[place(i + a, j + b, k + c)];
        };
        add_linear(hexahedron,
                   {v(0, 0, 0), v(1, 0, 0), v(1, 1, 0), v(0, 1, 0), v(0, 0, 1), v(1, 0, 1),
                    v(1, 1, 1), v(0, 1, 1)},
                   tets);
      }
}

void QuadraticSplitter::split_wedge(std::span<const Index> n, Tets& tets) {
  // Three layers of a triangle's corners and middles.
  std::array<std::array<Index, 6>, 3> layer{};
  for (std::size_t i = 0; i < 3; ++i) {
    layer[0][i] = n[i], layer[0][3 + i] = n[6 + i];
    layer[2][i] = n[3 + i], layer[2][3 + i] = n[9 + i];
    layer[1][i] = n[12 + i];
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    layer[1][3 + i] =
        face_centre({n[i], n[j], n[3 + j], n[3 + i]}, {n[6 + i], n[12 + j], n[9 + i], n[12 + i]});
  }
  for (std::size_t k = 0; k < 2; ++k) {
    const auto &low = layer[k], &high = layer[k + 1];
    for (const auto& [a, b, c] :
         {std::array<std::size_t, 3>{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}})
      add_linear(wedge, {low[a], low[b], low[c], high[a], high[b], high[c]}, tets);
  }
}

void QuadraticSplitter::split_pyramid(std::span<const Index> n, Tets& tets) {
  const Index centre = face_centre({n[0], n[1], n[2], n[3]}, {n[5], n[6], n[7], n[8]});
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t before = (i + 3) % 4, after = (i + 1) % 4;
    add_linear(pyramid, {n[i], n[5 + i], centre, n[5 + before], n[9 + i]}, tets);
    tets.push_back({n[5 + i], n[9 + i], n[9 + after], centre});
  }
  add_linear(pyramid, {n[9], n[10], n[11], n[12], n[4]}, tets);
  add_linear(pyramid, {n[9], n[12], n[11], n[10], centre}, tets);
}

}  // namespace tensortopo::detail
