// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "tensortopo/extract/extract_degenerate_curves.hpp"
#include "tensortopo/extract/extract_mode_surface.hpp"

namespace tensortopo {

/// The mode surface of a mesh, extracted slab after slab: the same bits as `extract_mode_surface`
/// gives, with the memory that one slab takes, besides the mesh and the surface.
///
/// Pieces that do not agree where they meet are extracted again with more layers of ghosts.
/// @param pieces  how many slabs, at least 1 (else throws std::invalid_argument)
/// @return all but `carrier_id` of `surface`, and of `statistics` only `tets_crossed`,
///         `tets_undefined` and `vertices_on_level`
/// @pre as `extract_mode_surface`
Extraction extract_in_pieces(const TetMesh& mesh, const ModeValue& mode, std::int32_t pieces,
                             const ExtractOptions& options = {});

/// The degenerate curves of a mesh, likewise: the same bits as `extract_degenerate_curves` gives.
/// @return of `statistics` only `tets_crossed`
/// @pre as `extract_degenerate_curves`
CurveExtraction extract_in_pieces(const TetMesh& mesh, Degeneracy kind, std::int32_t pieces,
                                  const ExtractOptions& options = {});

}  // namespace tensortopo
