// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Triangles whose corners are known up to an error on each axis.
#pragma once

#include <cstdint>
#include <span>

#include "extract/patch/patch_intersections.hpp"
#include "tensortopo/mesh/box_tree.hpp"
#include "tensortopo/mesh/surface_mesh.hpp"

namespace tensortopo::detail {

/// A vector, and how far its coordinates may be off.
struct Enclosed {
  Vector3<double> value, error{};
};

Enclosed minus(const Enclosed& a, const Enclosed& b);

/// Normal to a triangle, as long as twice its area.
Enclosed normal_of(std::span<const Enclosed> points, const PatchTriangle& triangle);

/// Least product of a direction with a vector.
double least_product(const Vector3<double>& direction, const Enclosed& vector);
/// Of two vectors.
double least_product(const Enclosed& a, const Enclosed& b);

/// Whether all vectors have a positive product with a direction.
bool is_on_side(const Vector3<double>& direction, std::span<const Enclosed> vectors);

/// Whether some direction is seen to have a positive product with all vectors. The one of the
/// largest least product with unit vectors is normal to a vertex, an edge or a triangle of their
/// hull.
/// @pre at most 9 vectors
bool have_common_side(std::span<const Enclosed> vectors);

/// Whether two triangles meet in shared vertices only, wherever their corners are within their
/// errors: a plane parts them but for a shared vertex; with two of these they do not fold together.
bool are_apart(std::span<const Enclosed> points, PatchTriangle a, PatchTriangle b);

/// Holds the triangle with twice the errors of its corners.
AxisBox box_of(std::span<const Enclosed> points, const PatchTriangle& triangle);

}  // namespace tensortopo::detail
