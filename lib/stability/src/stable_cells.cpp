// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "stable_cells.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tensortopo/mesh/tet_complex.hpp"
#include "tensortopo/scalar/elementary.hpp"
#include "tensortopo/scalar/floating_point_environment.hpp"

namespace tensortopo::stability {

namespace {

using Index = TetMesh::Index;

/// Most parts in which an edge, a face or a tetrahedron is looked at.
constexpr int kEdgeParts = 64, kFaceParts = 512, kTetParts = 4096;

/// What is claimed holds for radii larger by this factor, in a quarter of the parts: so that
/// another derivation, with other bounds and guesses, closes as well.
constexpr double kLarger = 1 + 1.0 / 64;

/// For which radii a simplex is proved: its own, or larger ones.
constexpr char kForOwn = 1, kForLarger = 2;

template <class Body>
void in_parallel(std::size_t count, std::size_t grain, const Body& body) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain), [&](const auto& range) {
    const FloatingPointEnvironment environment;
    for (std::size_t i = range.begin(); i != range.end(); ++i) body(i);
  });
}

/// A vertex tensor turned by at most its angle stays in the cone around another, so the members of
/// a tetrahedron have Lode angles that differ from that of the latter by at most the cone's half
/// angle (Hoffman-Wielandt), if the cone is convex.
bool screen_excludes(const UncertainField& field, const std::array<Index, 4>& tet,
                     const std::vector<Traceless>& tensors, const std::vector<double>& norms,
                     double level) {
  std::array<double, 4> reach{};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto v = as_size(tet[i]);
    reach[i] = std::max(reach[i], field.turns[v]);
    for (std::size_t j = i + 1; j < 4; ++j) {
      const auto w = as_size(tet[j]);
      const double angle = elementary::acos(
          std::clamp(inner(tensors[v], tensors[w]) / (norms[v] * norms[w]), -1.0, 1.0));
      reach[i] = std::max(reach[i], angle + field.turns[w]);
      reach[j] = std::max(reach[j], angle + field.turns[v]);
    }
  }
  for (std::size_t i = 0; i < 4; ++i)
    if (reach[i] < 1.57 &&
        std::abs(field.lode_angles[as_size(tet[i])] - level) > reach[i] + 4 * kAngleError)
      return true;
  return false;
}

template <std::size_t Vertices>
BoxSimplex<Vertices> box(const UncertainField& field, const std::vector<Traceless>& tensors,
                         const std::array<Index, Vertices>& vertices, double larger = 1) {
  BoxSimplex<Vertices> simplex;
  for (std::size_t i = 0; i < Vertices; ++i) {
    simplex.tensors[i] = tensors[as_size(vertices[i])];
    simplex.radii[i] = larger * field.radii[as_size(vertices[i])];
  }
  return simplex;
}

}  // namespace

LevelStability stable_cells(const UncertainField& field, const CellTests& tests,
                            const ExtractOptions& options) {
  const TetMesh& mesh = *field.mesh;
  const auto tell = [&](double fraction) {
    if (options.progress) options.progress("stability", fraction);
  };
  std::vector<Traceless> tensors(mesh.points.size());
  std::vector<double> norms(mesh.points.size());
  for (std::size_t v = 0; v < tensors.size(); ++v) {
    tensors[v] = traceless(field.field.tensors[v]);
    norms[v] = norm(tensors[v]);
  }

  LevelStability result;
  result.tets.assign(mesh.tets.size(), Stability::stable);
  std::vector<char> open(mesh.tets.size(), 0);
  in_parallel(mesh.tets.size(), 4096, [&](std::size_t t) {
    const auto& tet = mesh.tets[t];
    for (const Index v : tet)
      if (field.may_vanish[as_size(v)]) result.tets[t] = Stability::isotropic_within_radius;
    open[t] = result.tets[t] != Stability::stable ||
              !screen_excludes(field, tet, tensors, norms, tests.lode_angle);
  });
  tell(0.2);
  std::vector<Index> tets;
  for (std::size_t t = 0; t < open.size(); ++t)
    if (open[t]) tets.push_back(static_cast<Index>(t));
  const TetComplex cells = tet_complex(mesh, tets);

  // Each reason is looked for only where none was found in a simplex of smaller dimension.
  std::vector<char> vertices(mesh.points.size(), 0), edges(cells.edges.size()),
      faces(cells.faces.size());
  for (const Index t : tets)
    for (const Index v : mesh.tets[as_size(t)]) vertices[as_size(v)] = 1;
  in_parallel(vertices.size(), 1024, [&](std::size_t v) {
    vertices[v] = vertices[v] && !field.may_vanish[v] && tests.vertex(tensors[v], v);
  });
  const auto are_stable = [](const auto& simplices, const std::vector<char>& stable) {
    return std::all_of(simplices.begin(), simplices.end(),
                       [&](Index i) { return stable[as_size(i)] != 0; });
  };
  const auto proof = [&](const auto& test, const auto& simplex, int parts) -> char {
    if (test(box(field, tensors, simplex, kLarger), parts / 4)) return kForLarger;
    return test(box(field, tensors, simplex), parts) ? kForOwn : 0;
  };
  in_parallel(edges.size(), 256, [&](std::size_t e) {
    if (are_stable(cells.edges[e], vertices))
      edges[e] = proof(tests.edge, cells.edges[e], kEdgeParts);
  });
  tell(0.4);
  in_parallel(faces.size(), 128, [&](std::size_t f) {
    if (are_stable(cells.face_edges[f], edges))
      faces[f] = proof(tests.face, cells.faces[f], kFaceParts);
  });
  tell(0.7);
  in_parallel(tets.size(), 32, [&](std::size_t k) {
    const auto& tet = mesh.tets[as_size(tets[k])];
    Stability& stability = result.tets[as_size(tets[k])];
    if (stability != Stability::stable) return;
    if (!are_stable(tet, vertices))
      stability = tests.reasons[0];
    else if (!are_stable(cells.tet_edges[k], edges))
      stability = tests.reasons[1];
    else if (!are_stable(cells.tet_faces[k], faces))
      stability = tests.reasons[2];
    else if (!tests.tet(box(field, tensors, tet), kTetParts))
      stability = tests.reasons[3];
  });
  /// Of a simplex that is not stable, with the reason if its boundary is.
  const auto reason_of = [&](const auto& simplex, Stability own) {
    for (const Index v : simplex)
      if (field.may_vanish[as_size(v)]) return Stability::isotropic_within_radius;
    return are_stable(simplex, vertices) ? own : tests.reasons[0];
  };
  for (std::size_t e = 0; e < edges.size(); ++e)
    if (edges[e])
      result.stable_edges.push_back(cells.edges[e]);
    else
      result.unstable_edges.push_back(
          {cells.edges[e], reason_of(cells.edges[e], tests.reasons[1])});
  for (std::size_t f = 0; f < faces.size(); ++f)
    if (faces[f])
      result.stable_faces.push_back(cells.faces[f]);
    else
      result.unstable_faces.push_back(
          {cells.faces[f],
           reason_of(cells.faces[f],
                     tests.reasons[are_stable(cells.face_edges[f], edges) ? 2 : 1])});
  for (std::size_t e = 0; e < edges.size(); ++e)
    if (edges[e] == kForLarger) result.claimed_edges.push_back(cells.edges[e]);
  for (std::size_t f = 0; f < faces.size(); ++f)
    if (faces[f] == kForLarger &&
        std::all_of(cells.face_edges[f].begin(), cells.face_edges[f].end(),
                    [&](Index e) { return edges[as_size(e)] == kForLarger; }))
      result.claimed_faces.push_back(cells.faces[f]);
  std::sort(result.claimed_edges.begin(), result.claimed_edges.end());
  std::sort(result.claimed_faces.begin(), result.claimed_faces.end());
  std::sort(result.stable_edges.begin(), result.stable_edges.end());
  std::sort(result.stable_faces.begin(), result.stable_faces.end());
  const auto by_vertices = [](const auto& a, const auto& b) { return a.vertices < b.vertices; };
  std::sort(result.unstable_edges.begin(), result.unstable_edges.end(), by_vertices);
  std::sort(result.unstable_faces.begin(), result.unstable_faces.end(), by_vertices);
  tell(1);
  return result;
}

}  // namespace tensortopo::stability
