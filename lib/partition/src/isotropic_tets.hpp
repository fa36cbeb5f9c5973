// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo {

/// Whether the deviator is zero.
bool is_isotropic(const SymmetricTensor<double>& tensor);

/// How many tetrahedra are isotropic at all four vertices, as `ExtractStatistics::tets_undefined`.
std::size_t isotropic_tets(const TetMesh& mesh);

}  // namespace tensortopo
