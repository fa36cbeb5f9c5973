// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

#include "extract/patch/patch_check.hpp"
#include "extract/patch/patch_defects.hpp"
#include "extract/patch/quality/edge_flips.hpp"
#include "extract/patch/quality/untangle.hpp"
#include "extract/run/extractor_scalars.hpp"
#include "extract/surface/cells/cell_mesher.hpp"

namespace tensortopo {

namespace {

/// How often steps along boundary loops are halved beside triangles with defects, and cells of the
/// subdivision cut that have some.
constexpr int kMostHalvings = 4, kMostRefinements = 8;

/// Intersecting pairs and triangles against the gradient, for each triangle of a patch, that
/// further vertices are tried for.
constexpr std::size_t kMostDefects = 2;

/// How often a chart gets further vertices where triangles have defects.
constexpr int kDefectRounds = 12;

/// Triangles and intersecting pairs of all patches with defects that are tried for one tetrahedron,
/// and pairs tested, of which so many count as one. What is meshed then stays.
constexpr std::size_t kMostTried = 50000, kTestsAsOne = 32;

/// Defects of a patch are few if they are at most so many, and one in so many triangles more.
constexpr std::size_t kFewDefects = 32, kFewInAll = 16;

}  // namespace

/// More samples beside triangles with defects, or smaller cells of the subdivision. What no mesher
/// does without defects is meshed with them, and reported.
/// @return false if another mesher is to be tried
template <class Scalar>
bool CellMesher<Scalar>::make_finer() {
  auto& mesher = mesh_.mesher;
  if (mesh_.has_defects && is_in_chart() && !state_.beside_defects.empty() && are_defects_few() &&
      state_.halvings++ < kMostHalvings) {
    state_.requests.insert(state_.requests.end(), state_.beside_defects.begin(),
                           state_.beside_defects.end());
    return true;
  }
  const bool is_last =
      mesher == Mesher::subdivision || mesher == Mesher::fan || mesher == Mesher::loops;
  if (!state_.must_be_embedded || !state_.was_meshed || !is_last) return false;
  auto& topology = *proof_.topology;
  if (mesher == Mesher::subdivision && mesh_.has_defects && !mesh_.patch.cells_against.empty() &&
      topology.subdivision && are_defects_few() && state_.refinements++ < kMostRefinements) {
    if (refine_subdivision<Scalar>(tet_, level(), mesh_.patch.cells_against, topology)) {
      state_.requests = subdivision_requests(tet_, level(), topology);
      return true;
    }
    mesh_.has_defects = false;
  }
  state_.must_be_embedded = false;
  if (mesh_.has_defects) return true;
  begin();
  return true;
}

/// Whether further vertices may help: where the field is within rounding of a zero they leave ever
/// more defects.
template <class Scalar>
bool CellMesher<Scalar>::are_defects_few() const {
  return state_.defects <= kMostDefects * mesh_.patch.triangles.size() &&
         state_.tried <= kMostTried;
}

template <class Scalar>
bool CellMesher<Scalar>::find_defects() {
  thread_local PlacedPatch patch;
  place_patch<Scalar>(tet_, mesh_.patch, around_.vertices.position, patch);
  const std::size_t left = kMostTried - std::min(state_.tried, kMostTried);
  const auto defects = defects_of(patch, UpwardTest(tet_), kTestsAsOne * left);
  mesh_.has_defects = defects.any();
  state_.defects =
      defects.are_all ? defects.against.size() + defects.intersecting.size() : SIZE_MAX;
  if (mesh_.has_defects)
    state_.tried +=
        mesh_.patch.triangles.size() + defects.intersecting.size() + defects.tested / kTestsAsOne;
  mesh_.has_doubled_boundary = mesh_.has_defects && tensortopo::has_doubled_boundary(patch);
  state_.beside_defects.clear();
  if (mesh_.has_defects && state_.must_be_embedded && defects.are_all)
    state_.beside_defects = samples_beside(defects, patch, tet_, around_.arc_vertices(tet_));
  return mesh_.has_defects;
}

/// Other diagonals, where triangles are folded onto each other.
/// @return whether no defect is left; else the triangles are as before
template <class Scalar>
bool CellMesher<Scalar>::unfold() {
  const auto vertices = around_.arc_vertices(tet_);
  std::vector<std::vector<BoundaryVertex>> loops;
  for (const auto& loop : proof_.topology->loops) loops.push_back(loop_vertices(loop, vertices));
  const auto before = mesh_.patch.triangles;
  flip_edges<Scalar>(tet_, level(), loops, mesh_.patch, Folded::unfolded);
  if (before != mesh_.patch.triangles && !find_defects()) return true;
  mesh_.patch.triangles = before;
  return false;
}

/// Triangles with defects mended one by one, where they are few.
/// @return whether no defect is left; else the patch has no more than before
template <class Scalar>
bool CellMesher<Scalar>::untangle_few() {
  const auto& topology = *proof_.topology;
  if (state_.defects > kFewDefects + mesh_.patch.triangles.size() / kFewInAll) return false;
  const auto vertices = around_.arc_vertices(tet_);
  std::vector<std::vector<BoundaryVertex>> loops;
  for (const auto& loop : topology.loops) loops.push_back(loop_vertices(loop, vertices));
  PlacedPatch placed;
  place_patch<Scalar>(tet_, mesh_.patch, around_.vertices.position, placed);
  auto before = mesh_.patch;
  if (!untangle<Scalar>(tet_, level(), loops, placed, defects_of(placed, UpwardTest(tet_)),
                        mesh_.patch))
    return false;
  const std::size_t defects = state_.defects;
  if (are_proved_sheets(mesh_.patch.triangles, loops, topology.sheets)) {
    if (!find_defects()) return true;
    if (state_.defects <= defects) return false;
  }
  mesh_.patch = std::move(before);
  find_defects();
  return false;
}

/// Meshes in the present chart.
/// @param rounds  of vertices that are added where triangles have defects
template <class Scalar>
bool CellMesher<Scalar>::mesh_without_defects(int rounds) {
  return mesh_topology(rounds) && (!find_defects() || unfold() || untangle_few());
}

/// Other diagonals, the other chart, and further vertices inside; the boundary loops stay.
/// @return whether no defect is left; else the patch is as before
template <class Scalar>
bool CellMesher<Scalar>::mend() {
  if (unfold() || untangle_few()) return true;
  const bool are_few = are_defects_few();
  auto before = std::move(mesh_.patch);
  const auto defects = state_.defects;
  const auto beside = state_.beside_defects;
  auto& mesher = mesh_.mesher;
  if (mesher == Mesher::manifold) {
    mesher = Mesher::dominant;
    if (mesh_without_defects(0) || (are_defects_few() && mesh_without_defects(kDefectRounds)))
      return true;
    mesher = Mesher::manifold;
  }
  if (is_in_chart() && are_few && mesh_without_defects(kDefectRounds)) return true;
  mesh_.patch = std::move(before);
  mesh_.has_defects = true;
  state_.defects = defects;
  state_.beside_defects = beside;
  return false;
}

template <class Scalar>
bool CellMesher<Scalar>::try_mesher() {
  mesh_.has_defects = false;
  if (!mesh_topology(0)) return false;
  if (mesh_.mesher == Mesher::cone || !input_.options.embedded) return true;
  // Surfaces of more digits are there for their topology: their triangles are not mended.
  if (!std::is_same_v<Scalar, double> || state_.tried > kMostTried) state_.must_be_embedded = false;
  if (!find_defects()) return true;
  if (mesh_.mesher == Mesher::bisected) return unfold();
  if (mesh_.has_doubled_boundary) state_.must_be_embedded = false;
  if (!state_.must_be_embedded) {
    if (!mesh_.has_doubled_boundary && std::is_same_v<Scalar, double> && !unfold()) untangle_few();
    return true;
  }
  state_.was_meshed = true;
  return mend();
}

#define TENSORTOPO_INSTANTIATE(Scalar)                         \
  template bool CellMesher<Scalar>::make_finer();              \
  template bool CellMesher<Scalar>::find_defects();            \
  template bool CellMesher<Scalar>::are_defects_few() const;   \
  template bool CellMesher<Scalar>::unfold();                  \
  template bool CellMesher<Scalar>::untangle_few();            \
  template bool CellMesher<Scalar>::mesh_without_defects(int); \
  template bool CellMesher<Scalar>::mend();                    \
  template bool CellMesher<Scalar>::try_mesher();
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
