// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "interval_tensors.hpp"
#include "tensortopo/field/characteristic_tensor.hpp"

/// \file
/// Lines of tensors in intervals, for what is critical on edges and, by the tensors orthogonal to
/// them, on faces. Everything here relies on `UpwardRounding` being in force.

namespace tensortopo::detail {

/// A polynomial of degree 4 or less.
using Polynomial = std::array<Range, 5>;

inline Polynomial times(const Polynomial& p, const Polynomial& q) {
  Polynomial product;
  for (auto& c : product) c = Range(0);
  for (std::size_t i = 0; i < 5; ++i)
    for (std::size_t j = 0; i + j < 5; ++j) product[i + j] += p[i] * q[j];
  return product;
}

inline Polynomial minus(Polynomial p, const Polynomial& q) {
  for (std::size_t i = 0; i < 5; ++i) p[i] -= q[i];
  return p;
}

inline Polynomial derivative(const Polynomial& p) {
  return {p[1], Range(2) * p[2], Range(3) * p[3], Range(4) * p[4], Range(0)};
}

inline Range horner(const Polynomial& p, const Range& x) {
  return p[0] + x * (p[1] + x * (p[2] + x * (p[3] + x * p[4])));
}

/// A polynomial over a part of its domain, by the mean value theorem.
inline Range range_of(const Polynomial& p, const Range& x) {
  const Range m(middle(x));
  return horner(p, m) + horner(derivative(p), x) * (x - m);
}

/// The tensors A + x B of a line, and the forms that depend on x.
struct Line {
  Line(const IntervalTensor& a, const IntervalTensor& b) : m(thrice(a)), k(thrice(b)) {
    const Range zero(0), two(2);
    const auto mm = square(m), kk = square(k);
    const auto mixed = square(m + k) - mm - kk;
    squares = {mm, mixed, kk};
    norm = {norm_form(a), two * norm_form(a, b), norm_form(b), zero, zero};
    determinant = {tensortopo::determinant(m), inner(mm, k), inner(kk, m),
                   tensortopo::determinant(k), zero};
  }

  /// <M, T> and <M^2, T> for M three times the tensor and a traceless T.
  Polynomial linear(const SymmetricTensor<Range>& t) const {
    return {inner(m, t), inner(k, t), Range(0), Range(0), Range(0)};
  }
  Polynomial quadratic(const SymmetricTensor<Range>& t) const {
    return {inner(squares[0], t), inner(squares[1], t), inner(squares[2], t), Range(0), Range(0)};
  }

  /// The binary cubic that vanishes at the N to which a critical tensor
  /// G = N^2 - (|N|^2 / 3) I - (tr N^3 / |N|^2) N of the space across the line belongs.
  Polynomial critical_cubic() const {
    return minus(times(quadratic(m), linear(k)), times(quadratic(k), linear(m)));
  }
  /// <G, T>, up to a positive factor: the weight of a vertex whose dual is T.
  Polynomial critical_weight(const SymmetricTensor<Range>& t) const {
    return minus(times(norm, quadratic(t)), times(determinant, linear(t)));
  }

  SymmetricTensor<Range> m, k;
  std::array<SymmetricTensor<Range>, 3> squares;
  Polynomial norm, determinant;  ///< P and Q
};

/// Two tensors about orthogonal to three and to each other, as exact numbers.
inline std::array<IntervalTensor, 2> orthogonal_pair(const std::array<IntervalTensor, 3>& t) {
  const std::array<Deviator<double>, 3> own{middle(t[0]), middle(t[1]), middle(t[2])};
  const auto cross_product = [](const std::array<Deviator<double>, 4>& four) {
    return characteristic_direction(TetrahedronField<double>{four});
  };
  Deviator<double> first{};
  double longest = -1;
  for (const Deviator<double>& axis :
       {Deviator<double>{1, 0, 0, 0, 0}, Deviator<double>{0, 1, 0, 0, 0},
        Deviator<double>{0, 0, 1, 0, 0}, Deviator<double>{0, 0, 0, 1, 0},
        Deviator<double>{0, 0, 0, 0, 1}}) {
    const auto candidate = cross_product({own[0], own[1], own[2], axis});
    if (const double length = norm_form(candidate); length > longest)
      longest = length, first = candidate;
  }
  const auto second = cross_product({own[0], own[1], own[2], first});
  return {normalized(point(first)), normalized(point(second))};
}

}  // namespace tensortopo::detail
