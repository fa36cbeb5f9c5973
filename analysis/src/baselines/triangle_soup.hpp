// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "tensortopo/mesh/surface_mesh.hpp"
#include "tensortopo/tensor/deviator.hpp"

namespace tensortopo::baselines {

/// A place and the field there.
struct FieldPoint {
  Deviator<double> tensor{};
  Vector3<double> position{};
};

/// Corners by place.
struct SoupTriangle {
  std::array<Vector3<double>, 3> corners;
  SurfaceMesh::Index tet = -1;
};

/// One vertex for each place; triangles with two equal corners are dropped.
SurfaceMesh merge(const std::vector<std::vector<SoupTriangle>>& by_tet, double mode);

/// Smaller in a fixed order of places: what two tetrahedra compute from the same two points in this
/// order comes out the same.
bool comes_first(const Vector3<double>& p, const Vector3<double>& q);

}  // namespace tensortopo::baselines
