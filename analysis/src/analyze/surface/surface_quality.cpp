// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "analyze/surface/surface_quality.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "tensortopo/scalar/elementary.hpp"

namespace tensortopo {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

void count(Histogram& histogram, double value) {
  const auto bound = std::lower_bound(histogram.bounds.begin(), histogram.bounds.end() - 1, value);
  ++histogram.counts[static_cast<std::size_t>(bound - histogram.bounds.begin())];
}

double median_of(std::vector<double>& values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

std::array<double, 2> quality_of(const std::array<Vector3<double>, 3>& triangle) {
  const auto& [p, q, r] = triangle;
  const double area = length(cross(q - p, r - p)) / 2;
  const double a = length(r - q), b = length(p - r), c = length(q - p);
  double smallest = 180;
  for (const auto& [u, v] : {std::array{q - p, r - p}, {r - q, p - q}, {p - r, q - r}})
    smallest = std::min(
        smallest, elementary::atan2(length(cross(u, v)), dot(u, v)) * 180 / std::numbers::pi);
  // abc / (4 area) over twice 2 area / (a + b + c).
  const double ratio = area > 0 ? a * b * c * (a + b + c) / (16 * area * area) : kInfinity;
  return {smallest, std::max(ratio, 1.0)};
}

TriangleQuality triangle_quality(const SurfaceMesh& surface) {
  TriangleQuality quality;
  quality.smallest_angle.bounds = {1, 5, 10, 20, 30, 40, 50, 60};
  quality.aspect_ratio.bounds = {1.2, 1.5, 2, 3, 5, 10, 100, kInfinity};
  quality.smallest_angle.counts.resize(8);
  quality.aspect_ratio.counts.resize(8);
  std::vector<double> angles, ratios;
  for (const auto& t : surface.triangles) {
    const auto [angle, ratio] = quality_of({surface.points[static_cast<std::size_t>(t[0])],
                                            surface.points[static_cast<std::size_t>(t[1])],
                                            surface.points[static_cast<std::size_t>(t[2])]});
    count(quality.smallest_angle, angle);
    count(quality.aspect_ratio, ratio);
    quality.flat += !(ratio < kInfinity);
    angles.push_back(angle);
    ratios.push_back(ratio);
    quality.least_angle = std::min(quality.least_angle, angle);
    quality.largest_aspect_ratio = std::max(quality.largest_aspect_ratio, ratio);
  }
  quality.median_angle = median_of(angles);
  quality.median_aspect_ratio = median_of(ratios);
  return quality;
}

}  // namespace tensortopo
