// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "tensors.hpp"
#include "tensortopo/scalar/interval.hpp"

namespace tensortopo::theory {

/// One of the two loops of the complex domain's boundary for mu < mu0, with enclosures of what its
/// weights in a tetrahedron are made of.
struct BoundaryLoop {
  std::array<Interval, 3> l;  ///< characteristic eigenvalues, descending
  Interval s, low, high;      ///< the mode's parameter; the ends of the interval of alpha = v.N v
  int side;                   ///< the sign of x z
  std::array<SymmetricTensor<Interval>, 4> dual;
};

/// Whether the boundary has two loops: mu < mu0 and a negative characteristic determinant.
bool has_two_loops(const std::array<Rational, 3>& values, const Rational& s);

/// Requires `has_two_loops`, and vertices as `mode_of_loop_inside` does.
BoundaryLoop boundary_loop(const std::array<Rational, 3>& values, const Rational& s,
                           const std::array<Tensor, 4>& vertices, int side);

/// The squares of the coordinates of the loop's vector of a given alpha (the step squares-factors).
/// Number: of intervals, with +, - and *.
template <class Number>
std::array<Number, 3> squares_at(const BoundaryLoop& loop, const Number& alpha) {
  const Interval one(1), two(2), three(3), four(4);
  const auto& l = loop.l;
  const Interval half = (l[0] * l[0] + l[1] * l[1] + l[2] * l[2]) / two;
  std::array<Number, 3> m;
  for (std::size_t i = 0; i < 3; ++i)
    m[i] = Number(one / (four * (three * l[i] * l[i] - half))) *
           ((Number(one - loop.s) * alpha + Number(two * l[i])) *
            (Number(one + loop.s) * alpha + Number(two * l[i])));
  return m;
}

/// The weights in the tetrahedron of the tensor on the boundary at v, whose squares are m, up to a
/// positive factor; of the opposite of the tensor of mode mu (the step tensor-on-boundary).
template <class Number>
std::array<Number, 4> weights_of(const BoundaryLoop& loop, const Number& alpha,
                                 const std::array<Number, 3>& m, const std::array<Number, 3>& v) {
  const Interval one(1), two(2), three(3), &s = loop.s;
  const auto& l = loop.l;
  const Number plane = Number((one + s * s / three) / two) * alpha,
               along = Number(s * s / three) * alpha;
  // The eigenvalue of the third axis and cos^2(theta) alpha / 2.
  const Number turn = Number((one - s * s) / two) * alpha;
  std::array<Number, 3> diagonal, across;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    diagonal[i] = Number(l[i]) + plane + m[i] * (alpha - Number(two * l[i]) - plane - along);
    across[i] = v[i] * v[j] * (Number(l[k]) + turn);
  }
  std::array<Number, 4> weights;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& d = loop.dual[i];
    weights[i] =
        Number(d.xx) * diagonal[0] + Number(d.yy) * diagonal[1] + Number(d.zz) * diagonal[2] +
        Number(two) *
            (Number(d.xy) * across[0] + Number(d.yz) * across[1] + Number(d.xz) * across[2]);
  }
  return weights;
}

}  // namespace tensortopo::theory
