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

/// How often cells of the subdivision are cut that have defects.
constexpr int kMostRefinements = 8;

/// How often that may leave no fewer defects than an attempt before.
constexpr int kPatience = 2;

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

/// Whether no further mesher is tried for an embedded patch once this one has one with defects.
template <class Scalar>
bool CellMesher<Scalar>::is_last_mesher() const {
  return mesh_.mesher == Mesher::subdivision || mesh_.mesher == Mesher::fan ||
         mesh_.mesher == Mesher::loops;
}

/// Whether smaller cells of the subdivision may leave fewer defects.
template <class Scalar>
bool CellMesher<Scalar>::may_be_refined() const {
  return mesh_.mesher == Mesher::subdivision && !mesh_.patch.cells_against.empty() &&
         proof_.topology->subdivision && are_defects_few() &&
         (state_.defects < state_.fewest_defects || state_.in_vain < kPatience) &&
         state_.refinements < kMostRefinements;
}

/// Smaller cells of the subdivision. What no mesher does without defects is meshed with them, and
/// reported.
/// @return false if another mesher is to be tried
template <class Scalar>
bool CellMesher<Scalar>::make_finer() {
  if (!state_.must_be_embedded || !state_.was_meshed || !is_last_mesher()) return false;
  auto& topology = *proof_.topology;
  if (mesh_.has_defects) {
    ++state_.refinements;
    state_.in_vain = state_.defects < state_.fewest_defects ? 0 : state_.in_vain + 1;
    state_.fewest_defects = std::min(state_.fewest_defects, state_.defects);
    if (refine_subdivision<Scalar>(tet_, level(), mesh_.patch.cells_against, topology)) {
      state_.requests = subdivision_requests(tet_, level(), topology);
      return true;
    }
  }
  state_.must_be_embedded = false;
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
  found_ = defects_of(patch, UpwardTest(tet_), kTestsAsOne * left);
  mesh_.has_defects = found_.any();
  state_.defects = found_.count();
  if (mesh_.has_defects)
    state_.tried +=
        mesh_.patch.triangles.size() + found_.intersecting.size() + found_.tested / kTestsAsOne;
  mesh_.has_doubled_boundary = mesh_.has_defects && tensortopo::has_doubled_boundary(patch);
  return mesh_.has_defects;
}

template <class Scalar>
DefectivePatch<Scalar> CellMesher<Scalar>::present() const {
  return {mesh_.patch, found_};
}

template <class Scalar>
void CellMesher<Scalar>::go_back_to(DefectivePatch<Scalar> before) {
  mesh_.patch = std::move(before.patch);
  mesh_.has_defects = true;
  found_ = std::move(before.found);
  state_.defects = found_.count();
}

/// Other diagonals, where triangles are folded onto each other.
/// @return whether no defect is left; else the patch has fewer than before, or is as it was
template <class Scalar>
bool CellMesher<Scalar>::unfold() {
  const auto vertices = around_.arc_vertices(tet_);
  std::vector<std::vector<BoundaryVertex>> loops;
  for (const auto& loop : proof_.topology->loops) loops.push_back(loop_vertices(loop, vertices));
  auto before = present();
  flip_edges<Scalar>(tet_, level(), loops, mesh_.patch, Folded::unfolded);
  if (before.patch.triangles == mesh_.patch.triangles) return false;
  if (!find_defects()) return true;
  if (state_.defects >= before.found.count()) go_back_to(std::move(before));
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
  auto before = present();
  if (!untangle<Scalar>(tet_, level(), loops, placed, found_, mesh_.patch)) return false;
  if (are_proved_sheets(mesh_.patch.triangles, loops, topology.sheets)) {
    if (!find_defects()) return true;
    if (state_.defects <= before.found.count()) return false;
  }
  go_back_to(std::move(before));
  return false;
}

/// Meshes in the present chart.
/// @param rounds  of vertices that are added where triangles have defects
template <class Scalar>
bool CellMesher<Scalar>::mesh_without_defects(int rounds) {
  return mesh_topology(rounds) && (!find_defects() || unfold() || untangle_few());
}

/// Other diagonals, the other chart, and further vertices inside; the boundary loops stay.
/// @return whether no defect is left; else the patch has no more than before
template <class Scalar>
bool CellMesher<Scalar>::mend() {
  if (unfold() || untangle_few()) return true;
  const bool are_few = are_defects_few();
  auto before = present();
  auto& mesher = mesh_.mesher;
  if (mesher == Mesher::manifold) {
    mesher = Mesher::dominant;
    if (mesh_without_defects(0) || (are_defects_few() && mesh_without_defects(kDefectRounds)))
      return true;
    mesher = Mesher::manifold;
  }
  if (is_in_chart() && are_few && mesh_without_defects(kDefectRounds)) return true;
  go_back_to(std::move(before));
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
  if (mend()) return true;
  if (!is_last_mesher() || may_be_refined()) return false;
  state_.must_be_embedded = false;
  return true;
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
