// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <span>
#include <vector>

#include "extract/level/critical/saddle_level.hpp"
#include "extract/level/critical/zero_inside.hpp"
#include "tensortopo/field/characteristic_tensor.hpp"
#include "tensortopo/scalar/rational.hpp"
#include "tensortopo/scalar/sign.hpp"
#include "tensortopo/tensor/mode.hpp"

namespace tensortopo {

namespace {

using Weights = std::vector<Rational>;

// Deviators that commute with a uniaxial one, n, and are orthogonal to it: a plane of neutral
// tensors, given by two of them. With d the axis they are u v^t + v u^t for u, v across d.
std::array<Deviator<Rational>, 2> neutral_plane(const SymmetricTensor<Rational>& n) {
  // n = c (3 d d^t - |d|^2 I), and det n > 0 if c > 0: its columns plus a multiple of I are along
  // d.
  const Rational size = inner(n, n), medium = -Rational(3) * determinant(n) / size;
  const std::array<Vector3<Rational>, 3> columns{
      {{n.xx - medium, n.xy, n.xz}, {n.xy, n.yy - medium, n.yz}, {n.xz, n.yz, n.zz - medium}}};
  Vector3<Rational> axis = columns[0];
  for (const auto& column : columns)
    if (dot(column, column) > dot(axis, axis)) axis = column;
  const Vector3<Rational> x{Rational(1), Rational(0), Rational(0)},
      y{Rational(0), Rational(1), Rational(0)};
  const Vector3<Rational> along_x = cross(axis, x);
  const Vector3<Rational> u = dot(along_x, along_x) == 0 ? cross(axis, y) : along_x,
                          v = cross(axis, u);
  const auto product = [](const Vector3<Rational>& p, const Vector3<Rational>& q) {
    return SymmetricTensor<Rational>{p.x * q.x,
                                     p.y * q.y,
                                     p.z * q.z,
                                     (p.x * q.y + p.y * q.x) / 2,
                                     (p.y * q.z + p.z * q.y) / 2,
                                     (p.x * q.z + p.z * q.x) / 2};
  };
  const Rational uu = dot(u, u), vv = dot(v, v);
  return {deviator(product(u, v)), deviator(vv * product(u, u) - uu * product(v, v))};
}

// Whether a combination of two weightings, not both zero, has no negative weight.
bool meets_simplex(const Weights& first, const Weights& second) {
  for (std::size_t i = 0; i < 4; ++i)
    for (const int sign : {1, -1}) {
      const Rational a = sign * second[i], b = -sign * first[i];
      if (a == 0 && b == 0) continue;
      bool inside = true;
      for (std::size_t k = 0; k < 4; ++k)
        inside = inside && sign_of(Rational(a * first[k] + b * second[k])) != Sign::negative;
      if (inside) return true;
    }
  return false;
}

}  // namespace

// The only non-degenerate critical point of the mode is where the tensor commutes with the
// characteristic tensor N and is orthogonal to it: N^2 - (|N|^2 / 3) I - (tr N^3 / |N|^2) N.
// If N has two equal eigenvalues that vanishes, and a line of neutral tensors takes its place.
bool is_level_at_saddle(std::span<const SymmetricTensor<double>> tensors, const ModeValue& mode) {
  const auto corners = exact_deviators(tensors);
  const auto mu = to_scalar<Rational>(mode);
  const Deviator<Rational> direction = characteristic_direction(
      TetrahedronField<Rational>{{corners[0], corners[1], corners[2], corners[3]}});
  const SymmetricTensor<Rational> n = to_tensor(direction);
  const Rational size = inner(n, n);
  if (size == 0) return false;
  const Deviator<Rational> critical =
      deviator(square(n)) - Rational(Rational(3) * determinant(n) / size) * direction;
  const Rational p = norm_form(critical), q = determinant_form(critical);
  if (p == 0) {
    if (mu != 0) return false;
    const auto plane = neutral_plane(n);
    const auto first = weights_making(plane[0], corners),
               second = weights_making(plane[1], corners);
    return first && second && meets_simplex(*first, *second);
  }
  if (Rational(2) * q * q != mu * mu * p * p * p) return false;
  const auto weights = weights_making(critical, corners);
  if (!weights) return false;
  const Sign first = sign_of((*weights)[0]);
  for (const Rational& w : *weights)
    if (sign_of(w) != first) return false;
  // Negative weights belong to the opposite tensor at the same point.
  return first != Sign::zero && first * sign_of(q) == sign_of(mu);
}

bool may_be_level_at_saddle(const std::array<Deviator<double>, 4>& tensors, double mu) {
  // The modes of the saddle and of the characteristic tensor are sine and cosine of one angle.
  const auto n = characteristic_direction(TetrahedronField<double>{tensors});
  const double p = norm_form(n), q = determinant_form(n);
  if (!(p > std::ldexp(1.0, -20))) return true;  // perhaps of rank below 4
  const double other = std::sqrt(2.0) * q / (p * std::sqrt(p));
  return std::abs(mu * mu + other * other - 1) < std::ldexp(1.0, -16);
}

}  // namespace tensortopo
