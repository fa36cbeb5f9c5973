// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "extract/surface/boundary/level_boundary.hpp"
#include "extract/topology/cell_topology.hpp"
#include "tensortopo/extract/unresolved_reason.hpp"

namespace tensortopo {

/// What is proved of the level in one tetrahedron.
template <class Scalar>
struct CellProof {
  std::unique_ptr<CellTopology<Scalar>> topology;  ///< null: empty, or see `unresolved`
  const Level<Scalar>* level = nullptr;  ///< of the proof and the patch, if not the extraction's
  bool is_cone = false;                  ///< it has isotropic vertices
  std::optional<UnresolvedReason> unresolved;  ///< why there is no proof
};

/// Proofs of all tetrahedra, in their order.
template <class Scalar>
std::vector<CellProof<Scalar>> prove_cells(const SurfaceInput<Scalar>& input,
                                           const VertexSides& sides, const TetComplex& cells,
                                           const LevelBoundary<Scalar>& boundary);

/// The reason why no proof has closed on a tetrahedron.
template <class Scalar>
UnresolvedReason reason_of_failure(const SurfaceInput<Scalar>& input, const TetComplex& cells,
                                   std::size_t t);

}  // namespace tensortopo
