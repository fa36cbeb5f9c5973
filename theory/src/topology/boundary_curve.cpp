// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "topology/boundary_curve.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "tensortopo/theory/arithmetic.hpp"
#include "topology/boundary_weights.hpp"

namespace tensortopo::theory {
namespace {

// Of a number that is not negative.
Interval root(const Interval& x) {
  return CGAL::sqrt(Interval(std::max(x.inf(), 0.0), std::max(x.sup(), 0.0)));
}

// Signs of the weights of the tensor that belongs to alpha, with y of the sign given. As computed
// it is a negative multiple of that of mode mu.
struct Signs {
  int positive = 0, negative = 0;
};

Signs weights_at(const BoundaryLoop& loop, const Interval& alpha, int sign_y) {
  const std::array<Interval, 3> m = squares_at(loop, alpha);
  const std::array<Interval, 3> v = {root(m[0]), Interval(sign_y) * root(m[1]),
                                     Interval(loop.side) * root(m[2])};
  Signs signs;
  for (const Interval& weight : weights_of(loop, alpha, m, v)) {
    const Verdict sign = certified_sign(weight);
    signs.positive += sign == Verdict::positive ? 1 : 0;
    signs.negative += sign == Verdict::negative ? 1 : 0;
  }
  return signs;
}

// Far more parts than a loop takes that keeps its distance from the faces.
constexpr int kMostSteps = 20000;

// Whether all of the loop's tensors have weights of the signs wanted.
template <class IsWanted>
bool is_everywhere(const BoundaryLoop& loop, const IsWanted& is_wanted) {
  for (const int sign_y : {1, -1}) {
    std::vector<Interval> waiting = {Interval(loop.low.inf(), loop.high.sup())};
    for (int left = kMostSteps; !waiting.empty(); --left) {
      if (left == 0) return false;
      const Interval alpha = waiting.back();
      waiting.pop_back();
      const Signs signs = weights_at(loop, alpha, sign_y);
      if (is_wanted(signs)) continue;
      // All weights decided, and otherwise than wanted.
      if (signs.positive + signs.negative == 4) return false;
      const double middle = (alpha.inf() + alpha.sup()) / 2;
      waiting.emplace_back(alpha.inf(), middle);
      waiting.emplace_back(middle, alpha.sup());
    }
  }
  return true;
}

}  // namespace

bool has_two_loops(const std::array<Rational, 3>& l, const Rational& s) {
  return s > 0 && s * (l[0] + l[1]) < l[0] - l[1] && l[1] > 0;
}

BoundaryLoop boundary_loop(const std::array<Rational, 3>& values, const Rational& s,
                           const std::array<Tensor, 4>& vertices, int side) {
  BoundaryLoop loop;
  for (std::size_t i = 0; i < 3; ++i) loop.l[i] = enclosing<Interval>(values[i]);
  loop.s = enclosing<Interval>(s);
  const Rational medium = Rational(-2) * values[1], one(1);
  loop.low = enclosing<Interval>(Rational(medium / (one - s)));
  loop.high = enclosing<Interval>(Rational(medium / (one + s)));
  loop.side = side;
  const std::array<Tensor, 4> dual = dual_basis(vertices);
  for (std::size_t i = 0; i < 4; ++i) {
    const Tensor& d = dual[i];
    loop.dual[i] = {enclosing<Interval>(d.xx), enclosing<Interval>(d.yy),
                    enclosing<Interval>(d.zz), enclosing<Interval>(d.xy),
                    enclosing<Interval>(d.yz), enclosing<Interval>(d.xz)};
  }
  return loop;
}

std::array<Tensor, 4> dual_basis(const std::array<Tensor, 4>& vertices) {
  // By inversion of the matrix of inner products.
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

int mode_of_loop_inside(const std::array<Rational, 3>& values, const Rational& s,
                        const std::array<Tensor, 4>& vertices, int side) {
  if (!has_two_loops(values, s)) return 0;
  const BoundaryLoop loop = boundary_loop(values, s, vertices, side);
  if (is_everywhere(loop, [](const Signs& signs) { return signs.negative == 4; })) return 1;
  const auto all_positive = [](const Signs& signs) { return signs.positive == 4; };
  return is_everywhere(loop, all_positive) ? -1 : 0;
}

bool loop_is_outside(const std::array<Rational, 3>& values, const Rational& s,
                     const std::array<Tensor, 4>& vertices, int side) {
  if (!has_two_loops(values, s)) return false;
  return is_everywhere(boundary_loop(values, s, vertices, side),
                       [](const Signs& signs) { return signs.positive > 0 && signs.negative > 0; });
}

}  // namespace tensortopo::theory
