// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/patch/patch_defects.hpp"

#include <algorithm>
#include <cmath>

#include "extract/level/level_slope.hpp"
#include "extract/level/position.hpp"
#include "extract/run/extractor_scalars.hpp"

namespace tensortopo {

namespace {

/// Cosine of normal and gradient, and the same with the sides of the triangle for its area: beyond
/// what rounding does to a normal and to a gradient.
constexpr double kLeastCosine = 0x1p-10, kLeastShare = 0x1p-30;

std::array<Vector3<double>, 4> times(double factor, std::array<Vector3<double>, 4> points) {
  for (auto& p : points) p = factor * p;
  return points;
}

}  // namespace

template <class Scalar>
void place_patch(const TetWithCurves<Scalar>& tet, const Patch<Scalar>& meshed,
                 std::span<const Vector3<double>> boundary, PlacedPatch& patch) {
  patch.ids.clear(), patch.points.clear(), patch.triangles.clear();
  for (const auto& t : meshed.triangles) patch.ids.insert(patch.ids.end(), t.begin(), t.end());
  std::sort(patch.ids.begin(), patch.ids.end());
  patch.ids.erase(std::unique(patch.ids.begin(), patch.ids.end()), patch.ids.end());
  patch.points.reserve(patch.ids.size());
  for (const auto id : patch.ids)
    patch.points.push_back(
        id >= 0 ? boundary[static_cast<std::size_t>(id)]
                : position_at(meshed.inner[static_cast<std::size_t>(-1 - id)].weights,
                              tet.simplex.exponents, tet.points));
  const auto place = [&](std::int32_t id) {
    return static_cast<std::uint32_t>(std::lower_bound(patch.ids.begin(), patch.ids.end(), id) -
                                      patch.ids.begin());
  };
  patch.triangles.reserve(meshed.triangles.size());
  for (const auto& t : meshed.triangles)
    patch.triangles.push_back({place(t[0]), place(t[1]), place(t[2])});
}

UpwardTest::UpwardTest(const std::array<Vector3<double>, 4>& points,
                       const std::array<int, 4>& exponents,
                       const std::array<Deviator<double>, 4>& tensors)
    : unit_(unit_of(points)), geometry_(times(unit_, points), exponents), tensors_(tensors) {}

UpwardTest::Facing UpwardTest::facing(const Vector3<double>& a, const Vector3<double>& b,
                                      const Vector3<double>& c) const {
  const auto p = unit_ * a, q = unit_ * b, r = unit_ * c;
  const auto side = q - p, other = r - p;
  const auto n = cross(side, other);
  if (n == Vector3<double>{0, 0, 0}) return {};  // samples fell together, or nearly
  const auto tensor = geometry_.balanced_tensor((1.0 / 3) * (p + q + r), tensors_);
  // The gradient of the mode is that of the level function of the mode that is here.
  const double norm = norm_form(tensor);
  struct {
    double mu, sqrt2;
  } level;
  level.sqrt2 = std::sqrt(2.0);
  level.mu = level.sqrt2 * determinant_form(tensor) / (norm * std::sqrt(norm));
  const auto at = detail::slope_at<LevelSlope<double>>(tensor, level);
  const auto g = geometry_.gradient(at.slope, tensors_);
  const double product = dot(n, g), normal = length(n), gradient = length(g);
  if (normal == 0) return {};
  const double sides = length(side) * length(other);
  return {product > (kLeastCosine * normal + kLeastShare * sides) * gradient,
          product / (normal * gradient)};
}

PatchDefects defects_of(const PlacedPatch& patch, const UpwardTest& test, std::size_t most_tested) {
  PatchDefects defects;
  for (std::uint32_t i = 0; i < patch.triangles.size(); ++i) {
    const auto& t = patch.triangles[i];
    if (!test.facing(patch.points[t[0]], patch.points[t[1]], patch.points[t[2]]).is_upward)
      defects.against.push_back(i);
  }
  if (patch.triangles.size() > 1) {
    auto found = intersecting_pairs(patch.points, patch.triangles, most_tested);
    defects.intersecting = std::move(found.pairs);
    defects.tested = found.tested;
    defects.are_all = found.are_all;
  }
  return defects;
}

bool has_doubled_boundary(const PlacedPatch& patch) {
  std::vector<Vector3<double>> points;
  for (std::size_t i = 0; i < patch.ids.size(); ++i)
    if (patch.ids[i] >= 0) points.push_back(patch.points[i]);
  const auto key = [](const Vector3<double>& p) { return std::array{p.x, p.y, p.z}; };
  std::sort(points.begin(), points.end(),
            [&](const auto& a, const auto& b) { return key(a) < key(b); });
  return std::adjacent_find(points.begin(), points.end(), [&](const auto& a, const auto& b) {
           return key(a) == key(b);
         }) != points.end();
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                          \
  template void place_patch(const TetWithCurves<Scalar>&, const Patch<Scalar>&, \
                            std::span<const Vector3<double>>, PlacedPatch&);
TENSORTOPO_FOR_EACH_PRECISION(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
