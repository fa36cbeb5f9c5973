// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "extract/surface/boundary/surface_input.hpp"
#include "tensortopo/mesh/surface_mesh.hpp"

namespace tensortopo {

/// Fills in what is known at each vertex of the surface: normal, mode, residual.
/// @param is_apex  of each vertex: the mode is undefined there
template <class Scalar>
void describe_vertices(const SurfaceInput<Scalar>& input, const std::vector<char>& is_apex,
                       SurfaceMesh& surface);

}  // namespace tensortopo
