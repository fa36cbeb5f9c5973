// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Which closed curve of a face is which closed polygon of the triangles.
#pragma once

#include <map>
#include <set>
#include <vector>

#include "claims/compare_level.hpp"

namespace certificate {

/// The face of a tetrahedron of the input that is opposite one of its vertices.
const FaceTopology& face_opposite(const LevelCase& c, std::size_t tet, Vertex opposite);

/// The vertices that the certificate names the closed curves of a face by, in the order in which
/// they were derived. Nothing if it has another number of them.
///
/// The only curve of a face has its only name. Of several, one belongs to the polygon whose
/// vertices lie in those parts of the face's refinement that it passes, exactly; no other curve
/// passes these.
std::vector<Number> curve_names(const LevelCase& c, const FaceTopology& face);

/// Names the closed curves of faces that have several.
CurveNames name_curves(const LevelCase& c);

}  // namespace certificate
