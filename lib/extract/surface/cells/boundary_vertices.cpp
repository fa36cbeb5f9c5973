// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/surface/cells/boundary_vertices.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "extract/level/position.hpp"
#include "extract/run/extractor_scalars.hpp"
#include "extract/run/parallel_stage.hpp"

namespace tensortopo {

namespace {

using Index = TetMesh::Index;

/// How many samples each of some faces has.
template <class Scalar>
std::vector<std::size_t> samples_of(const SurfaceInput<Scalar>& input,
                                    const LevelBoundary<Scalar>& boundary,
                                    std::span<const std::size_t> faces) {
  std::vector<std::size_t> counts(faces.size(), 0);
  parallel_stage(input.options, "tetrahedra", faces.size(), 1024, [&](std::size_t k) {
    for (const auto& arc : boundary.arcs[faces[k]]) counts[k] += arc.samples.size();
  });
  return counts;
}

/// Room for what is numbered, and an eighth more: some faces get further samples, and arrays that
/// grow are twice as large as they need be.
void reserve(std::size_t count, BoundaryVertices& vertices) {
  count += count / 8;
  vertices.position.reserve(count);
  vertices.medium.reserve(count);
  vertices.dominant.reserve(count);
}

void resize(BoundaryVertices& vertices, std::size_t count) {
  vertices.position.resize(count);
  vertices.medium.resize(count);
  vertices.dominant.resize(count);
}

template <class Scalar>
void number_crossings(const SurfaceInput<Scalar>& input, const VertexSides& sides,
                      const TetComplex& cells, const LevelBoundary<Scalar>& boundary,
                      BoundaryVertices& vertices) {
  const auto& rows = boundary.crossings.rows;
  resize(vertices, rows.count());
  parallel_stage(input.options, "tetrahedra", cells.edges.size(), 1024, [&](std::size_t e) {
    const auto& v = cells.edges[e];
    const auto crossings = rows[e];
    for (std::size_t k = 0; k < crossings.size(); ++k) {
      const Scalar& w = crossings[k].weight;
      const std::array<Scalar, 2> weights{Scalar(1) - w, w};
      const auto id = rows.first(e) + k;
      const auto simplex = input.field.template simplex<2>(v, sides.above);
      vertices.position[id] = position_at<Scalar, 2>(
          weights, simplex.exponents,
          {input.mesh.points[as_size(v[0])], input.mesh.points[as_size(v[1])]});
      const auto tensor = tensor_at(simplex.tensors, weights);
      vertices.medium[id] = vector_cast<double>(medium_eigenvector(tensor, input.level));
      vertices.dominant[id] = vector_cast<double>(dominant_eigenvector(tensor, input.level));
    }
  });
}

/// Gives each isotropic vertex of a cone a number, after those of the edges.
template <class Scalar>
void number_zero_vertices(const SurfaceInput<Scalar>& input, const TetComplex& cells,
                          std::span<const CellProof<Scalar>> proofs, BoundaryVertices& vertices) {
  vertices.of_zero.assign(input.mesh.points.size(), -1);
  for (std::size_t t = 0; t < proofs.size(); ++t) {
    if (!proofs[t].is_cone) continue;
    for (const Index v : input.vertices_of(cells, t)) {
      auto& id = vertices.of_zero[as_size(v)];
      if (!input.field.is_zero[as_size(v)] || id >= 0) continue;
      id = static_cast<Index>(vertices.position.size());
      vertices.position.push_back(input.mesh.points[as_size(v)]);
      vertices.medium.push_back({0, 0, 0});
      vertices.dominant.push_back({0, 0, 0});
    }
  }
}

}  // namespace

template <class Scalar>
BoundaryVertices number_boundary(const SurfaceInput<Scalar>& input, const VertexSides& sides,
                                 const TetComplex& cells, const LevelBoundary<Scalar>& boundary,
                                 std::span<const CellProof<Scalar>> proofs,
                                 std::vector<int> round_of_face) {
  BoundaryVertices vertices;
  std::vector<std::size_t> faces;
  faces.reserve(cells.faces.size());
  for (int round = 0; faces.size() < cells.faces.size(); ++round)
    for (std::size_t f = 0; f < cells.faces.size(); ++f)
      if (round_of_face[f] == round) faces.push_back(f);
  const auto counts = samples_of(input, boundary, faces);
  reserve(std::accumulate(counts.begin(), counts.end(), boundary.crossings.rows.count()), vertices);
  number_crossings(input, sides, cells, boundary, vertices);
  number_zero_vertices(input, cells, proofs, vertices);
  vertices.of_face.resize(cells.faces.size());
  vertices.round_of_face = std::move(round_of_face);
  number_samples<Scalar>(input, cells, boundary, faces, vertices);
  return vertices;
}

template <class Scalar>
void number_samples(const SurfaceInput<Scalar>& input, const TetComplex& cells,
                    const LevelBoundary<Scalar>& boundary, std::span<const std::size_t> faces,
                    BoundaryVertices& vertices) {
  const auto counts = samples_of(input, boundary, faces);
  auto next = vertices.position.size();
  for (std::size_t k = 0; k < faces.size(); ++k) {
    vertices.of_face[faces[k]] = static_cast<Index>(next);
    next += counts[k];
  }
  resize(vertices, next);
  parallel_stage(input.options, "tetrahedra", faces.size(), 1024, [&](std::size_t k) {
    const auto f = faces[k];
    const auto& v = cells.faces[f];
    auto id = as_size(vertices.of_face[f]);
    const auto& exponents = input.field.exponents;
    const auto& points = input.mesh.points;
    for (const auto& arc : boundary.arcs[f])
      for (const auto& sample : arc.samples) {
        vertices.position[id] = position_at<Scalar, 3>(
            sample.weights,
            {exponents[as_size(v[0])], exponents[as_size(v[1])], exponents[as_size(v[2])]},
            {points[as_size(v[0])], points[as_size(v[1])], points[as_size(v[2])]});
        vertices.dominant[id] =
            vector_cast<double>(dominant_eigenvector(sample.tensor, input.level));
        vertices.medium[id++] = vector_cast<double>(sample.medium);
      }
  });
}

template <class Scalar>
BoundaryVertex CellSurroundings<Scalar>::crossing_vertex(const TetWithCurves<Scalar>& tet,
                                                         std::size_t face,
                                                         const ArcEnd& end) const {
  const auto crossing = crossing_of(tet, static_cast<int>(face), end);
  const auto e = as_size(crossing.first);
  const auto first = boundary.crossings.rows.first(as_size(cells.tet_edges[t][e]));
  return vertices.vertex(static_cast<Index>(first) + crossing.second,
                         15u & ~(1u << kTetEdges[e][0]) & ~(1u << kTetEdges[e][1]));
}

template <class Scalar>
FaceArcVertices CellSurroundings<Scalar>::arc_vertices(const TetWithCurves<Scalar>& tet) const {
  FaceArcVertices result;
  for (std::size_t f = 0; f < 4; ++f) {
    auto next = vertices.of_face[as_size(cells.tet_faces[t][f])];
    for (const auto& arc : tet.arcs[f]) {
      ArcVertices along;
      along.vertices.reserve(arc.samples.size() + 2);
      along.places.reserve(arc.samples.size() + 2);
      const auto add = [&](const BoundaryVertex& vertex, double place) {
        along.vertices.push_back(vertex);
        along.places.push_back(place);
      };
      if (!arc.closed) add(crossing_vertex(tet, f, arc.begin), 0);
      for (const auto& sample : arc.samples)
        add(vertices.vertex(next++, 1u << f), static_cast<double>(sample.place));
      if (!arc.closed)
        add(crossing_vertex(tet, f, arc.end), static_cast<double>(arc.pieces.size()));
      result[f].push_back(std::move(along));
    }
  }
  return result;
}

template <class Scalar>
std::size_t CellSurroundings<Scalar>::small_loop(const TetWithCurves<Scalar>& tet,
                                                 const BoundaryLoop& loop,
                                                 std::span<BoundaryVertex> room) const {
  std::size_t size = 0;
  for (const auto& piece : loop) {
    const auto f = as_size(piece.face), a = as_size(piece.arc);
    const auto& arc = tet.arcs[f][a];
    const std::size_t n = arc.samples.size();
    if (size + n + 1 > room.size()) return 0;
    Index first = vertices.of_face[as_size(cells.tet_faces[t][f])];
    for (std::size_t b = 0; b < a; ++b) first += static_cast<Index>(tet.arcs[f][b].samples.size());
    if (!arc.closed) room[size++] = crossing_vertex(tet, f, piece.forward ? arc.begin : arc.end);
    for (std::size_t i = 0; i < n; ++i)
      room[size++] =
          vertices.vertex(first + static_cast<Index>(piece.forward ? i : n - 1 - i), 1u << f);
  }
  return size;
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                                       \
  template BoundaryVertices number_boundary(const SurfaceInput<Scalar>&, const VertexSides&, \
                                            const TetComplex&, const LevelBoundary<Scalar>&, \
                                            std::span<const CellProof<Scalar>>,              \
                                            std::vector<int>);                               \
  template void number_samples(const SurfaceInput<Scalar>&, const TetComplex&,               \
                               const LevelBoundary<Scalar>&, std::span<const std::size_t>,   \
                               BoundaryVertices&);                                           \
  template struct CellSurroundings<Scalar>;
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
