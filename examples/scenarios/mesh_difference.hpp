// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo::scenarios {

/// A piecewise linear field at some points. Throws std::invalid_argument, with the point, if one is
/// farther from the mesh than a millionth of its extent.
std::vector<SymmetricTensor<double>> tensors_at(const std::vector<Vector3<double>>& points,
                                                const TetMesh& field);

/// By how much the deviators of two piecewise linear fields, on meshes of one solid, differ at the
/// points of the first, in the Frobenius norm, rounded up: radii for `extract --uncertainty
/// array:NAME`, which then speaks of both fields, the second as it is between those points. Throws
/// as `tensors_at` does.
std::vector<double> deviator_differences(const TetMesh& at, const TetMesh& other);

}  // namespace tensortopo::scenarios
