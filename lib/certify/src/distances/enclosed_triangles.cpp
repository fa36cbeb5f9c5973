// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "distances/enclosed_triangles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace tensortopo::detail {

using Vector = Vector3<double>;

namespace {

/// With u = 2^-53: a difference is off by u of its modulus; a coordinate of a cross product by 2 u,
/// and a product of two vectors by 3 u, of the same sum of products of moduli. `kUnit` is 32 u: it
/// also covers that these sums are computed of rounded values. Bounds are sums and products of
/// numbers that are not negative, in less than 20 roundings: `kSlack` covers them with 2^13 u.
constexpr double kSlack = 1 + 0x1p-40, kUnit = 0x1p-48;

Vector modulus(const Vector& v) { return {std::abs(v.x), std::abs(v.y), std::abs(v.z)}; }

/// Of the product of moduli of two vectors, coordinate by coordinate as in the cross product.
Vector cross_of_moduli(const Vector& a, const Vector& b) {
  return {a.y * b.z + a.z * b.y, a.z * b.x + a.x * b.z, a.x * b.y + a.y * b.x};
}

Enclosed cross(const Enclosed& a, const Enclosed& b) {
  const Vector u = modulus(a.value), v = modulus(b.value);
  return {tensortopo::cross(a.value, b.value),
          kSlack * (cross_of_moduli(u, b.error) + cross_of_moduli(a.error, v + b.error) +
                    kUnit * cross_of_moduli(u, v))};
}

}  // namespace

Enclosed minus(const Enclosed& a, const Enclosed& b) {
  return {a.value - b.value, kSlack * (a.error + b.error + kUnit * modulus(a.value - b.value))};
}

Enclosed normal_of(std::span<const Enclosed> points, const PatchTriangle& triangle) {
  const auto& [a, b, c] = triangle;
  return cross(minus(points[b], points[a]), minus(points[c], points[a]));
}

double least_product(const Vector& direction, const Enclosed& vector) {
  const Vector d = modulus(direction);
  return dot(direction, vector.value) -
         kSlack * (dot(d, vector.error) + kUnit * dot(d, modulus(vector.value)));
}

double least_product(const Enclosed& a, const Enclosed& b) {
  return least_product(a.value, b) - kSlack * dot(a.error, modulus(b.value) + b.error);
}

bool is_on_side(const Vector& direction, std::span<const Enclosed> vectors) {
  return std::all_of(vectors.begin(), vectors.end(),
                     [&](const Enclosed& v) { return least_product(direction, v) > 0; });
}

bool have_common_side(std::span<const Enclosed> vectors) {
  std::array<Vector, 9> units;
  const std::size_t count = vectors.size();
  Vector sum{}, best{};
  for (std::size_t i = 0; i < count; ++i) sum += units[i] = unit(vectors[i].value);
  if (is_on_side(sum, vectors)) return true;
  double largest = 0;
  const auto consider = [&](const Vector& d) {
    double least = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < count; ++i) least = std::min(least, dot(d, units[i]));
    if (least > largest * length(d)) largest = least / length(d), best = d;
  };
  for (std::size_t i = 0; i < count; ++i) {
    consider(units[i]);
    for (std::size_t j = 0; j < i; ++j) {
      consider(units[i] + units[j]);
      for (std::size_t k = 0; k < j; ++k) {
        const Vector normal = tensortopo::cross(units[j] - units[i], units[k] - units[i]);
        consider(normal), consider(-normal);
      }
    }
  }
  return largest > 0 && is_on_side(best, vectors);
}

bool are_apart(std::span<const Enclosed> points, PatchTriangle a, PatchTriangle b) {
  std::size_t shared = 0;  // moved to the front
  for (std::size_t i = 0; i < 3; ++i) {
    const auto same = std::find(b.begin() + static_cast<std::ptrdiff_t>(shared), b.end(), a[i]);
    if (same == b.end()) continue;
    std::swap(b[shared], *same), std::swap(a[shared], a[i]);
    ++shared;
  }
  const auto from = [&](std::uint32_t p, std::uint32_t q) { return minus(points[q], points[p]); };
  if (shared == 0) {
    std::array<Enclosed, 9> all;
    for (std::size_t i = 0; i < 9; ++i) all[i] = from(b[i % 3], a[i / 3]);
    return have_common_side(all);
  }
  if (shared == 1)
    return have_common_side(
        std::array{from(a[0], a[1]), from(a[0], a[2]), from(b[1], b[0]), from(b[2], b[0])});
  if (shared == 3) return false;
  const Enclosed edge = from(a[0], a[1]);
  return have_common_side(std::array{cross(edge, from(a[0], a[2])), cross(from(a[0], b[2]), edge)});
}

AxisBox box_of(std::span<const Enclosed> points, const PatchTriangle& triangle) {
  AxisBox box;
  for (std::size_t i = 0; i < 3; ++i) {
    const Enclosed& p = points[triangle[i]];
    const Vector low = p.value - 2 * p.error, high = p.value + 2 * p.error;
    const std::array<double, 3> from{low.x, low.y, low.z}, to{high.x, high.y, high.z};
    for (std::size_t k = 0; k < 3; ++k) {
      box.low[k] = i == 0 ? from[k] : std::min(box.low[k], from[k]);
      box.high[k] = i == 0 ? to[k] : std::max(box.high[k], to[k]);
    }
  }
  return box;
}

}  // namespace tensortopo::detail
