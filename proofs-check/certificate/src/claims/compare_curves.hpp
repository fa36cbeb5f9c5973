// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Claims about degenerate curves against what was derived, and against polylines.
#pragma once

#include <map>

#include "claims/compare_level.hpp"
#include "curves/curve_topology.hpp"

namespace certificate {

/// The curves of one kind in a certificate beside the truth about them.
struct CurveCase {
  const Input& input;
  const Field& field;
  const Polylines& curves;
  const Json& claims;
  Range vertices, lines;  ///< of the kind, among the polylines
  const std::vector<bool>& left_out;
  const CurveTopology& topology;
};

/// Which vertex is which point of a face, as the certificate claims.
using PointVertices = std::map<MeshPoint, Number>;

PointVertices compare_face_points(const CurveCase& c, Ledger& ledger);
void compare_pieces(const CurveCase& c, const PointVertices& vertices, Ledger& ledger);
/// Are the lines in each tetrahedron its pieces, and near it; and the components theirs?
void compare_polylines(const CurveCase& c, Ledger& ledger);

}  // namespace certificate
