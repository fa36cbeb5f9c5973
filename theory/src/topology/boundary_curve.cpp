// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "topology/boundary_curve.hpp"

#include <cstddef>
#include <optional>
#include <vector>

#include "dominant_form.hpp"
#include "tensortopo/scalar/interval.hpp"
#include "tensortopo/theory/arithmetic.hpp"

namespace tensortopo::theory {
namespace {

using IntervalTensor = SymmetricTensor<Interval>;

// Tensors d_i of which <d_i, t> is the weight of vertex i in t, up to a common factor: by
// inversion of the matrix of inner products.
std::array<Tensor, 4> dual_basis(const std::array<Tensor, 4>& vertices) {
  std::array<std::array<Rational, 8>, 4> m;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      m[i][j] = inner(vertices[i], vertices[j]);
      m[i][j + 4] = Rational(i == j ? 1 : 0);
    }
  for (std::size_t i = 0; i < 4; ++i) {
    // The matrix is positive definite: its pivots are not zero.
    const Rational pivot = m[i][i];
    for (Rational& entry : m[i]) entry = entry / pivot;
    for (std::size_t k = 0; k < 4; ++k) {
      const Rational factor = m[k][i];
      if (k == i) continue;
      for (std::size_t j = 0; j < 8; ++j) m[k][j] = m[k][j] - factor * m[i][j];
    }
  }
  std::array<Tensor, 4> dual;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) dual[i] = dual[i] + m[i][j + 4] * vertices[j];
  return dual;
}

IntervalTensor enclosure(const Tensor& t) {
  return {enclosing<Interval>(t.xx), enclosing<Interval>(t.yy), enclosing<Interval>(t.zz),
          enclosing<Interval>(t.xy), enclosing<Interval>(t.yz), enclosing<Interval>(t.xz)};
}

struct Curve {
  IntervalTensor normal;
  Interval weight;    // (1 - s^2) / 4
  Interval third_s2;  // s^2 / 3
  std::array<IntervalTensor, 4> dual;
};

// The tensor with a boundary vector v as its medium eigenvector, homogeneous of degree four in v:
// the normal seen across v, made traceless and of the right mode.
IntervalTensor boundary_tensor(const Curve& curve, const Vector3<Interval>& v) {
  const Interval size = dot(v, v);
  const Vector3<Interval> image = curve.normal * v;
  const Interval alpha = dot(v, image);
  const IntervalTensor along = projection_to(v);
  // P N P with P = |v|^2 - v v^T.
  const IntervalTensor mixed = {v.x * image.x + v.x * image.x, v.y * image.y + v.y * image.y,
                                v.z * image.z + v.z * image.z, v.x * image.y + v.y * image.x,
                                v.y * image.z + v.z * image.y, v.x * image.z + v.z * image.x};
  const IntervalTensor across = size * (size * curve.normal) - size * mixed + alpha * along;
  const IntervalTensor plane = isotropic(size) - along;
  const Interval half = alpha / Interval(2);
  return across + (half * (Interval(1) + curve.third_s2)) * plane -
         (curve.third_s2 * alpha) * along;
}

enum class Place { away, inside, unknown };

Place place_of(const Curve& curve, const Vector3<Interval>& box) {
  const Verdict off = certified_sign(boundary_form(curve.normal, box, curve.weight));
  if (off == Verdict::positive || off == Verdict::negative) return Place::away;
  const IntervalTensor t = boundary_tensor(curve, box);
  int positive = 0, negative = 0;
  for (const IntervalTensor& d : curve.dual) {
    const Verdict sign = certified_sign(inner(d, t));
    positive += sign == Verdict::positive ? 1 : 0;
    negative += sign == Verdict::negative ? 1 : 0;
  }
  return positive == 4 || negative == 4 ? Place::inside : Place::unknown;
}

// Whether the boundary function changes its sign between two corners of the box.
bool is_crossed(const Curve& curve, const Vector3<Interval>& box) {
  const auto sign_at = [&](bool up_x, bool up_y, bool up_z) {
    const auto end = [](const Interval& i, bool up) { return Interval(up ? i.sup() : i.inf()); };
    const Vector3<Interval> v = {end(box.x, up_x), end(box.y, up_y), end(box.z, up_z)};
    return certified_sign(boundary_form(curve.normal, v, curve.weight));
  };
  bool positive = false, negative = false;
  for (unsigned corner = 0; corner < 8; ++corner) {
    const Verdict sign = sign_at(corner & 1, corner & 2, corner & 4);
    positive = positive || sign == Verdict::positive;
    negative = negative || sign == Verdict::negative;
  }
  return positive && negative;
}

// On a cube around the centre, one of each two opposite vectors with x z of the sign given.
std::vector<Vector3<Interval>> vectors_of(int side) {
  const Interval one(1), both(-1, 1), up(0, 1), down(-1, 0);
  const Interval like = side > 0 ? up : down, unlike = side > 0 ? down : up;
  return {{like, both, one}, {one, both, like}, {up, one, like}, {down, one, unlike}};
}

// The same with x z = 0.
std::vector<Vector3<Interval>> vectors_between() {
  const Interval zero(0), one(1), both(-1, 1);
  return {{zero, both, one}, {zero, one, both}, {one, both, zero}, {both, one, zero}};
}

void halve(const Vector3<Interval>& box, std::vector<Vector3<Interval>>& waiting) {
  const auto width = [](const Interval& i) { return i.sup() - i.inf(); };
  const auto longest = [&] {
    if (width(box.x) >= width(box.y) && width(box.x) >= width(box.z)) return &Vector3<Interval>::x;
    return width(box.y) >= width(box.z) ? &Vector3<Interval>::y : &Vector3<Interval>::z;
  }();
  const Interval& whole = box.*longest;
  const double middle = (whole.inf() + whole.sup()) / 2;
  Vector3<Interval> part = box;
  part.*longest = Interval(whole.inf(), middle);
  waiting.push_back(part);
  part.*longest = Interval(middle, whole.sup());
  waiting.push_back(part);
}

// Far more boxes than a loop takes that keeps its distance from the faces.
constexpr int kBoxes = 100000;

// Halves the boxes until all are away from the curve or, if it may be there, inside; nothing if
// that fails, and else whether the curve was met for certain.
std::optional<bool> meets_inside(const Curve& curve, std::vector<Vector3<Interval>> waiting,
                                 bool may_be_met) {
  bool met = false;
  for (int left = kBoxes; !waiting.empty(); --left) {
    if (left == 0) return std::nullopt;
    const Vector3<Interval> box = waiting.back();
    waiting.pop_back();
    const Place place = place_of(curve, box);
    if (place == Place::unknown || (place == Place::inside && !may_be_met)) {
      halve(box, waiting);
    } else if (place == Place::inside) {
      met = met || is_crossed(curve, box);
    }
  }
  return met;
}

}  // namespace

bool loop_is_inside(const std::array<Rational, 3>& values, const Rational& s,
                    const std::array<Tensor, 4>& vertices, int side) {
  Curve curve;
  curve.normal = enclosure(Tensor{values[0], values[1], values[2], 0, 0, 0});
  curve.weight = enclosing<Interval>(boundary_weight(s));
  curve.third_s2 = enclosing<Interval>(Rational(s * s / Rational(3)));
  const std::array<Tensor, 4> dual = dual_basis(vertices);
  for (std::size_t i = 0; i < 4; ++i) curve.dual[i] = enclosure(dual[i]);
  const auto between = meets_inside(curve, vectors_between(), false);
  const auto met = meets_inside(curve, vectors_of(side), true);
  return between && met && *met;
}

}  // namespace tensortopo::theory
