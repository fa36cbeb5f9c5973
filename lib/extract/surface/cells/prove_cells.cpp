// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/surface/cells/prove_cells.hpp"

#include <bit>
#include <cstddef>
#include <utility>

#include "extract/level/critical/degenerate_configuration.hpp"
#include "extract/level/near_degenerate_level.hpp"
#include "extract/level/simd/proof_block.hpp"
#include "extract/run/assert.hpp"
#include "extract/run/extractor_scalars.hpp"
#include "extract/run/parallel_stage.hpp"
#include "extract/surface/boundary/trace_faces.hpp"
#include "extract/surface/cells/cone_edges.hpp"

namespace tensortopo {

namespace {

/// A tetrahedron with one or two isotropic vertices: one sheet for each curve of the opposite
/// face, or for each crossing of the opposite edge.
template <class Scalar>
CellProof<Scalar> prove_cone(const SurfaceInput<Scalar>& input, const TetComplex& cells,
                             const LevelBoundary<Scalar>& boundary, std::size_t t) {
  CellProof<Scalar> proof;
  const unsigned zeros = input.zero_corners(input.vertices_of(cells, t));
  std::size_t sheets = 0;
  bool is_known = false;
  if (std::popcount(zeros) == 1) {
    const auto f = as_size(cells.tet_faces[t][as_size(std::countr_zero(zeros))]);
    is_known = boundary.arcs.is_known(f);
    sheets = boundary.arcs[f].size();
  } else {
    const auto e = as_size(cells.tet_edges[t][edge_without(zeros)]);
    is_known = boundary.crossings.rows.is_known(e);
    sheets = boundary.crossings.rows[e].size();
  }
  if (!is_known) {
    proof.unresolved = reason_of_failure(input, cells, t);
    return proof;
  }
  if (sheets == 0) return proof;
  proof.is_cone = true;
  proof.topology = std::make_unique<CellTopology<Scalar>>();
  proof.topology->sheets.assign(sheets, {{}, 1, -1});
  return proof;
}

/// Whether each loop bounds just one sheet, and each sheet has as many loops as its Euler
/// characteristic allows: 2 - 2 genus - loops.
template <class Scalar>
[[maybe_unused]] bool are_sheets_sound(const CellTopology<Scalar>& topology) {
  std::vector<char> taken(topology.loops.size(), 0);
  for (const auto& sheet : topology.sheets) {
    const int genus_twice = 2 - sheet.euler_characteristic - static_cast<int>(sheet.loops.size());
    if (genus_twice < 0 || genus_twice % 2 != 0) return false;
    for (const int loop : sheet.loops)
      if (taken[as_size(loop)]++ != 0) return false;
  }
  for (const char t : taken)
    if (t == 0) return false;
  return true;
}

/// Whether each arc of a loop ends where the next one begins.
template <class Scalar>
[[maybe_unused]] bool are_loops_closed(const TetWithCurves<Scalar>& tet,
                                       const CellTopology<Scalar>& topology) {
  const auto end_of = [&](const BoundaryArc& piece, bool last) {
    const auto& arc = tet.arcs[as_size(piece.face)][as_size(piece.arc)];
    return crossing_of(tet, piece.face, piece.forward == last ? arc.end : arc.begin);
  };
  for (const auto& loop : topology.loops)
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const auto& next = loop[i + 1 < loop.size() ? i + 1 : 0];
      if (tet.arcs[as_size(loop[i].face)][as_size(loop[i].arc)].closed) {
        if (loop.size() != 1) return false;
      } else if (end_of(loop[i], true) != end_of(next, false)) {
        return false;
      }
    }
  return true;
}

/// @param known  the proof of the tetrahedron as a whole, if it has been made
template <class Scalar>
CellProof<Scalar> prove_one(const SurfaceInput<Scalar>& input, const VertexSides& sides,
                            const TetComplex& cells, const LevelBoundary<Scalar>& boundary,
                            std::size_t t, const SimplexProof<Scalar, 4>* known) {
  const auto& vertices = input.vertices_of(cells, t);
  if (input.zero_corners(vertices) != 0) return prove_cone(input, cells, boundary, t);
  CellProof<Scalar> proof;
  bool any = false, moved = false;
  for (const auto w : cells.tet_faces[t]) {
    const auto f = as_size(w);
    if (!boundary.arcs.is_known(f)) {
      proof.unresolved = reason_of_failure(input, cells, t);
      return proof;
    }
    any |= !boundary.arcs[f].empty();
    moved |= boundary.moved[f] != 0;
  }
  if (!any) return proof;
  const auto tet = tet_with_curves(input, sides, cells, boundary, t);
  const auto take = [&](std::optional<CellTopology<Scalar>> topology) {
    if (topology) proof.topology = std::make_unique<CellTopology<Scalar>>(std::move(*topology));
  };
  const auto prove_here = [&](Budget budget) {
    take(prove_cell_from<Scalar>(known, tet, input.level, nullptr, budget));
  };
  const bool is_near_end = is_near_degenerate(input.level);
  if (!moved) prove_here(is_near_end ? Budget::regular : Budget::small);
  if (!proof.topology) {
    const auto tensors = input.tensors_of(vertices);
    if (moved || input.nearby_levels.is_close_to_critical(tensors))
      proof.level = input.nearby_levels.level_for(tensors);
    if (proof.level != nullptr)
      take(prove_cell(tet, *proof.level, input.nearby_levels.far_level_for(tensors)));
  }
  if (!proof.topology && !moved && (proof.level == nullptr || !is_near_end)) {
    prove_here(is_near_end ? Budget::large : Budget::regular);
    if (proof.topology) proof.level = nullptr;
  }
  if (!proof.topology) proof.unresolved = reason_of_failure(input, cells, t);
  TENSORTOPO_ASSERT(!proof.topology || are_loops_closed(tet, *proof.topology),
                    "arcs of a boundary loop join");
  TENSORTOPO_ASSERT(!proof.topology || are_sheets_sound(*proof.topology),
                    "each loop bounds one sheet, of a genus that its loops allow");
  return proof;
}

}  // namespace

template <class Scalar>
UnresolvedReason reason_of_failure(const SurfaceInput<Scalar>& input, const TetComplex& cells,
                                   std::size_t t) {
  std::vector<SymmetricTensor<double>> tensors;
  for (const auto v : input.vertices_of(cells, t))
    if (!input.field.is_zero[as_size(v)]) tensors.push_back(input.mesh.tensors[as_size(v)]);
  return degenerate_configuration(tensors, input.level.value);
}

template <class Scalar>
std::vector<CellProof<Scalar>> prove_cells(const SurfaceInput<Scalar>& input,
                                           const VertexSides& sides, const TetComplex& cells,
                                           const LevelBoundary<Scalar>& boundary) {
  std::vector<CellProof<Scalar>> proofs(cells.tets.size());
  const auto prove = [&](std::size_t begin, std::size_t end) {
    ProofBlock<Scalar, 4> block;
    for (std::size_t t = begin; t < end; ++t)
      if (is_crossed(input, sides, input.vertices_of(cells, t)))
        block.want(t - begin, input.vertices_of(cells, t), input.field.tensors);
    block.make(input.level);
    for (std::size_t t = begin; t < end; ++t)
      proofs[t] = prove_one(input, sides, cells, boundary, t, block.of(t - begin));
  };
  parallel_blocks(input.options, "tetrahedra", proofs.size(), 64, ProofBlock<Scalar, 4>::size,
                  prove);
  return proofs;
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                                        \
  template UnresolvedReason reason_of_failure(const SurfaceInput<Scalar>&, const TetComplex&, \
                                              std::size_t);                                   \
  template std::vector<CellProof<Scalar>> prove_cells(const SurfaceInput<Scalar>&,            \
                                                      const VertexSides&, const TetComplex&,  \
                                                      const LevelBoundary<Scalar>&);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
