// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "critical_parts.hpp"
#include "tensortopo/field/exact_critical_points.hpp"
#include "tensortopo/scalar/sign.hpp"

namespace tensortopo {
namespace {

using namespace detail;
using Tensor = IntervalTensor;

/// What is critical in a tetrahedron: G, made of the characteristic tensor N, or -G.
struct Saddle {
  Tensor g;
  Range p, q;                               ///< of N
  std::array<Range, 4> weights;             ///< of G in normalized vertex tensors
  bool positive = false, negative = false;  ///< all weights are
  bool some_positive = false, some_negative = false;

  void set_signs() {
    int up = 0, down = 0;
    for (const Range& w : weights) up += w.inf() > 0, down += w.sup() < 0;
    positive = up == 4, negative = down == 4, some_positive = up > 0, some_negative = down > 0;
  }
  bool is_outside() const { return some_positive && some_negative; }
  bool is_inside() const { return positive || negative; }
};

Saddle saddle_in_intervals(const std::array<Tensor, 4>& corners) {
  Saddle saddle;
  const Tensor n = orthogonal_to(spread_out(corners));
  saddle.p = norm_form(n), saddle.q = determinant_form(n);
  saddle.g = normalized(critical_tensor(thrice(n), saddle.p, saddle.q));
  for (std::size_t i = 0; i < 4; ++i) {
    const Tensor dual = dual_tensor(corners, i, n);
    saddle.weights[i] = norm_form(saddle.g, dual) / norm_form(corners[i], dual);
  }
  saddle.set_signs();
  return saddle;
}

/// The same in rationals.
struct ExactSaddle {
  /// @pre the tensors are independent
  explicit ExactSaddle(const std::array<SymmetricTensor<double>, 4>& given) {
    for (std::size_t i = 0; i < 4; ++i) field.vertex[i] = deviator(tensor_cast<Rational>(given[i]));
    const auto n = normalized(characteristic_direction(field));
    p = norm_form(n), q = determinant_form(n);
    g = normalized(critical_tensor(thrice(n), p, q));
    for (std::size_t i = 0; i < 4; ++i) {
      TetrahedronField<Rational> others = field;
      others.vertex[i] = n;
      const auto dual = characteristic_direction(others);
      weights[i] = norm_form(g, dual) / norm_form(field.vertex[i], dual);
    }
  }

  Saddle enclosure(const std::array<Tensor, 4>& corners) const {
    using detail::enclosure;
    Saddle saddle;
    saddle.p = enclosure(p), saddle.q = enclosure(q);
    saddle.g = enclosure(g);
    for (std::size_t i = 0; i < 4; ++i) {
      // Normalized tensors differ from those given by powers of two.
      const Range scale =
          root_of(norm_form(corners[i])) / root_of(enclosure(Rational(norm_form(field.vertex[i]))));
      saddle.weights[i] = enclosure(weights[i]) / scale;
    }
    saddle.set_signs();
    return saddle;
  }

  TetrahedronField<Rational> field;
  Deviator<Rational> g;
  Rational p, q;
  std::array<Rational, 4> weights;  ///< of G in the vertex tensors given
};

/// The mode at G or -G, by its sign. G itself has mode <= 0, and -G mode >= 0.
CriticalPoint point_of(const Saddle& saddle, const std::array<SymmetricTensor<double>, 4>& tensors,
                       const std::array<Tensor, 4>& corners, int sign) {
  CriticalPoint point;
  std::array<double, 4> about{};
  for (std::size_t i = 0; i < 4; ++i) about[i] = std::abs(middle(saddle.weights[i]));
  set_weights(point, about, tensors, corners);
  const Range p = saddle.p;
  if (p.inf() > 0)
    narrow_by_gap(point, Range(2) * CGAL::square(saddle.q) / (p * p * p), Range(sign));
  return point;
}

/// The determinant of the second derivatives at a critical point.
template <class Scalar>
Scalar second_determinant(const Derivatives<Scalar>& d,
                          const std::array<Deviator<Scalar>, 4>& corners) {
  const std::array<Deviator<Scalar>, 3> u{corners[1] - corners[0], corners[2] - corners[0],
                                          corners[3] - corners[0]};
  const Scalar xx = d.second(u[0], u[0]), yy = d.second(u[1], u[1]), zz = d.second(u[2], u[2]),
               xy = d.second(u[0], u[1]), yz = d.second(u[1], u[2]), xz = d.second(u[0], u[2]);
  return xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
}

}  // namespace

std::vector<CriticalPoint> critical_points_in_tet(
    const std::array<SymmetricTensor<double>, 4>& tensors) {
  const UpwardRounding upward;
  const auto corners = enclosures(tensors);
  auto saddle = saddle_in_intervals(corners);
  if (saddle.is_outside()) return {};
  if (!saddle.is_inside()) {
    if (!are_independent(tensors)) return {};
    saddle = ExactSaddle(tensors).enclosure(corners);
    if (saddle.is_outside()) return {};
  }
  if (!saddle.is_inside()) {
    // On the boundary, or too close to it to tell, and of either sign if all weights are.
    std::vector<CriticalPoint> points;
    if (!saddle.some_negative) points.push_back(point_of(saddle, tensors, corners, -1));
    if (!saddle.some_positive) points.push_back(point_of(saddle, tensors, corners, 1));
    return points;
  }
  const int sign = saddle.positive ? -1 : 1;
  CriticalPoint point = point_of(saddle, tensors, corners, sign);
  const Tensor t = Range(-sign) * saddle.g;
  enclose_mode(point, t);
  point.deviator = box_of(t);
  const Range det = second_determinant(Derivatives<Range>(t), corners);
  // It is a saddle: the mode falls in one direction or in two.
  point.is_certain = is_not_zero(det);
  point.index = det.sup() < 0 ? 1 : 2;
  return {point};
}

std::vector<CriticalPoint> exact_critical_points_in_tet(
    const std::array<SymmetricTensor<double>, 4>& tensors) {
  const UpwardRounding upward;
  if (!are_independent(tensors)) return {};
  const ExactSaddle exact(tensors);
  if (exact.g == Deviator<Rational>{}) return critical_points_in_tet(tensors);
  const auto are_all = [&](Sign sign) {
    return std::all_of(exact.weights.begin(), exact.weights.end(),
                       [&](const Rational& w) { return sign_of(w) == sign; });
  };
  if (!are_all(Sign::positive) && !are_all(Sign::negative)) return {};
  const int sign = are_all(Sign::positive) ? -1 : 1;
  const auto corners = enclosures(tensors);
  const Saddle saddle = exact.enclosure(corners);
  CriticalPoint point = point_of(saddle, tensors, corners, sign);
  const Tensor t = Range(-sign) * saddle.g;
  enclose_mode(point, t);
  point.deviator = box_of(t);
  const Rational det =
      second_determinant(Derivatives<Rational>(Rational(-sign) * exact.g), exact.field.vertex);
  point.is_certain = det != 0;
  point.index = det < 0 ? 1 : 2;
  return {point};
}

}  // namespace tensortopo
