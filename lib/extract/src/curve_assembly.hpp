// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "tensortopo/extract/curve_in_tet.hpp"
#include "tensortopo/extract/extract_degenerate_curves.hpp"
#include "tensortopo/extract/scaled_field.hpp"
#include "tensortopo/mesh/tet_complex.hpp"

namespace tensortopo {

/// What is known of the curves before they become one mesh.
struct CurveParts {
  TetComplex complex;
  std::vector<FacePoints> faces;  ///< of the complex; points of one kind only
  /// Of each tetrahedron of the complex: its rim, by positions in `faces`.
  struct RimKey {
    TetMesh::Index face;
    std::size_t point;
  };
  std::vector<std::vector<RimKey>> rims;
  std::vector<CurveInTet> tets;
};

/// Numbers the vertices, and puts the lines of each component in order.
CurveMesh assemble_curves(const TetMesh& mesh, const ScaledField<double>& field, Degeneracy kind,
                          const CurveParts& parts, const ExtractOptions& options);

}  // namespace tensortopo
