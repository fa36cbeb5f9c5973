// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>
#include <numeric>

#include "conformance/score_parts.hpp"
#include "conformance/triangle_search.hpp"
#include "tensortopo/mesh/tet_complex.hpp"
#include "tensortopo/mesh/union_find.hpp"
#include "tensortopo/tensor/deviator.hpp"

namespace tensortopo {

namespace {

using Index = SurfaceMesh::Index;
using Edge = std::array<Index, 2>;

// The faces in which a surface may end: those with one tetrahedron, or with one about which there
// is truth, and those without deviator.
SurfaceMesh ends_of_domain(const TetMesh& mesh, const std::vector<UndecidedCell>& undecided) {
  std::vector<Index> all(mesh.tets.size());
  std::iota(all.begin(), all.end(), 0);
  std::vector<char> known(all.size(), 1);
  for (const auto& cell : undecided) known[as_size(cell.tet)] = 0;
  const auto is_zero = [&](Index v) {
    return deviator(mesh.tensors[as_size(v)]) == Deviator<double>{};
  };
  const TetComplex complex = tet_complex(mesh, all);
  SurfaceMesh ends;
  ends.points = mesh.points;
  for (std::size_t f = 0; f < complex.faces.size(); ++f) {
    const auto [one, other] = complex.face_tets[f];
    const auto& face = complex.faces[f];
    if (other < 0 || known[as_size(one)] != known[as_size(other)] ||
        std::all_of(face.begin(), face.end(), is_zero))
      ends.triangles.push_back(face);
  }
  return ends;
}

// Number of connected pieces of a graph, by union of its vertices.
std::size_t pieces(const std::vector<Edge>& edges) {
  std::map<Index, std::uint32_t> number;
  UnionFind vertices;
  const auto number_of = [&](Index v) {
    const auto [found, added] = number.try_emplace(v, 0);
    if (added) found->second = vertices.add();
    return found->second;
  };
  for (const auto& [a, b] : edges) vertices.unite(number_of(a), number_of(b));
  return vertices.count();
}

// Pairs of edges that coincide within `eps` without sharing a vertex; of edges long enough to tell.
std::size_t near_pairs(const SurfaceMesh& surface, std::vector<Edge> edges, double eps) {
  const auto at = [&](Index v) { return surface.points[as_size(v)]; };
  const auto middle = [&](const Edge& e) { return 0.5 * (at(e[0]) + at(e[1])); };
  const auto near = [&](const Vector3<double>& p, const Vector3<double>& q) {
    return dot(p - q, p - q) <= eps * eps;
  };
  std::erase_if(edges, [&](const Edge& e) {
    const auto d = at(e[1]) - at(e[0]);
    return dot(d, d) <= 16 * eps * eps;
  });
  std::sort(edges.begin(), edges.end(), [&](const Edge& e, const Edge& f) {
    const double x = middle(e).x, y = middle(f).x;
    return x != y ? x < y : e < f;
  });
  std::size_t pairs = 0;
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (std::size_t j = i + 1; j < edges.size(); ++j) {
      if (middle(edges[j]).x - middle(edges[i]).x > eps) break;
      const auto &e = edges[i], &f = edges[j];
      if (e[0] == f[0] || e[0] == f[1] || e[1] == f[0] || e[1] == f[1]) continue;
      pairs += (near(at(e[0]), at(f[0])) && near(at(e[1]), at(f[1]))) ||
               (near(at(e[0]), at(f[1])) && near(at(e[1]), at(f[0])));
    }
  return pairs;
}

// Vertices around which the triangles form several fans.
std::size_t pinched_vertices(const SurfaceMesh& surface) {
  std::vector<std::vector<Edge>> links(surface.points.size());
  for (const auto& t : surface.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      links[as_size(t[i])].push_back({t[(i + 1) % 3], t[(i + 2) % 3]});
  return static_cast<std::size_t>(
      std::count_if(links.begin(), links.end(), [](const auto& link) { return pieces(link) > 1; }));
}

}  // namespace

double touch_distance(const TetMesh& mesh, const GivenSurface& given, double length, double touch) {
  double largest = 0;
  for (const auto& p : mesh.points)
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return std::max(touch * length, (given.is_single_precision ? 0x1p-22 : 0x1p-48) * largest);
}

void score_connectivity(const TetMesh& mesh, const Standard& standard, const GivenSurface& given,
                        double touch, SurfaceScore& score) {
  const SurfaceMesh& surface = given.surface;
  std::map<Edge, int> uses;
  for (const auto& t : surface.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      ++uses[{std::min(t[i], t[(i + 1) % 3]), std::max(t[i], t[(i + 1) % 3])}];
  double mean = 0;
  for (const auto& tet : mesh.tets) {
    const auto d = mesh.points[as_size(tet[1])] - mesh.points[as_size(tet[0])];
    mean += length(d) / static_cast<double>(mesh.tets.size());
  }
  const double eps = touch_distance(mesh, given, mean, touch);
  const TriangleSearch search(ends_of_domain(mesh, standard.level.undecided));
  const auto may_end = [&](const Vector3<double>& p) { return search.nearest(p).distance <= eps; };
  std::vector<Edge> holes, ends;
  for (const auto& [edge, count] : uses) {
    if (count > 2) ++score.non_manifold_edges;
    if (count != 1) continue;
    ends.push_back(edge);
    const auto &p = surface.points[as_size(edge[0])], &q = surface.points[as_size(edge[1])];
    if (!may_end(p) || !may_end(q) || !may_end(0.5 * (p + q))) holes.push_back(edge);
  }
  score.hole_edges = holes.size();
  score.holes = pieces(holes);
  score.seam_edges = given.seam_edges + near_pairs(surface, ends, eps);
  score.non_manifold_vertices = pinched_vertices(surface);
}

}  // namespace tensortopo
