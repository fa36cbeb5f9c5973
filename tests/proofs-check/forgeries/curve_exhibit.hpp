// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tensortopo/extract/extract_degenerate_curves.hpp"

namespace tensortopo::test {

/// A field, its degenerate curves and the certificate of the program itself, to be altered.
struct CurveExhibit {
  TetMesh mesh;
  CurveMesh curves;
  nlohmann::json certificate;

  /// The certificate gets the hashes that fit the altered numbers.
  void rehash();
  std::string field_text() const;  ///< a .vtu
  std::string curve_text() const;  ///< a .vtp, with all arrays
};

CurveExhibit curve_exhibit(TetMesh mesh, const std::vector<Degeneracy>& kinds);

/// Small meshes with several points on a face, several pieces in a tetrahedron, a closed curve,
/// both kinds in one file.
const std::vector<CurveExhibit>& honest_curves();

}  // namespace tensortopo::test
