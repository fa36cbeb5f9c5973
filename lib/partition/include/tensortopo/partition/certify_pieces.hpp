// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tensortopo/certify/certified_curves.hpp"
#include "tensortopo/certify/certified_level.hpp"
#include "tensortopo/partition/piece_curves.hpp"
#include "tensortopo/partition/piece_surface.hpp"

namespace tensortopo {

/// A merged surface as an extraction from the mesh `merged.cells`, in whose numbers all is; of
/// `statistics` it has `vertices_on_level` and `tets_crossed`.
Extraction extraction_of(const MergedSurface& merged);

/// Merged curves likewise; of `statistics` it has `tets_crossed`.
CurveExtraction extraction_of(const MergedCurves& merged);

/// The claims about a surface put together from pieces, made from the proofs of the pieces.
///
/// Law       They are those that `certify` makes of the extraction from the whole mesh, by ids: the
///           certificate has the same bytes.
/// @param merged  of pieces that were extracted with `ExtractOptions::keep_topology` (else throws
///                std::invalid_argument)
/// @return in numbers of `merged.cells`; `vertex_ids` and `cell_ids` say what these stand for
CertifiedLevel certify(const MergedSurface& merged, const ModeValue& mode);

/// The claims about degenerate curves put together from pieces: those that `certify` makes of the
/// extraction from the whole mesh, by ids.
CertifiedCurves certify(const MergedCurves& merged);

}  // namespace tensortopo
