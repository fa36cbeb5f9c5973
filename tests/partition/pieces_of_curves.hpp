// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Degenerate curves of fields in pieces.
#pragma once

#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <vector>

#include "pieces_of_fields.hpp"
#include "support/fields/special_meshes.hpp"
#include "tensortopo/partition/curve_seam.hpp"
#include "tensortopo/partition/piece_curves.hpp"
#include "tensortopo/partition/seam_numbers.hpp"

namespace tensortopo::test {

inline constexpr std::array kDegeneracies{Degeneracy::linear, Degeneracy::planar};

inline std::vector<PieceCurves> curve_pieces(const TetMesh& mesh,
                                             const std::vector<std::int32_t>& owner, int pieces,
                                             Degeneracy kind) {
  std::vector<PieceCurves> parts;
  for (int p = 0; p < pieces; ++p)
    parts.push_back(extract_curve_piece(cut_piece(mesh, owner, p), kind));
  return parts;
}

/// As other processes get them.
inline std::vector<CurveSeam> sent_curve_seams(const std::vector<PieceCurves>& parts) {
  std::vector<CurveSeam> seams;
  for (const PieceCurves& part : parts)
    seams.push_back(curve_seam_of_numbers(numbers_of(curve_seam_of(part))));
  return seams;
}

template <class T>
bool are_same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

inline bool are_same_cells(const std::vector<UnresolvedCurve>& a,
                           const std::vector<OwnedCurveCell>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& p, const auto& q) {
    return p.tet == q.cell_id && p.obstacle == q.obstacle;
  });
}

/// What is different in merged curves; "" if nothing is.
inline std::string curve_difference(const CurveExtraction& whole, const MergedCurves& merged) {
  const CurveMesh &a = whole.curves, &b = merged.curves;
  if (!are_same_bits(a.points, b.points)) return "points";
  if (a.lines != b.lines) return "lines";
  if (a.carrier != b.carrier) return "carriers";
  if (a.carrier_vertices != b.carrier_vertices) return "vertices of carriers";
  if (!are_same_bits(a.dominant_eigenvector, b.dominant_eigenvector)) return "eigenvectors";
  if (!are_same_bits(a.mode, b.mode)) return "modes";
  if (!are_same_bits(a.separation, b.separation)) return "separations";
  if (!are_same_bits(a.residual, b.residual)) return "residuals";
  if (a.tet != b.tet) return "tetrahedra";
  if (a.component != b.component) return "components";
  if (!are_same_cells(whole.unresolved, merged.unresolved)) return "unresolved tetrahedra";
  if (!are_same_cells(whole.special, merged.special)) return "special tetrahedra";
  return "";
}

}  // namespace tensortopo::test
