// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compare_level.hpp"

namespace certificate {

/// The face of a tetrahedron without this vertex of it. @pre it is among those of the topology
const FaceTopology& face_opposite(const LevelCase& c, std::size_t tet, Vertex opposite);

/// The vertices that name the closed curves of a face, in the order of its `level.loops`; empty if
/// the certificate has none that could.
///
/// Where there are several, each name goes to the nearest curve, in plain doubles. That is
/// no proof and need not be one: if *any* one-to-one naming fits the sheets at both sides, the
/// triangles are homeomorphic to the level by a map that keeps the face.
std::vector<Number> curve_names(const LevelCase& c, const FaceTopology& face);

}  // namespace certificate
