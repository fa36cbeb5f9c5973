// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tensortopo/analysis/extract_report.hpp"

namespace tensortopo {

/// What is said of a surface that was extracted.
SurfaceReport surface_report(const TetMesh& mesh, const ModeValue& mode,
                             const Extraction& extraction);

/// What is said of degenerate curves.
CurveReport curve_report(const ModeValue& mode, const CurveExtraction& extraction);

/// The share of a surface's area that lies in other tetrahedra than these (ascending).
double share_outside(const SurfaceMesh& surface, const std::vector<TetMesh::Index>& tets);

}  // namespace tensortopo
