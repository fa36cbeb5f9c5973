// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/surface/boundary/trace_faces.hpp"

#include <array>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "extract/level/critical/zero_inside.hpp"
#include "extract/level/near_degenerate_level.hpp"
#include "extract/level/simd/proof_block.hpp"
#include "extract/run/assert.hpp"
#include "extract/run/extractor_scalars.hpp"
#include "extract/run/parallel_stage.hpp"
#include "extract/topology/boundary/arc_samples.hpp"
#include "extract/topology/boundary/edge_crossings.hpp"
#include "extract/topology/boundary/graph_arcs.hpp"

namespace tensortopo {

namespace {

/// The curves of the faces, one face at a time.
template <class Scalar>
struct FaceTracer {
  using Arcs = std::optional<std::vector<FaceArc<Scalar>>>;

  const SurfaceInput<Scalar>& input;
  const VertexSides& sides;
  const TetComplex& cells;
  const MeshCrossings<Scalar>& crossings;

  LevelSimplex<Scalar, 3> simplex(std::size_t f) const {
    return input.field.template simplex<3>(cells.faces[f], sides.above);
  }

  /// An arc that is one piece of the whole face.
  GraphArc graph_arc(std::size_t f, const FaceArc<Scalar>& arc) const {
    const auto in_double = [](const std::array<Scalar, 3>& w) {
      return std::array{static_cast<double>(w[0]), static_cast<double>(w[1]),
                        static_cast<double>(w[2])};
    };
    const auto& piece = arc.pieces[0];
    return {rounded(simplex(f).tensors), in_double(piece.direction), in_double(piece.begin),
            in_double(piece.end)};
  }

  /// Whether the deviator vanishes in a face, whose vertices have one.
  bool vanishes_inside(const std::array<TetMesh::Index, 3>& face) const {
    std::array<Deviator<Scalar>, 3> scaled;
    for (std::size_t i = 0; i < 3; ++i) scaled[i] = input.field.tensors[as_size(face[i])];
    if (!may_have_zero_inside(rounded(scaled))) return false;
    return has_zero_inside(input.tensors_of(face));
  }

  /// Whether the edges of a face are known to hold no crossing, at the extraction's level.
  bool has_free_edges(std::size_t f) const {
    for (const auto e : cells.face_edges[f])
      if (!crossings.rows.is_known(as_size(e)) || !crossings.rows[as_size(e)].empty() ||
          crossings.moved[as_size(e)])
        return false;
    return true;
  }

  /// Whether the level may meet a face though it meets none of its edges.
  bool may_hold_loops(std::size_t f) const {
    const auto& v = cells.faces[f];
    return has_free_edges(f) && !input.has_zero_vertex(v) && !is_clear(input, sides, v);
  }

  /// @param proof  of the face as a whole, if it has been made
  /// @param moved  receives whether the arcs are those of a nearby level
  Arcs trace(std::size_t f, const SimplexProof<Scalar, 3>* proof, char& moved) const {
    std::array<std::span<const EdgeCrossing<Scalar>>, 3> on_edges;
    for (std::size_t e = 0; e < 3; ++e) {
      const auto edge = as_size(cells.face_edges[f][e]);
      if (!crossings.rows.is_known(edge)) return std::nullopt;
      on_edges[e] = crossings.rows[edge];
      moved |= crossings.moved[edge];
    }
    const auto& v = cells.faces[f];
    if (!moved && on_edges[0].empty() && on_edges[1].empty() && on_edges[2].empty() &&
        is_clear(input, sides, v))
      return std::vector<FaceArc<Scalar>>();
    // Straight lines, which belong to their tetrahedra.
    const auto& is_zero = input.field.is_zero;
    if (is_zero[as_size(v[0])] || is_zero[as_size(v[1])] || is_zero[as_size(v[2])])
      return std::vector<FaceArc<Scalar>>();
    // Where the deviator vanishes no subdivision would end.
    if (vanishes_inside(v)) return std::nullopt;
    Arcs arcs;
    const auto sampling = input.sampling_on(cells, f);
    if (!moved) arcs = face_curves_by(proof, simplex(f), on_edges, input.level, sampling);
    if (!arcs) arcs = trace_nearby(f, moved);
    // Not next to a critical value: small cells, then.
    if (!arcs && !moved && is_near_degenerate(input.level))
      arcs = face_curves_by(proof, simplex(f), on_edges, input.level, sampling, Budget::large);
    return arcs;
  }

  /// The curve of a face that is proved to be a graph, with one crossing on each of two edges:
  /// whether there is one. All that `trace` asks is then answered: the bounds of the proof keep
  /// the deviator from vanishing.
  /// @param arcs  receives it without samples
  bool trace_plain(std::size_t f, const SimplexProof<Scalar, 3>* proof,
                   std::vector<FaceArc<Scalar>>& arcs) const {
    if (proof == nullptr || proof->kind != SimplexProof<Scalar, 3>::Kind::monotone) return false;
    std::array<std::span<const EdgeCrossing<Scalar>>, 3> on_edges;
    std::size_t count = 0;
    for (std::size_t e = 0; e < 3; ++e) {
      const auto edge = as_size(cells.face_edges[f][e]);
      if (!crossings.rows.is_known(edge) || crossings.moved[edge]) return false;
      on_edges[e] = crossings.rows[edge];
      if (on_edges[e].size() > 1) return false;
      count += on_edges[e].size();
    }
    return count == 2 && arcs_of_graph(simplex(f), on_edges, input.level, arcs, proof);
  }

  /// The curves of a face at a nearby level. Its edges have as many crossings there.
  Arcs trace_nearby(std::size_t f, char& moved) const {
    const auto tensors = input.tensors_of(cells.faces[f]);
    if (!moved && !input.nearby_levels.is_close_to_critical(tensors)) return std::nullopt;
    const auto* level = input.nearby_levels.level_for(tensors);
    if (level == nullptr) return std::nullopt;
    std::array<std::vector<EdgeCrossing<Scalar>>, 3> found;
    std::array<std::span<const EdgeCrossing<Scalar>>, 3> on_edges;
    for (std::size_t e = 0; e < 3; ++e) {
      const auto edge = as_size(cells.face_edges[f][e]);
      auto there =
          edge_crossings(input.field.template simplex<2>(cells.edges[edge], sides.above), *level);
      if (!there || there->size() != crossings.rows[edge].size()) return std::nullopt;
      found[e] = std::move(*there);
      on_edges[e] = found[e];
    }
    auto arcs = face_curves(simplex(f), on_edges, *level, input.sampling_on(cells, f));
    if (!arcs) return std::nullopt;
    for (auto& arc : *arcs) arc.level = level;
    moved = 1;
    return arcs;
  }
};

/// Whether the ends of a face's arcs are crossings of its edges, samples are in order, and the
/// level that arcs are traced at is named if it is not the extraction's.
template <class Scalar>
[[maybe_unused]] bool are_arcs_sound(const MeshCrossings<Scalar>& crossings,
                                     const TetComplex& cells, std::size_t f, bool moved,
                                     std::span<const FaceArc<Scalar>> arcs) {
  for (const auto& arc : arcs) {
    if ((arc.level != nullptr) != moved) return false;
    if (!arc.closed)
      for (const auto& end : {arc.begin, arc.end}) {
        if (end.edge < 0 || end.edge > 2) return false;
        const auto edge = as_size(cells.face_edges[f][as_size(end.edge)]);
        if (end.crossing < 0 || as_size(end.crossing) >= crossings.rows[edge].size()) return false;
      }
    for (std::size_t i = 1; i < arc.samples.size(); ++i)
      if (arc.samples[i].place < arc.samples[i - 1].place) return false;
  }
  return true;
}

}  // namespace

template <class Scalar>
LevelBoundary<Scalar> trace_faces(const SurfaceInput<Scalar>& input, const VertexSides& sides,
                                  const TetComplex& cells, MeshCrossings<Scalar> crossings) {
  LevelBoundary<Scalar> result;
  result.arcs = Rows<FaceArc<Scalar>>(cells.faces.size());
  result.moved.assign(cells.faces.size(), 0);
  const FaceTracer<Scalar> tracer{input, sides, cells, crossings};
  const SampleTurns turns(input.options.sampling);
  const bool is_uniform = input.options.density.empty();
  // Next to the degenerate curve arcs along which little turns may need samples as well.
  const bool may_be_straight = !is_near_degenerate(input.level);
  const auto trace = [&](std::size_t begin, std::size_t end) {
    ProofBlock<Scalar, 3> proofs;
    EmptyBlock<Scalar, 3> empty;
    StraightBlock<Scalar> straight;
    std::array<std::vector<FaceArc<Scalar>>, ProofBlock<Scalar, 3>::size> plain;
    for (std::size_t f = begin; f < end; ++f)
      if (is_crossed(input, sides, cells.faces[f]))
        proofs.want(f - begin, cells.faces[f], input.field.tensors);
      else if (tracer.may_hold_loops(f))
        empty.want(f - begin, cells.faces[f], input.field.tensors);
    proofs.make(input.level);
    empty.make(input.level);
    for (std::size_t f = begin; is_uniform && f < end; ++f)
      if (auto& arcs = plain[f - begin];
          tracer.trace_plain(f, proofs.of(f - begin), arcs) && may_be_straight)
        straight.want(f - begin, tracer.graph_arc(f, arcs[0]));
    straight.make(input.level, {turns.medium, turns.tensor});
    for (std::size_t f = begin; f < end; ++f) {
      if (empty.is_empty(f - begin)) {
        result.arcs.add(f, {});
      } else if (auto& arcs = plain[f - begin]; !arcs.empty()) {
        if (!straight.is_straight(f - begin))
          sample_arc(arcs[0], tracer.simplex(f).tensors, input.level, turns);
        result.arcs.add(f, std::move(arcs));
      } else if (auto found = tracer.trace(f, proofs.of(f - begin), result.moved[f])) {
        TENSORTOPO_ASSERT(are_arcs_sound<Scalar>(crossings, cells, f, result.moved[f] != 0, *found),
                          "arcs of a face end at crossings of its edges, with samples in order");
        result.arcs.add(f, std::move(*found));
      } else {
        result.arcs.add_unknown(f);
      }
    }
  };
  result.arcs.fill(input.options, "faces", ProofBlock<Scalar, 3>::size, trace);
  result.crossings = std::move(crossings);
  return result;
}

template <class Scalar>
TetWithCurves<Scalar> tet_with_curves(const SurfaceInput<Scalar>& input, const VertexSides& sides,
                                      const TetComplex& cells,
                                      const LevelBoundary<Scalar>& boundary, std::size_t t) {
  const auto& v = input.vertices_of(cells, t);
  TetWithCurves<Scalar> tet;
  tet.simplex = input.field.template simplex<4>(v, sides.above);
  for (std::size_t i = 0; i < 4; ++i) tet.points[i] = input.mesh.points[as_size(v[i])];
  for (std::size_t e = 0; e < 6; ++e)
    tet.edge_forward[e] = v[as_size(kTetEdges[e][0])] < v[as_size(kTetEdges[e][1])];
  // Opposite vertex f, counter-clockwise from outside in a positively oriented tetrahedron.
  constexpr std::array<std::array<std::uint8_t, 3>, 4> outside{
      {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
  for (std::size_t f = 0; f < 4; ++f) {
    auto face = outside[f];
    bool even = true;
    const auto order = [&](std::size_t i, std::size_t j) {
      if (v[face[i]] > v[face[j]]) std::swap(face[i], face[j]), even = !even;
    };
    order(0, 1), order(1, 2), order(0, 1);
    tet.face_vertices[f] = face;
    tet.outward[f] = even;
    tet.arcs[f] = boundary.arcs[as_size(cells.tet_faces[t][f])];
  }
  return tet;
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                                            \
  template LevelBoundary<Scalar> trace_faces(const SurfaceInput<Scalar>&, const VertexSides&,     \
                                             const TetComplex&, MeshCrossings<Scalar>);           \
  template TetWithCurves<Scalar> tet_with_curves(const SurfaceInput<Scalar>&, const VertexSides&, \
                                                 const TetComplex&, const LevelBoundary<Scalar>&, \
                                                 std::size_t);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
