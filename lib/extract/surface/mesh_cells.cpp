// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>

#include "extract/patch/charts/manifold_crossings.hpp"
#include "extract/patch/charts/chord_separation.hpp"
#include "extract/patch/fill/fan.hpp"
#include "extract/patch/fill/subdivision_patch.hpp"
#include "extract/patch/fill/fill_loop.hpp"
#include "extract/patch/fill/small_disc.hpp"
#include "extract/level/near_degenerate_level.hpp"
#include "extract/level/position.hpp"
#include "extract/patch/charts/dominant_mesher.hpp"
#include "extract/patch/charts/graph_mesher.hpp"
#include "extract/patch/charts/tube_mesher.hpp"
#include "extract/patch/fill/fill_loops.hpp"
#include "extract/patch/fill/polygon.hpp"
#include "extract/patch/patch_check.hpp"
#include "extract/run/extractor_scalars.hpp"
#include "extract/run/parallel_stage.hpp"
#include "extract/run/release.hpp"
#include "extract/surface/pipeline.hpp"
#include "extract/topology/near_degenerate_sheets.hpp"

namespace tensortopo {

namespace {

constexpr int kAttemptsOnManifold = 3;

/// More samples than this are a high price for meshing on the manifold.
constexpr std::size_t kManySamples = 16;

template <class Scalar>
Budget budget_of_subdivision(const Level<Scalar>& level) {
  return is_near_degenerate(level) ? Budget::large : Budget::regular;
}

/// Thousands of tetrahedra may wait with their leaves: larger ones are rather made again.
template <class Scalar>
void release_large_subdivision(CellTopology<Scalar>& proved) {
  constexpr std::size_t kLarge = 10000;
  if (proved.subdivision && proved.subdivision->refinement.cells().size() > kLarge)
    proved.subdivision.reset();
}

}  // namespace

/// The method at hand failed: the manifold's comes next, with more samples if it has had a turn,
/// then the chart of the dominant eigenvector, then the subdivision of the proof, then these with
/// fans for discs, and last the boundary loops alone. Before either chart asks for many more
/// samples the sheets are tried as graphs, once: where the field nearly has one mode throughout (a
/// twisted shaft's neutral surface), the eigenvectors of a sheet are next to a curve, and no number
/// of samples spreads it.
template <class Scalar>
void Pipeline<Scalar>::try_next_method(std::size_t t) {
  auto& state = tets_[t];
  const auto tet = tet_with_curves(t);
  const auto& level = level_of(t);
  if (state.method == Method::small_disc) {
    state.manifold = tet_manifold(tet, level);
    state.method = Method::manifold;
  }
  if (state.method == Method::tubes) {
    state.method = Method::dominant;
    return;
  }
  const auto try_as_graph = [&] {
    if (!state.proved->direction || state.before_graph) return false;
    state.before_graph = std::exchange(state.method, Method::graph);
    return true;
  };
  const bool asks_for_many =
      (state.method == Method::manifold && state.attempts == 2) ||
      (state.method == Method::dominant && state.attempts <= kAttemptsOnManifold);
  if (asks_for_many && try_as_graph()) return;
  if (state.method == Method::graph) state.method = *state.before_graph;
  if (state.method == Method::manifold && state.manifold && state.attempts < kAttemptsOnManifold) {
    auto vertices = arc_vertices(t, tet);
    state.requests.clear();
    if (runs_along_singularity(*state.manifold, *state.proved, vertices)) {
      state.method = Method::dominant;
      return;
    }
    if (state.attempts++ > 1) state.requests = denser_loops(tet, *state.proved, vertices, level);
    const auto crossings = boundary_crossings(*state.manifold, tet, *state.proved, vertices, level);
    state.requests.insert(state.requests.end(), crossings.begin(), crossings.end());
    const auto between =
        separating_samples<Scalar>(*state.manifold, tet, *state.proved, vertices, crossings, level);
    state.requests.insert(state.requests.end(), between.begin(), between.end());
    if (state.requests.size() > kManySamples && try_as_graph()) {
      --state.attempts;
      state.requests.clear();
    }
    return;
  }
  if (state.method == Method::manifold && state.manifold) {
    state.method = Method::dominant;
    return;
  }
  if (state.method == Method::dominant && state.attempts <= kAttemptsOnManifold) {
    state.attempts = kAttemptsOnManifold + 1;
    auto vertices = arc_vertices(t, tet);
    state.requests = denser_loops(tet, *state.proved, vertices, level);
    return;
  }
  if (state.method == Method::boundaries) {
    state.unresolved = state.obstacle;
    return;
  }
  if (state.method == Method::fan) {
    state.method = Method::boundaries;
    state.obstacle = UnresolvedReason::inconsistent_samples;
    // Around a vertex on the level another level is meshed first, see `move_from_vertices`.
    for (const Index v : vertices_of(t))
      if (on_level_[as_size(v)] == OnLevel::meshed_through) state.unresolved = state.obstacle;
    return;
  }
  if (state.method == Method::subdivision) {
    state.method = Method::fan;
    return;
  }
  if (!add_subdivision(tet, level, *state.proved, budget_of_subdivision(level))) {
    state.method = Method::boundaries;
    state.obstacle = unproved(t);
    return;
  }
  state.method = Method::subdivision;
  state.requests = subdivision_requests(tet, level, *state.proved);
  release_large_subdivision(*state.proved);
}

/// Room for what is numbered, and an eighth more: some faces get further samples, and arrays that
/// grow are twice as large as they need be.
template <class Scalar>
void Pipeline<Scalar>::reserve_boundary_vertices() {
  std::size_t count = 0;
  for (const auto& crossings : crossings_)
    if (crossings) count += crossings->size();
  for (const auto& arcs : arcs_)
    if (arcs)
      for (const auto& arc : *arcs) count += arc.samples.size();
  count += count / 8;
  boundary_position_.reserve(count);
  boundary_medium_.reserve(count);
  boundary_dominant_.reserve(count);
}

template <class Scalar>
void Pipeline<Scalar>::number_edge_vertices() {
  edge_vertex_.resize(complex_.edges.size());
  Index next = 0;
  for (std::size_t e = 0; e < complex_.edges.size(); ++e) {
    edge_vertex_[e] = next;
    next += static_cast<Index>(crossings_[e] ? crossings_[e]->size() : 0);
  }
  boundary_position_.resize(as_size(next));
  boundary_medium_.resize(as_size(next));
  boundary_dominant_.resize(as_size(next));
  parallel_stage(options_, "tetrahedra", complex_.edges.size(), 1024, [&](std::size_t e) {
    if (!crossings_[e]) return;
    const auto& v = complex_.edges[e];
    for (std::size_t k = 0; k < crossings_[e]->size(); ++k) {
      const Scalar& w = (*crossings_[e])[k].weight;
      const std::array<Scalar, 2> weights{Scalar(1) - w, w};
      const auto id = as_size(edge_vertex_[e]) + k;
      const auto simplex = field_.template simplex<2>(v, above_);
      boundary_position_[id] = position_at<Scalar, 2>(
          weights, simplex.exponents, {mesh_.points[as_size(v[0])], mesh_.points[as_size(v[1])]});
      const auto tensor = tensor_at(simplex.tensors, weights);
      boundary_medium_[id] = vector_cast<double>(medium_eigenvector(tensor, level_));
      boundary_dominant_[id] = vector_cast<double>(dominant_eigenvector(tensor, level_));
    }
  });
}

/// Numbers the samples of the faces that changed, after all numbers given so far.
template <class Scalar>
void Pipeline<Scalar>::number_face_vertices(std::span<const std::size_t> changed) {
  face_vertex_.resize(complex_.faces.size());
  auto next = boundary_position_.size();
  for (const auto f : changed) {
    face_vertex_[f] = static_cast<Index>(next);
    if (arcs_[f])
      for (const auto& arc : *arcs_[f]) next += arc.samples.size();
  }
  boundary_position_.resize(next);
  boundary_medium_.resize(next);
  boundary_dominant_.resize(next);
  parallel_stage(options_, "tetrahedra", changed.size(), 1024, [&](std::size_t k) {
    const auto f = changed[k];
    if (!arcs_[f]) return;
    const auto& v = complex_.faces[f];
    auto id = as_size(face_vertex_[f]);
    for (const auto& arc : *arcs_[f])
      for (const auto& sample : arc.samples) {
        boundary_position_[id] = position_at<Scalar, 3>(
            sample.weights,
            {field_.exponents[as_size(v[0])], field_.exponents[as_size(v[1])],
             field_.exponents[as_size(v[2])]},
            {mesh_.points[as_size(v[0])], mesh_.points[as_size(v[1])],
             mesh_.points[as_size(v[2])]});
        boundary_dominant_[id] = vector_cast<double>(dominant_eigenvector(sample.tensor, level_));
        boundary_medium_[id++] = vector_cast<double>(sample.medium);
      }
  });
}

template <class Scalar>
BoundaryVertex Pipeline<Scalar>::crossing_vertex(std::size_t t, const TetWithCurves<Scalar>& tet,
                                                 std::size_t face, const ArcEnd& end) const {
  const auto crossing = crossing_of(tet, static_cast<int>(face), end);
  const auto e = static_cast<std::size_t>(crossing.first);
  return boundary_vertex(edge_vertex_[as_size(complex_.tet_edges[t][e])] + crossing.second,
                         15u & ~(1u << kTetEdges[e][0]) & ~(1u << kTetEdges[e][1]));
}

template <class Scalar>
FaceArcVertices Pipeline<Scalar>::arc_vertices(std::size_t t,
                                               const TetWithCurves<Scalar>& tet) const {
  FaceArcVertices result;
  for (std::size_t f = 0; f < 4; ++f) {
    const auto face = as_size(complex_.tet_faces[t][f]);
    auto next = face_vertex_[face];
    for (const auto& arc : tet.arcs[f]) {
      ArcVertices vertices;
      vertices.vertices.reserve(arc.samples.size() + 2);
      vertices.places.reserve(arc.samples.size() + 2);
      const auto add = [&](const BoundaryVertex& vertex, double place) {
        vertices.vertices.push_back(vertex);
        vertices.places.push_back(place);
      };
      if (!arc.closed) add(crossing_vertex(t, tet, f, arc.begin), 0);
      for (const auto& sample : arc.samples)
        add(boundary_vertex(next++, 1u << f), static_cast<double>(sample.place));
      if (!arc.closed)
        add(crossing_vertex(t, tet, f, arc.end), static_cast<double>(arc.pieces.size()));
      result[f].push_back(std::move(vertices));
    }
  }
  return result;
}

/// Like `loop_vertices`, without the other arcs: nearly all sheets are small.
/// @return how many; 0 if there is no room for them
template <class Scalar>
std::size_t Pipeline<Scalar>::small_loop(std::size_t t, const TetWithCurves<Scalar>& tet,
                                         std::span<const BoundaryArc> loop,
                                         std::span<BoundaryVertex> boundary) const {
  std::size_t size = 0;
  for (const auto& piece : loop) {
    const auto f = static_cast<std::size_t>(piece.face), a = static_cast<std::size_t>(piece.arc);
    const auto& arc = tet.arcs[f][a];
    const std::size_t n = arc.samples.size();
    if (size + n + 1 > boundary.size()) return 0;
    Index first = face_vertex_[as_size(complex_.tet_faces[t][f])];
    for (std::size_t b = 0; b < a; ++b) first += static_cast<Index>(tet.arcs[f][b].samples.size());
    if (!arc.closed)
      boundary[size++] = crossing_vertex(t, tet, f, piece.forward ? arc.begin : arc.end);
    for (std::size_t i = 0; i < n; ++i)
      boundary[size++] =
          boundary_vertex(first + static_cast<Index>(piece.forward ? i : n - 1 - i), 1u << f);
  }
  return size;
}

template <class Scalar>
bool Pipeline<Scalar>::mesh_small_discs(std::size_t t, const TetWithCurves<Scalar>& tet) {
  auto& state = tets_[t];
  std::array<BoundaryVertex, kSmallPolygon> room;
  for (const auto& sheet : state.proved->sheets) {
    if (sheet.loops.size() != 1) return false;
    const auto& loop = state.proved->loops[static_cast<std::size_t>(sheet.loops[0])];
    const std::size_t size = small_loop(t, tet, loop, room);
    if (size == 0) return false;
    const std::span<const BoundaryVertex> boundary(room.data(), size);
    if (!is_small_disc(sheet, boundary, sampling_in(t)) || !fill_loop(boundary, state.patch))
      return false;
  }
  return true;
}

template <class Scalar>
bool Pipeline<Scalar>::mesh_cell_as_graph(std::size_t t, const TetWithCurves<Scalar>& tet) {
  auto& state = tets_[t];
  return state.proved->direction && mesh_as_graph<Scalar>(tet, *state.proved, arc_vertices(t, tet),
                                                          level_of(t), sampling_in(t), state.patch);
}

template <class Scalar>
bool Pipeline<Scalar>::mesh_cell(std::size_t t) {
  auto& state = tets_[t];
  state.patch = {};
  if (state.method == Method::cone) {
    mesh_cone(t);
    return true;
  }
  const auto tet = tet_with_curves(t);
  if (state.method == Method::graph && state.before_graph) return mesh_cell_as_graph(t, tet);
  if (state.method == Method::small_disc || state.method == Method::graph) {
    state.method = Method::small_disc;
    if (mesh_small_discs(t, tet)) return true;
    state.patch = {};
    if (options_.meshing != MeshingMethod::graph || !mesh_cell_as_graph(t, tet)) return false;
    state.method = Method::graph;
    return true;
  }
  const auto vertices = arc_vertices(t, tet);
  if (state.method == Method::tubes)
    return mesh_tubes<Scalar>(*state.manifold, tet, *state.proved, vertices, level_of(t),
                              sampling_in(t), state.patch);
  if (state.method == Method::manifold) {
    Sampling sampling = sampling_in(t);
    if (state.attempts > 2) sampling.resolution *= 2;
    return mesh_on_manifold<Scalar>(*state.manifold, tet, *state.proved, state.requests, vertices,
                                    level_of(t), sampling, state.patch);
  }
  if (state.method == Method::dominant)
    return mesh_by_dominant<Scalar>(*state.manifold, tet, *state.proved, vertices, level_of(t),
                                    sampling_in(t), state.patch);
  if (state.method != Method::boundaries && !state.proved->subdivision &&
      !add_subdivision(tet, level_of(t), *state.proved, budget_of_subdivision(level_of(t))))
    return false;
  const auto mesh = [&](const SheetTopology& sheet) {
    if (state.method == Method::boundaries)
      return fill_loops<Scalar>(*state.proved, sheet, vertices, state.patch) ||
             (state.manifold &&
              mesh_tube<Scalar>(*state.manifold, tet, *state.proved, sheet, vertices, level_of(t),
                                sampling_in(t), state.patch)) ||
             fill_with_collars<Scalar>(tet, *state.proved, sheet, vertices, level_of(t),
                                       state.patch);
    if (state.method == Method::fan && sheet.euler_characteristic == 1)
      return mesh_as_fan<Scalar>(*state.proved, sheet, vertices, level_of(t), state.patch);
    return mesh_from_subdivision<Scalar>(*state.proved, sheet, state.requests, tet, vertices,
                                         level_of(t), state.patch);
  };
  for (const auto& sheet : state.proved->sheets)
    if (!mesh(sheet)) return false;
  release_large_subdivision(*state.proved);
  // Samples that fell together (a vertex of the mesh on the level) can pinch a sheet: then the
  // tetrahedron is named rather than meshed wrongly.
  std::vector<std::vector<BoundaryVertex>> boundaries;
  for (const auto& loop : state.proved->loops) boundaries.push_back(loop_vertices(loop, vertices));
  return are_planned_sheets(state.patch.triangles, boundaries, state.proved->sheets);
}

template <class Scalar>
void Pipeline<Scalar>::mesh_cells() {
  // A tetrahedron that cannot be meshed with the samples that its faces have asks for more, which
  // its neighbours then have as well, and are meshed again. Few rounds are needed.
  reserve_boundary_vertices();
  number_edge_vertices();
  number_zero_vertices();
  std::vector<std::size_t> faces(complex_.faces.size());
  std::iota(faces.begin(), faces.end(), std::size_t{0});
  number_face_vertices(faces);
  release(faces);
  std::vector<std::size_t> meshing;
  for (std::size_t t = 0; t < tets_.size(); ++t)
    if (tets_[t].proved && !tets_[t].unresolved) meshing.push_back(t);
  while (!meshing.empty()) {
    std::vector<char> patch(meshing.size(), 0);
    parallel_stage(options_, "tetrahedra", meshing.size(), 16,
                   [&](std::size_t i) { patch[i] = mesh_cell(meshing[i]); });
    // Ends: a tetrahedron fails at most once with each method and number of samples.
    std::vector<std::size_t> failed;
    for (std::size_t i = 0; i < meshing.size(); ++i)
      if (!patch[i]) failed.push_back(meshing[i]);
    parallel_stage(options_, "tetrahedra", failed.size(), 16,
                   [&](std::size_t i) { try_next_method(failed[i]); });
    const auto changed = merge_requests(failed);
    number_face_vertices(changed);
    meshing.clear();
    for (const auto t : failed)
      if (!tets_[t].unresolved) meshing.push_back(t);
    for (const auto f : changed)
      for (const Index t : complex_.face_tets[f])
        if (t >= 0 && tets_[as_size(t)].proved && !tets_[as_size(t)].unresolved)
          meshing.push_back(as_size(t));
    std::sort(meshing.begin(), meshing.end());
    meshing.erase(std::unique(meshing.begin(), meshing.end()), meshing.end());
  }
}

#define TENSORTOPO_INSTANTIATE(Scalar) template void Pipeline<Scalar>::mesh_cells();
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
