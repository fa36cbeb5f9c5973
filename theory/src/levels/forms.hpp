// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "levels/mode_level.hpp"
#include "tensortopo/algebra/barycentric_polynomial.hpp"

namespace tensortopo::theory {

/// A polynomial in the weights of a simplex, with error bounds on its coefficients.
template <std::size_t Vertices, std::size_t Degree>
using Form = BarycentricPolynomial<Bounded<double>, Vertices, Degree>;

/// One entry of a linear field on a simplex.
template <std::size_t N>
Form<N, 1> linear_form(const std::array<BoundedDeviator, N>& tensors,
                       Bounded<double> BoundedDeviator::*entry) {
  Form<N, 1> form;
  for (std::size_t i = 0; i < N; ++i) form.coefficients[i] = tensors[i].*entry;
  return form;
}

/// The sign of all coefficients, which is that of the form on the whole simplex; unknown if they
/// have no strict one in common.
template <std::size_t N, std::size_t Degree>
Verdict strict_sign(const Form<N, Degree>& form) {
  const Verdict first = certified_sign(form.coefficients[0]);
  if (first != Verdict::positive && first != Verdict::negative) return Verdict::unknown;
  const bool is_common =
      std::all_of(form.coefficients.begin(), form.coefficients.end(),
                  [&](const Bounded<double>& c) { return certified_sign(c) == first; });
  return is_common ? first : Verdict::unknown;
}

}  // namespace tensortopo::theory
