// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "tensortopo/mesh/surface_mesh.hpp"

namespace tensortopo {

/// How many of the triangles have a value up to each bound, and above the one before.
struct Histogram {
  std::vector<double> bounds;       ///< ascending; the last one is the largest value possible
  std::vector<std::size_t> counts;  ///< as many
};

struct TriangleQuality {
  Histogram smallest_angle;  ///< in degrees, at most 60
  /// Circumradius over twice the inradius: 1 for an equilateral triangle, infinite for a flat one.
  Histogram aspect_ratio;
  double least_angle = 60, median_angle = 0;
  double median_aspect_ratio = 0, largest_aspect_ratio = 1;
  std::size_t flat = 0;  ///< without area, to rounding
};

TriangleQuality triangle_quality(const SurfaceMesh& surface);

/// The smallest angle of a triangle, in degrees, and its aspect ratio.
std::array<double, 2> quality_of(const std::array<Vector3<double>, 3>& triangle);

/// Distances from samples of one surface to another one.
struct SampledDistance {
  std::size_t samples = 0;
  double largest = 0;  ///< a lower bound of the one-sided Hausdorff distance
  double mean = 0, root_mean_square = 0;
  Vector3<double> where{};  ///< of the largest
};

/// From the vertices of a surface, the middles of its edges and of its triangles to the nearest
/// points of another one. No samples if one of them has no triangles.
SampledDistance sampled_distance(const SurfaceMesh& from, const SurfaceMesh& to);

}  // namespace tensortopo
