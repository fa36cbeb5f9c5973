// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <CGAL/Interval_nt.h>
#include <CGAL/Mpzf.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "embedding/surface_defects.hpp"

namespace tensortopo::embedding {

namespace {

template <class Number>
using Vector = std::array<Number, 3>;

/// Three times the deviator of a symmetric tensor: xx, yy, zz, xy, yz, xz.
template <class Number>
using Deviator = std::array<Number, 6>;

template <class Number>
Vector<Number> difference(const Vector<Number>& a, const Vector<Number>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

template <class Number>
Vector<Number> cross(const Vector<Number>& a, const Vector<Number>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <class Number>
Number dot(const Vector<Number>& a, const Vector<Number>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class Number>
Number inner(const Deviator<Number>& s, const Deviator<Number>& t) {
  return s[0] * t[0] + s[1] * t[1] + s[2] * t[2] +
         Number(2) * (s[3] * t[3] + s[4] * t[4] + s[5] * t[5]);
}

template <class Number>
Number determinant(const Deviator<Number>& t) {
  return t[0] * (t[1] * t[2] - t[4] * t[4]) - t[3] * (t[3] * t[2] - t[4] * t[5]) +
         t[5] * (t[3] * t[4] - t[1] * t[5]);
}

template <class Number>
Deviator<Number> cofactors(const Deviator<Number>& t) {
  return {t[1] * t[2] - t[4] * t[4], t[0] * t[2] - t[5] * t[5], t[0] * t[1] - t[3] * t[3],
          t[4] * t[5] - t[3] * t[2], t[3] * t[5] - t[0] * t[4], t[3] * t[4] - t[1] * t[5]};
}

/// One tetrahedron. Everything is a polynomial in the input: six volumes are a factor of weights.
template <class Number>
class Cell {
 public:
  Cell(const Field& field, std::size_t t) {
    for (std::size_t i = 0; i < 4; ++i) {
      const auto v = static_cast<std::size_t>(field.tets[t][i]);
      for (std::size_t k = 0; k < 3; ++k) points_[i][k] = Number(field.points[v][k]);
      Deviator<Number> s;
      for (std::size_t k = 0; k < 6; ++k) s[k] = Number(field.tensors[v][k]);
      const Number trace = s[0] + s[1] + s[2];
      for (std::size_t k = 0; k < 6; ++k)
        deviators_[i][k] = k < 3 ? Number(3) * s[k] - trace : Number(3) * s[k];
    }
    // The normal of the face opposite, inwards if the tetrahedron is positively oriented.
    constexpr std::array<std::array<std::size_t, 3>, 4> opposite{
        {{1, 3, 2}, {0, 2, 3}, {0, 3, 1}, {0, 1, 2}}};
    for (std::size_t i = 0; i < 4; ++i) {
      on_face_[i] = points_[opposite[i][0]];
      normals_[i] = cross(difference(points_[opposite[i][1]], on_face_[i]),
                          difference(points_[opposite[i][2]], on_face_[i]));
    }
    six_volumes_ = dot(normals_[0], difference(points_[0], on_face_[0]));
  }

  const Number& six_volumes() const { return six_volumes_; }

  /// Six volumes times the weight of a corner at the sum of some points, over their count.
  Number weight(std::size_t i, const Vector<Number>& sum, int count) const {
    Vector<Number> d;
    for (std::size_t k = 0; k < 3; ++k) d[k] = sum[k] - Number(count) * on_face_[i][k];
    return dot(normals_[i], d);
  }

  Deviator<Number> field_at(const Vector<Number>& sum, int count) const {
    Deviator<Number> d{};
    for (std::size_t k = 0; k < 6; ++k) d[k] = Number(0);
    for (std::size_t i = 0; i < 4; ++i) add(d, weight(i, sum, count), deviators_[i]);
    return d;
  }

  Deviator<Number> derivative(const Vector<Number>& direction) const {
    Deviator<Number> d{};
    for (std::size_t k = 0; k < 6; ++k) d[k] = Number(0);
    for (std::size_t i = 0; i < 4; ++i) add(d, dot(normals_[i], direction), deviators_[i]);
    return d;
  }

  /// A positive multiple of the mode's derivative in a direction.
  Number slope(const Vector<Number>& sum, int count, const Vector<Number>& direction) const {
    const auto d = field_at(sum, count), along = derivative(direction);
    // Both weights and their derivatives have the factor six volumes, which an even power leaves.
    return inner(d, d) * inner(cofactors(d), along) - Number(3) * determinant(d) * inner(d, along);
  }

  const Deviator<Number>& deviator(std::size_t i) const { return deviators_[i]; }
  const Vector<Number>& point(std::size_t i) const { return points_[i]; }

 private:
  static void add(Deviator<Number>& d, const Number& factor, const Deviator<Number>& by) {
    for (std::size_t k = 0; k < 6; ++k) d[k] = d[k] + factor * by[k];
  }

  std::array<Vector<Number>, 4> points_, normals_, on_face_;
  std::array<Deviator<Number>, 4> deviators_;
  Number six_volumes_;
};

bool is_defined(const Field& field, std::size_t t) {
  for (const auto v : field.tets[t]) {
    const auto& s = field.tensors[static_cast<std::size_t>(v)];
    if (s[0] == s[1] && s[1] == s[2] && s[3] == 0 && s[4] == 0 && s[5] == 0) return false;
  }
  return true;
}

using Corners = std::array<const Point*, 3>;

template <class Number>
Vector<Number> vector(const Point& p) {
  return {Number(p[0]), Number(p[1]), Number(p[2])};
}

template <class Number>
Vector<Number> normal(const Corners& t) {
  const auto a = vector<Number>(*t[0]);
  return cross(difference(vector<Number>(*t[1]), a), difference(vector<Number>(*t[2]), a));
}

/// Of the slope along the normal, at the centroid or at corner `at`.
template <class Number>
Number slope(const Field& field, std::size_t tet, const Corners& t, int at) {
  const Cell<Number> cell(field, tet);
  const auto n = normal<Number>(t);
  if (at >= 0) return cell.slope(vector<Number>(*t[static_cast<std::size_t>(at)]), 1, n);
  Vector<Number> sum = vector<Number>(*t[0]);
  for (std::size_t i = 1; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) sum[k] = sum[k] + Number((*t[i])[k]);
  return cell.slope(sum, 3, n);
}

bool is_upward(const Field& field, std::size_t tet, const Corners& t, int at) {
  {
    const CGAL::Protect_FPU_rounding<true> upward;
    const auto value = slope<CGAL::Interval_nt<false>>(field, tet, t, at);
    if (value.inf() > 0) return true;
    if (value.sup() < 0) return false;
  }
  return CGAL::sign(slope<CGAL::Mpzf>(field, tet, t, at)) == CGAL::POSITIVE;
}

bool has_area(const Corners& t) {
  const auto n = normal<CGAL::Mpzf>(t);
  return std::any_of(n.begin(), n.end(), [](const auto& x) { return CGAL::sign(x) != CGAL::ZERO; });
}

double as_double(const CGAL::Mpzf& x) { return CGAL::to_double(x); }

/// The mode of a tensor less the one asked for.
double residual(const Deviator<CGAL::Mpzf>& d, const Mode& mode) {
  const CGAL::Mpzf det = determinant(d), square = inner(d, d);
  const double length = std::sqrt(as_double(square));
  const double own = 3 * std::sqrt(6.0) * as_double(det) / (length * length * length);
  const double asked = static_cast<double>(mode.numerator) / static_cast<double>(mode.denominator);
  if (!(own * asked > 0)) return own - asked;
  // The difference of the squares is exact: 54 det^2 / square^3 - numerator^2 / denominator^2.
  const CGAL::Mpzf p(static_cast<double>(mode.numerator)), q(static_cast<double>(mode.denominator));
  const CGAL::Mpzf cube = square * square * square;
  const CGAL::Mpzf difference = CGAL::Mpzf(54) * q * q * det * det - p * p * cube;
  const double of_squares = as_double(difference) / (as_double(q) * as_double(q) * as_double(cube));
  return of_squares / (own + asked);
}

double length(const Vector<double>& v) { return std::sqrt(dot(v, v)); }

/// What rounding can do to the mode at a vertex, see `residuals`.
double rounding(const Field& field, std::size_t tet, const Point& x) {
  const Cell<double> cell(field, tet);
  const auto d = cell.field_at(x, 1);
  double terms = 0, size = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    terms += std::abs(cell.weight(i, x, 1)) * std::sqrt(inner(cell.deviator(i), cell.deviator(i)));
    size = std::max(size, length(cell.point(i)));
  }
  const double square = inner(d, d);
  Vector<double> gradient;
  for (std::size_t k = 0; k < 3; ++k) {
    Vector<double> axis{0, 0, 0};
    axis[k] = 1;
    gradient[k] = 3 * std::sqrt(6.0) * cell.slope(x, 1, axis) / std::pow(square, 2.5);
  }
  // A derivative has the factor six volumes once, as the field has.
  return 64 * 0x1p-53 * (1 + length(gradient) * size + terms / std::sqrt(square));
}

}  // namespace

AgainstGradient against_gradient(const Surface& surface, const Field& field) {
  AgainstGradient result;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    const auto tet = static_cast<std::size_t>(surface.tet[i]);
    Corners t;
    for (std::size_t k = 0; k < 3; ++k)
      t[k] = &surface.points[static_cast<std::size_t>(surface.triangles[i][k])];
    if (!is_defined(field, tet) || !has_area(t)) continue;
    ++result.compared;
    if (!is_upward(field, tet, t, -1)) result.at_centroid.push_back(i);
    if (!(is_upward(field, tet, t, 0) && is_upward(field, tet, t, 1) &&
          is_upward(field, tet, t, 2)))
      ++result.at_corners;
  }
  return result;
}

Residuals residuals(const Surface& surface, const Field& field, const Mode& mode) {
  const double asked = static_cast<double>(mode.numerator) / static_cast<double>(mode.denominator);
  std::vector<std::int32_t> tet(surface.points.size(), -1);
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
    for (const auto v : surface.triangles[i]) tet[static_cast<std::size_t>(v)] = surface.tet[i];
  Residuals result;
  for (std::size_t v = 0; v < tet.size(); ++v) {
    if (tet[v] < 0 || !is_defined(field, static_cast<std::size_t>(tet[v]))) continue;
    const auto t = static_cast<std::size_t>(tet[v]);
    const Cell<CGAL::Mpzf> cell(field, t);
    const double off =
        std::abs(residual(cell.field_at(vector<CGAL::Mpzf>(surface.points[v]), 1), mode));
    ++result.compared;
    result.largest = std::max(result.largest, off);
    if (!(off <= rounding(field, t, surface.points[v]) + 0x1p-40 * (1 - std::abs(asked))))
      result.off.push_back(v);
  }
  return result;
}

}  // namespace tensortopo::embedding
