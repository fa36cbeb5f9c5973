// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <optional>

#include "extract/curves/arcs/arc_polynomial.hpp"
#include "extract/curves/points/degenerate_forms.hpp"
#include "extract/curves/points/enclosures.hpp"

namespace tensortopo {

/// An arc of the conic e.N e = 0: the directions sum_k e_k t^k (1 - t)^(2 - k), 0 <= t <= 1.
template <class E>
using ConicArc = std::array<Vector3<E>, 3>;

/// One of the two arcs of a conic between two of its points; the other one has the opposite middle
/// coefficient.
///
/// With N of negative determinant, b and c on one side of the cone (b.N c < 0) and the pole
/// m = N b x N c of their line: b.N m = c.N m = 0 and m.N m = -det N (b.N c)^2. So
/// e = l (1 - t)^2 b + r t (1 - t) m + r^2 t^2 c is on the conic if l = det N (b.N c) / 2. It is
/// there for all numbers of the enclosures, so the exact arc is enclosed. r is any number that is
/// not 0.
/// @param form  N, up to its sign
/// @return nothing if a sign is not certain
template <class E>
std::optional<ConicArc<E>> conic_arc(SymmetricTensor<E> form, const Vector3<E>& begin,
                                     Vector3<E> end) {
  E size = determinant(form);
  const Verdict sign = sign_in(size);
  if (!is_strict(sign)) return std::nullopt;
  if (sign == Verdict::positive) {
    form = E(-1.0) * form;
    size = -size;
  }
  E product = polar(form, begin, end);
  const Verdict side = sign_in(product);
  if (!is_strict(side)) return std::nullopt;
  if (side == Verdict::positive) {
    end = -end;
    product = -product;
  }
  const E first = E(0.5) * (size * product);
  // Both ends have about the same factor; not quite, so that the middle of a symmetric arc is not
  // at a dyadic parameter.
  const double middle = EnclosureOf<E>::middle(first);
  const E r(0.9375 * std::sqrt(middle > 0 ? middle : 1.0));
  return ConicArc<E>{first * begin, r * cross(form * begin, form * end), (r * r) * end};
}

/// A quadratic form along an arc.
template <class E>
std::array<E, 5> form_along(const SymmetricTensor<E>& form, const ConicArc<E>& arc) {
  return convolved(arc, arc,
                   [&](const Vector3<E>& x, const Vector3<E>& y) { return polar(form, x, y); });
}

}  // namespace tensortopo
