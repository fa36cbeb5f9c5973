// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/families/helix_field.hpp"

#include <cmath>

namespace tensortopo {

namespace {

constexpr double kTurn = 6.283185307179586;  // 2 pi

// Taylor's series for |x| <= pi / 4, where the terms left out are below 2^-60.
double small_sine(double x) {
  double sum = 0, term = x;
  for (int n = 1; n <= 17; n += 2) {
    sum += term;
    term *= -x * x / ((n + 1) * (n + 2));
  }
  return sum;
}

double small_cosine(double x) {
  double sum = 0, term = 1;
  for (int n = 0; n <= 18; n += 2) {
    sum += term;
    term *= -x * x / ((n + 1) * (n + 2));
  }
  return sum;
}

SymmetricTensor<double> dyad(const Vector3<double>& a, const Vector3<double>& b) {
  return {a.x * b.x,
          a.y * b.y,
          a.z * b.z,
          (a.x * b.y + a.y * b.x) / 2,
          (a.y * b.z + a.z * b.y) / 2,
          (a.x * b.z + a.z * b.x) / 2};
}

}  // namespace

std::array<double, 2> unit_circle(double turns) {
  const double quarters = std::floor(4 * turns + 0.5);
  const double x = kTurn * (turns - quarters / 4);
  const double c = small_cosine(x), s = small_sine(x);
  switch (static_cast<int>(quarters - 4 * std::floor(quarters / 4))) {
    case 0:
      return {c, s};
    case 1:
      return {-s, c};
    case 2:
      return {-c, -s};
    default:
      return {s, -c};
  }
}

Vector3<double> HelixField::helix(double z) const {
  const auto [c, s] = unit_circle(turns_per_height * z);
  return {radius * c, radius * s, z};
}

SymmetricTensor<double> HelixField::operator()(const Vector3<double>& p) const {
  const auto [c, s] = unit_circle(turns_per_height * p.z);
  const double speed = kTurn * turns_per_height * radius;
  const double length = std::sqrt(1 + speed * speed);
  const Vector3<double> t{-s * speed / length, c * speed / length, 1 / length}, e{c, s, 0};
  const Vector3<double> f = cross(t, e);
  const double u = slope * (p.x - radius * c), v = slope * (p.y - radius * s);
  const SymmetricTensor<double> identity{1, 1, 1, 0, 0, 0};
  return 3.0 * dyad(t, t) - identity + u * (dyad(e, e) - dyad(f, f)) + (2 * v) * dyad(e, f);
}

}  // namespace tensortopo
