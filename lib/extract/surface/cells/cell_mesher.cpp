// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/surface/cells/cell_mesher.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

#include "extract/level/near_degenerate_level.hpp"
#include "extract/patch/charts/chord_separation.hpp"
#include "extract/patch/charts/dominant_mesher.hpp"
#include "extract/patch/charts/graph_mesher.hpp"
#include "extract/patch/charts/manifold_mesher.hpp"
#include "extract/patch/charts/tube_mesher.hpp"
#include "extract/patch/fill/bisected_patch.hpp"
#include "extract/patch/fill/fan.hpp"
#include "extract/patch/fill/fill_loop.hpp"
#include "extract/patch/fill/fill_loops.hpp"
#include "extract/patch/fill/polygon.hpp"
#include "extract/patch/fill/small_disc.hpp"
#include "extract/patch/fill/subdivision_patch.hpp"
#include "extract/patch/patch_check.hpp"
#include "extract/patch/quality/edge_flips.hpp"
#include "extract/run/extractor_scalars.hpp"
#include "extract/surface/boundary/trace_faces.hpp"
#include "extract/surface/cells/cone_edges.hpp"

namespace tensortopo {

namespace {

/// More samples than this are a high price for meshing on the manifold.
constexpr std::size_t kManySamples = 16;

template <class Scalar>
Budget budget_of_subdivision(const Level<Scalar>& level) {
  return is_near_degenerate(level) ? Budget::large : Budget::regular;
}

/// Thousands of tetrahedra may wait with their subdivisions: larger ones are rather made again.
template <class Scalar>
void release_large_subdivision(CellTopology<Scalar>& topology) {
  constexpr std::size_t kLarge = 10000;
  if (topology.subdivision && topology.subdivision->refinement.cells().size() > kLarge)
    topology.subdivision.reset();
}

/// Whether an order of the corners of a tetrahedron is an even permutation.
bool is_even(const std::array<int, 4>& order) {
  bool even = true;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) even ^= order[i] > order[j];
  return even;
}

}  // namespace

template <class Scalar>
CellMesher<Scalar>::CellMesher(const SurfaceInput<Scalar>& input, const VertexSides& sides,
                               const CellSurroundings<Scalar>& around, CellProof<Scalar>& proof,
                               MeshingState<Scalar>& state, CellMesh<Scalar>& mesh)
    : input_(input),
      sides_(sides),
      around_(around),
      proof_(proof),
      state_(state),
      mesh_(mesh),
      tet_(tet_with_curves(input, sides, around.cells, around.boundary, around.t)) {}

/// Small polygons, then charts with more samples at each attempt, then the subdivision of the
/// proof, this with fans for discs, the boundary loops alone.
template <class Scalar>
auto CellMesher<Scalar>::ways() -> std::span<const Way> {
  using Cell = CellMesher;
  static constexpr std::array<Way, 16> kWays{{
      {Mesher::cone, &Cell::is_cone},
      {Mesher::tubes, &Cell::is_all_tubes},
      {Mesher::small_disc, &Cell::is_not_all_tubes},
      {Mesher::bisected, &Cell::wants_bisection},
      {Mesher::graph, &Cell::wants_graph_before_many_samples},
      {Mesher::manifold, &Cell::wants_chart},
      {Mesher::graph, &Cell::wants_graph_before_many_samples},
      {Mesher::manifold, &Cell::wants_chart},
      {Mesher::graph, &Cell::wants_graph_after_chart},
      {Mesher::manifold, &Cell::wants_denser_chart, 2},
      {Mesher::dominant, &Cell::has_chart},
      {Mesher::graph, &Cell::wants_graph_after_chart},
      {Mesher::dominant, &Cell::wants_denser_loops},
      {Mesher::subdivision, &Cell::wants_subdivision},
      {Mesher::fan, &Cell::wants_fan},
      {Mesher::loops, &Cell::wants_loops},
  }};
  return kWays;
}

template <class Scalar>
void CellMesher<Scalar>::choose_from(std::size_t way) {
  for (; way < ways().size(); ++way) {
    if (!(this->*ways()[way].applies)()) continue;
    state_.way = way;
    mesh_.mesher = ways()[way].mesher;
    return;
  }
  mesh_.unresolved = state_.why_not;
}

template <class Scalar>
void CellMesher<Scalar>::begin() {
  if (!proof_.topology->tubes.empty() && !state_.manifold)
    state_.manifold = tet_manifold(tet_, level());
  state_.tried_as_graph = false;
  state_.requests.clear();
  choose_from(0);
}

template <class Scalar>
void CellMesher<Scalar>::choose_next() {
  if (make_finer()) return;
  // `mend` may have gone on to another chart.
  while (ways()[state_.way].mesher != mesh_.mesher) ++state_.way;
  choose_from(state_.way + 1);
}

template <class Scalar>
bool CellMesher<Scalar>::is_cone() {
  return proof_.is_cone;
}

/// Rings around the arcs of the degenerate curve.
template <class Scalar>
bool CellMesher<Scalar>::is_all_tubes() {
  return state_.manifold && !proof_.topology->tubes.empty();
}

template <class Scalar>
bool CellMesher<Scalar>::is_not_all_tubes() {
  return !is_all_tubes();
}

template <class Scalar>
bool CellMesher<Scalar>::wants_bisection() {
  const auto& sheets = proof_.topology->sheets;
  return mesh_.mesher == Mesher::small_disc && input_.options.meshing == MeshingMethod::bisection &&
         std::all_of(sheets.begin(), sheets.end(), [](const SheetTopology& sheet) {
           return sheet.euler_characteristic == 2 - static_cast<int>(sheet.loops.size()) &&
                  (sheet.loops.size() == 1 || sheet.loops.size() == 2);
         });
}

/// Where the field nearly has one mode throughout (a twisted shaft's neutral surface), the
/// eigenvectors of a sheet are next to a curve, and no number of samples spreads it. So before
/// either chart asks for many more samples the sheets are tried as graphs, once.
template <class Scalar>
bool CellMesher<Scalar>::wants_graph_before_many_samples() {
  if (is_all_tubes() || !proof_.topology->direction || state_.tried_as_graph) return false;
  if (!ask_for_chart(false) || state_.requests.size() <= kManySamples) return false;
  state_.requests.clear();
  return state_.tried_as_graph = true;
}

template <class Scalar>
bool CellMesher<Scalar>::wants_graph_after_chart() {
  const bool is_after = mesh_.mesher == Mesher::manifold || mesh_.mesher == Mesher::dominant;
  if (!is_after || !proof_.topology->direction || state_.tried_as_graph) return false;
  return state_.tried_as_graph = true;
}

/// The samples that the manifold's chart needs for another attempt.
/// @param denser  a sample in the middle of each step along the boundary loops as well
/// @return false if it cannot show the boundary loops
template <class Scalar>
bool CellMesher<Scalar>::ask_for_chart(bool denser) {
  if (shows_loops_ && !(denser && *shows_loops_)) return *shows_loops_;
  shows_loops_ = false;
  if (!state_.manifold) state_.manifold = tet_manifold(tet_, level());
  if (!state_.manifold) return false;
  const auto& topology = *proof_.topology;
  auto vertices = around_.arc_vertices(tet_);
  state_.requests.clear();
  if (runs_along_singularity(*state_.manifold, topology, vertices)) return false;
  if (denser) state_.requests = denser_loops(tet_, topology, vertices, level());
  const auto crossings = boundary_crossings(*state_.manifold, tet_, topology, vertices, level());
  state_.requests.insert(state_.requests.end(), crossings.begin(), crossings.end());
  const auto between =
      separating_samples<Scalar>(*state_.manifold, tet_, topology, vertices, crossings, level());
  state_.requests.insert(state_.requests.end(), between.begin(), between.end());
  shows_loops_ = true;
  return true;
}

template <class Scalar>
bool CellMesher<Scalar>::wants_chart() {
  return !is_all_tubes() && ask_for_chart(false);
}

template <class Scalar>
bool CellMesher<Scalar>::wants_denser_chart() {
  return !is_all_tubes() && ask_for_chart(true);
}

template <class Scalar>
bool CellMesher<Scalar>::has_chart() {
  return state_.manifold != nullptr;
}

template <class Scalar>
bool CellMesher<Scalar>::wants_denser_loops() {
  if (!has_chart()) return false;
  auto vertices = around_.arc_vertices(tet_);
  state_.requests = denser_loops(tet_, *proof_.topology, vertices, level());
  return true;
}

template <class Scalar>
bool CellMesher<Scalar>::wants_subdivision() {
  auto& topology = *proof_.topology;
  if (!add_subdivision(tet_, level(), topology, budget_of_subdivision(level()))) {
    state_.why_not = reason_of_failure(input_, around_.cells, around_.t);
    return false;
  }
  state_.why_not = UnresolvedReason::inconsistent_samples;
  state_.requests = subdivision_requests(tet_, level(), topology);
  release_large_subdivision(topology);
  return true;
}

template <class Scalar>
bool CellMesher<Scalar>::wants_fan() {
  return mesh_.mesher == Mesher::subdivision;
}

/// Around a vertex on the level another level comes first, see `keep_off_pinched`.
template <class Scalar>
bool CellMesher<Scalar>::wants_loops() {
  if (mesh_.mesher != Mesher::fan) return true;
  for (const auto v : input_.vertices_of(around_.cells, around_.t))
    if (sides_.on_level[as_size(v)] == OnLevel::meshed_through) return false;
  return true;
}

template <class Scalar>
bool CellMesher<Scalar>::mesh_small_discs() {
  std::array<BoundaryVertex, kSmallPolygon> room;
  for (const auto& sheet : proof_.topology->sheets) {
    if (sheet.loops.size() != 1) return false;
    const auto& loop = proof_.topology->loops[as_size(sheet.loops[0])];
    const std::size_t size = around_.small_loop(tet_, loop, room);
    if (size == 0) return false;
    const std::span<const BoundaryVertex> boundary(room.data(), size);
    if (!is_small_disc(sheet, boundary, input_.sampling_in(around_.cells, around_.t)) ||
        !fill_loop(boundary, mesh_.patch))
      return false;
  }
  return true;
}

template <class Scalar>
bool CellMesher<Scalar>::mesh_by_bisection() {
  const auto vertices = around_.arc_vertices(tet_);
  const auto sampling = input_.sampling_in(around_.cells, around_.t);
  std::vector<std::vector<BoundaryVertex>> loops;
  for (const auto& loop : proof_.topology->loops) loops.push_back(loop_vertices(loop, vertices));
  for (const auto& sheet : proof_.topology->sheets) {
    const auto& first = loops[as_size(sheet.loops[0])];
    const bool is_done =
        sheet.loops.size() == 2
            ? mesh_bisected_tube<Scalar>(tet_, first, loops[as_size(sheet.loops[1])], level(),
                                         sampling, mesh_.patch)
        : is_small_disc(sheet, first, sampling)
            ? fill_loop(std::span<const BoundaryVertex>(first), mesh_.patch)
            : mesh_bisected_disc<Scalar>(tet_, first, level(), sampling, mesh_.patch);
    if (!is_done) return false;
  }
  flip_edges<Scalar>(tet_, level(), loops, mesh_.patch);
  return true;
}

template <class Scalar>
bool CellMesher<Scalar>::mesh_graph(int defect_rounds) {
  return proof_.topology->direction &&
         mesh_as_graph<Scalar>(tet_, *proof_.topology, around_.arc_vertices(tet_), level(),
                               input_.sampling_in(around_.cells, around_.t), defect_rounds,
                               mesh_.patch);
}

template <class Scalar>
bool CellMesher<Scalar>::mesh_sheet(const SheetTopology& sheet, const FaceArcVertices& vertices) {
  const auto& topology = *proof_.topology;
  if (mesh_.mesher == Mesher::loops)
    return fill_loops<Scalar>(topology, sheet, vertices, mesh_.patch) ||
           (state_.manifold &&
            mesh_tube<Scalar>(*state_.manifold, tet_, topology, sheet, vertices, level(),
                              input_.sampling_in(around_.cells, around_.t), mesh_.patch)) ||
           fill_with_collars<Scalar>(tet_, topology, sheet, vertices, level(), mesh_.patch);
  if (mesh_.mesher == Mesher::fan && sheet.euler_characteristic == 1)
    return mesh_as_fan<Scalar>(topology, sheet, vertices, level(), mesh_.patch);
  return mesh_from_subdivision<Scalar>(topology, sheet, state_.requests, tet_, vertices, level(),
                                       mesh_.patch);
}

/// Sheet by sheet, from the subdivision or the boundary loops.
template <class Scalar>
bool CellMesher<Scalar>::mesh_sheets(const FaceArcVertices& vertices) {
  auto& topology = *proof_.topology;
  if (mesh_.mesher != Mesher::loops && !topology.subdivision &&
      !add_subdivision(tet_, level(), topology, budget_of_subdivision(level())))
    return false;
  for (const auto& sheet : topology.sheets)
    if (!mesh_sheet(sheet, vertices)) return false;
  if (state_.refinements == 0) release_large_subdivision(topology);
  // Samples that fell together (a vertex of the mesh on the level) can pinch a sheet: then the
  // tetrahedron is reported rather than meshed wrongly.
  std::vector<std::vector<BoundaryVertex>> loops;
  for (const auto& loop : topology.loops) loops.push_back(loop_vertices(loop, vertices));
  return are_proved_sheets(mesh_.patch.triangles, loops, topology.sheets);
}

template <class Scalar>
bool CellMesher<Scalar>::mesh_topology(int defect_rounds) {
  mesh_.patch = {};
  const auto& topology = *proof_.topology;
  auto& mesher = mesh_.mesher;
  if (mesher == Mesher::cone) {
    mesh_cone();
    return true;
  }
  if (mesher == Mesher::graph) return mesh_graph(defect_rounds);
  if (mesher == Mesher::small_disc) return mesh_small_discs();
  if (mesher == Mesher::bisected) return mesh_by_bisection();
  const auto vertices = around_.arc_vertices(tet_);
  Sampling sampling = input_.sampling_in(around_.cells, around_.t);
  switch (mesher) {
    case Mesher::tubes:
      return mesh_tubes<Scalar>(*state_.manifold, tet_, topology, vertices, level(), sampling,
                                mesh_.patch);
    case Mesher::manifold:
      sampling.resolution *= ways()[state_.way].density;
      return mesh_on_manifold<Scalar>(*state_.manifold, tet_, topology, state_.requests, vertices,
                                      level(), sampling, defect_rounds, mesh_.patch);
    case Mesher::dominant:
      return mesh_by_dominant<Scalar>(*state_.manifold, tet_, topology, vertices, level(), sampling,
                                      defect_rounds, mesh_.patch);
    default:
      return mesh_sheets(vertices);
  }
}

/// Straight lines from the isotropic vertices.
template <class Scalar>
void CellMesher<Scalar>::mesh_cone() {
  using Index = TetMesh::Index;
  const auto& [cells, boundary, numbers, t] = around_;
  const auto& v = input_.vertices_of(cells, t);
  const unsigned zeros = input_.zero_corners(v);
  auto& triangles = mesh_.patch.triangles;
  if (std::popcount(zeros) == 2) {
    const auto edge = edge_without(zeros);
    const auto ends = kTetEdges[edge], apex = kTetEdges[edge_between(zeros)];
    const auto e = as_size(cells.tet_edges[t][edge]);
    const std::array<Index, 2> tips{numbers.of_zero[as_size(v[as_size(apex[0])])],
                                    numbers.of_zero[as_size(v[as_size(apex[1])])]};
    // Counter-clockwise seen from the second end if this order of the corners is even.
    const bool even =
        is_even({ends[0], ends[1], apex[0], apex[1]}) == (v[as_size(ends[0])] == cells.edges[e][0]);
    const auto crossings = boundary.crossings.rows[e];
    for (std::size_t k = 0; k < crossings.size(); ++k) {
      const auto foot = static_cast<Index>(boundary.crossings.rows.first(e) + k);
      if (crossings[k].rising == even)
        triangles.push_back({foot, tips[0], tips[1]});
      else
        triangles.push_back({foot, tips[1], tips[0]});
    }
    return;
  }
  const auto f = as_size(std::countr_zero(zeros));
  const Index apex = numbers.of_zero[as_size(v[f])];
  const auto vertices = around_.arc_vertices(tet_);
  for (std::size_t a = 0; a < tet_.arcs[f].size(); ++a) {
    const BoundaryArc piece{static_cast<int>(f), static_cast<int>(a), tet_.outward[f]};
    const auto loop = loop_vertices({piece}, vertices);
    const std::size_t n = loop.size(), count = tet_.arcs[f][a].closed ? n : n - 1;
    for (std::size_t i = 0; i < count; ++i)
      triangles.push_back({loop[i].id, loop[i + 1 < n ? i + 1 : 0].id, apex});
  }
}

#define TENSORTOPO_INSTANTIATE(Scalar) template class CellMesher<Scalar>;
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
