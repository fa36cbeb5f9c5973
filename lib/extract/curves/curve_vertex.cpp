// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/curves/curve_vertex.hpp"

#include <algorithm>
#include <cmath>

#include "extract/curves/points/degenerate_forms.hpp"
#include "tensortopo/scalar/elementary.hpp"
#include "tensortopo/scalar/extended.hpp"
#include "tensortopo/tensor/mode.hpp"

namespace tensortopo {

namespace {

using Vector = Vector3<Extended>;

Vector wide(const Vector3<double>& v) { return {v.x, v.y, v.z}; }

/// A unit vector across another one.
Vector across(const Vector& e) {
  using std::abs;
  const Extended x = abs(e.x), y = abs(e.y), z = abs(e.z);
  if (x <= y && x <= z) return unit(cross(e, Vector{1, 0, 0}));
  if (y <= z) return unit(cross(e, Vector{0, 1, 0}));
  return unit(cross(e, Vector{0, 0, 1}));
}

}  // namespace

FieldInSpace::FieldInSpace(const ScaledField<double>& field, std::size_t tet) {
  const TetMesh& mesh = *field.mesh;
  const auto& v = mesh.tets[tet];
  const auto point = [&](std::size_t i) {
    return wide(mesh.points[static_cast<std::size_t>(v[i])]);
  };
  origin_ = point(0);
  const Vector x = point(1) - origin_, y = point(2) - origin_, z = point(3) - origin_;
  const Extended scale = 1 / dot(cross(x, y), z);
  gradient_ = {Vector{}, scale * cross(y, z), scale * cross(z, x), scale * cross(x, y)};
  gradient_[0] = -(gradient_[1] + gradient_[2] + gradient_[3]);
  int exponent = field.exponents[static_cast<std::size_t>(v[0])];
  for (const auto i : v)
    exponent = std::min(exponent, field.exponents[static_cast<std::size_t>(i)]);
  for (std::size_t i = 0; i < 4; ++i)
    tensors_[i] =
        exact_deviator<Extended>({mesh.tensors[static_cast<std::size_t>(v[i])], exponent});
}

Deviator<Extended> FieldInSpace::at(const Vector3<double>& x) const {
  return tensors_[0] + along(wide(x) - origin_);
}

Deviator<Extended> FieldInSpace::along(const Vector& direction) const {
  Deviator<Extended> d{};
  for (std::size_t i = 0; i < 4; ++i) d = d + dot(gradient_[i], direction) * tensors_[i];
  return d;
}

double FieldInSpace::distance_from_degenerate(const Vector3<double>& x) const {
  const auto t = at(x);
  return std::abs(elementary::sin(3 * lode_angle(tensor_cast<double>(t))));
}

double FieldInSpace::separation(const Vector3<double>& x, const Vector3<double>& dominant) const {
  const Vector e = unit(wide(dominant)), p = across(e), q = cross(e, p);
  const auto components = [&](const Vector& direction) {
    const auto t = thrice(along(direction));
    return std::array<Extended, 2>{(dot(p, t * p) - dot(q, t * q)) / 6, dot(p, t * q) / 3};
  };
  const auto at_p = components(p), at_q = components(q);
  const Extended size = norm_form(at(x)) / 3;
  if (size == 0) return 0;
  // Where tensors of a tetrahedron differ by many orders of magnitude no double holds it.
  constexpr double kLargest = 0x1p1000;
  const Extended separation = (at_p[0] * at_q[1] - at_q[0] * at_p[1]) / size;
  return static_cast<double>(
      std::clamp(separation, static_cast<Extended>(-kLargest), static_cast<Extended>(kLargest)));
}

}  // namespace tensortopo
