// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "exact_degenerate_points.hpp"

#include <ostream>

#include "plane/critical_points.hpp"
#include "plane/real_zeros.hpp"

namespace tensortopo::test {

std::ostream& operator<<(std::ostream& out, const DegenerateCount& count) {
  return out << count.in_plane << " in the plane, " << count.linear << " linear and "
             << count.planar << " planar inside" << (count.on_a_side ? ", some on a side" : "");
}

std::optional<DegenerateCount> exact_degenerate_points(
    const std::array<SymmetricTensor<double>, 3>& corners) {
  TriangleField<Rational> field;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& t = corners[i];
    field.vertex[i] = deviator(tensor_cast<Rational>(t));
  }
  const auto plane = theory::plane_of(field);
  if (!plane) return std::nullopt;
  const auto system = theory::degenerate_system(*plane);
  if (system.position != theory::Position::general) return std::nullopt;
  const theory::RealZeros zeros(system.points.parameters);
  const auto& w = system.points.weights;
  const auto x = zeros.signs(w.x), y = zeros.signs(w.y), z = zeros.signs(w.z);
  const auto det = zeros.signs(determinant(system.points.tensor(*plane)));
  DegenerateCount count;
  count.in_plane = static_cast<int>(zeros.count());
  for (std::size_t i = 0; i < zeros.count(); ++i) {
    const auto any = [&](Sign s) { return x[i] == s || y[i] == s || z[i] == s; };
    if (any(Sign::positive) && any(Sign::negative)) continue;
    if (any(Sign::zero))
      count.on_a_side = true;
    else
      ++(x[i] * det[i] == Sign::positive ? count.linear : count.planar);
  }
  return count;
}

}  // namespace tensortopo::test
