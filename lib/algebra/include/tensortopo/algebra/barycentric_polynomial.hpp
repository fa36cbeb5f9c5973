// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace tensortopo {

namespace detail {

constexpr std::size_t binomial(std::size_t n, std::size_t k) {
  std::size_t value = 1;
  for (std::size_t i = 1; i <= k; ++i) value = value * (n - k + i) / i;
  return value;
}

/// The exponents of all monomials of one degree, in a fixed (reverse lexicographic) order.
template <std::size_t Variables, std::size_t Degree>
constexpr auto monomial_exponents() {
  std::array<std::array<std::uint8_t, Variables>, binomial(Degree + Variables - 1, Variables - 1)>
      table{};
  std::array<std::uint8_t, Variables> current{};
  current[0] = Degree;
  for (std::size_t row = 0; row < table.size(); ++row) {
    table[row] = current;
    // Next composition: move one unit right from the last place that is not the final one.
    std::size_t place = Variables - 1;
    while (place > 0 && current[place - 1] == 0) --place;
    if (place == 0) break;
    const auto tail = current[Variables - 1];
    current[Variables - 1] = 0;
    --current[place - 1];
    current[place] = static_cast<std::uint8_t>(tail + 1);
  }
  return table;
}

/// The multinomial coefficients of all monomials: what a monomial coefficient has over the
/// Bernstein coefficient.
template <std::size_t Variables, std::size_t Degree>
constexpr auto multinomials() {
  const auto table = monomial_exponents<Variables, Degree>();
  std::array<double, table.size()> result{};
  for (std::size_t row = 0; row < table.size(); ++row) {
    std::size_t value = 1, used = 0;
    for (const auto e : table[row]) {
      used += e;
      value *= binomial(used, e);
    }
    result[row] = static_cast<double>(value);
  }
  return result;
}

template <std::size_t Variables, std::size_t Degree>
inline constexpr auto kMultinomials = multinomials<Variables, Degree>();

template <std::size_t Variables, std::size_t Degree>
inline constexpr auto kExponents = monomial_exponents<Variables, Degree>();

template <std::size_t Variables, std::size_t Degree>
constexpr std::size_t monomial_index(const std::array<std::uint8_t, Variables>& exponents) {
  const auto& table = kExponents<Variables, Degree>;
  for (std::size_t row = 0; row < table.size(); ++row)
    if (table[row] == exponents) return row;
  return table.size();
}

/// Row i, column j: the index of the product of monomial i of degree D1 and j of degree D2.
template <std::size_t Variables, std::size_t D1, std::size_t D2>
constexpr auto product_indices() {
  constexpr auto n1 = kExponents<Variables, D1>.size(), n2 = kExponents<Variables, D2>.size();
  std::array<std::array<std::uint8_t, n2>, n1> table{};
  for (std::size_t i = 0; i < n1; ++i)
    for (std::size_t j = 0; j < n2; ++j) {
      std::array<std::uint8_t, Variables> sum{};
      for (std::size_t v = 0; v < Variables; ++v)
        sum[v] = static_cast<std::uint8_t>(kExponents<Variables, D1>[i][v] +
                                           kExponents<Variables, D2>[j][v]);
      table[i][j] = static_cast<std::uint8_t>(monomial_index<Variables, D1 + D2>(sum));
    }
  return table;
}

template <std::size_t Variables, std::size_t D1, std::size_t D2>
inline constexpr auto kProduct = product_indices<Variables, D1, D2>();

/// The same by result: coefficient k sums the products of monomials first[t] and second[t], from
/// t = start[k] up to start[k + 1].
template <std::size_t Variables, std::size_t D1, std::size_t D2>
constexpr auto product_terms() {
  constexpr auto n1 = kExponents<Variables, D1>.size(), n2 = kExponents<Variables, D2>.size();
  constexpr auto n = kExponents<Variables, D1 + D2>.size();
  struct {
    std::array<std::uint8_t, n1 * n2> first{}, second{};
    std::array<std::size_t, n + 1> start{};
  } terms;
  std::size_t t = 0;
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t i = 0; i < n1; ++i)
      for (std::size_t j = 0; j < n2; ++j)
        if (kProduct<Variables, D1, D2>[i][j] == k) {
          terms.first[t] = static_cast<std::uint8_t>(i);
          terms.second[t++] = static_cast<std::uint8_t>(j);
        }
    terms.start[k + 1] = t;
  }
  return terms;
}

template <std::size_t Variables, std::size_t D1, std::size_t D2>
inline constexpr auto kTerms = product_terms<Variables, D1, D2>();

/// Coefficient k of a product, without a loop.
template <std::size_t Variables, std::size_t D1, std::size_t D2, std::size_t k, class P, class Q>
constexpr auto product_coefficient(const P& p, const Q& q) {
  constexpr const auto& terms = kTerms<Variables, D1, D2>;
  constexpr std::size_t start = terms.start[k];
  return [&]<std::size_t... t>(std::index_sequence<t...>) {
    typename P::value_type sum(0);
    ((sum = sum + p[terms.first[start + t]] * q[terms.second[start + t]]), ...);
    return sum;
  }(std::make_index_sequence<terms.start[k + 1] - start>{});
}

}  // namespace detail

/// A homogeneous polynomial in the barycentric coordinates of a simplex.
///
/// Its monomial coefficients are the Bernstein coefficients times multinomials, which are
/// positive: if all of them share a strict sign, so does the polynomial on the whole simplex.
/// Products are plain convolutions.
template <class Scalar, std::size_t Variables, std::size_t Degree>
struct BarycentricPolynomial {
  /// Number of coefficients.
  static constexpr std::size_t size = detail::binomial(Degree + Variables - 1, Variables - 1);
  /// The exponents of each coefficient's monomial, in the order of `coefficients`.
  static constexpr const auto& exponents = detail::kExponents<Variables, Degree>;
  /// Coefficient i is this many times the Bernstein coefficient.
  static constexpr const auto& multinomials = detail::kMultinomials<Variables, Degree>;

  /// One for each monomial, in the order of `exponents`.
  std::array<Scalar, size> coefficients{};

  /// The sum, exactly if the scalar's sums are.
  friend BarycentricPolynomial operator+(const BarycentricPolynomial& p,
                                         const BarycentricPolynomial& q) {
    BarycentricPolynomial sum;
    for (std::size_t i = 0; i < size; ++i)
      sum.coefficients[i] = p.coefficients[i] + q.coefficients[i];
    return sum;
  }
  /// The difference.
  friend BarycentricPolynomial operator-(const BarycentricPolynomial& p,
                                         const BarycentricPolynomial& q) {
    BarycentricPolynomial difference;
    for (std::size_t i = 0; i < size; ++i)
      difference.coefficients[i] = p.coefficients[i] - q.coefficients[i];
    return difference;
  }
  /// The multiple.
  friend BarycentricPolynomial operator*(const Scalar& k, const BarycentricPolynomial& p) {
    BarycentricPolynomial product;
    for (std::size_t i = 0; i < size; ++i) product.coefficients[i] = k * p.coefficients[i];
    return product;
  }
};

template <class Scalar, std::size_t Variables, std::size_t D1, std::size_t D2>
BarycentricPolynomial<Scalar, Variables, D1 + D2> operator*(
    const BarycentricPolynomial<Scalar, Variables, D1>& p,
    const BarycentricPolynomial<Scalar, Variables, D2>& q) {
  BarycentricPolynomial<Scalar, Variables, D1 + D2> product;
  constexpr std::size_t terms = BarycentricPolynomial<Scalar, Variables, D1>::size *
                                BarycentricPolynomial<Scalar, Variables, D2>::size;
  // Few terms of a small number: each sum in a register. The order of the terms is the same.
  if constexpr (std::is_trivially_copyable_v<Scalar> && terms <= 64) {
    [&]<std::size_t... k>(std::index_sequence<k...>) {
      ((product.coefficients[k] =
            detail::product_coefficient<Variables, D1, D2, k>(p.coefficients, q.coefficients)),
       ...);
    }(std::make_index_sequence<product.size>{});
    return product;
  }
  for (auto& c : product.coefficients) c = Scalar(0);
  const auto& index = detail::kProduct<Variables, D1, D2>;
  for (std::size_t i = 0; i < p.size; ++i)
    for (std::size_t j = 0; j < q.size; ++j) {
      auto& c = product.coefficients[index[i][j]];
      c = c + p.coefficients[i] * q.coefficients[j];
    }
  return product;
}

/// Derivative along the barycentric direction `d` (whose entries usually sum to zero).
template <class Scalar, std::size_t Variables, std::size_t Degree>
  requires(Degree >= 1)
BarycentricPolynomial<Scalar, Variables, Degree - 1> derivative(
    const BarycentricPolynomial<Scalar, Variables, Degree>& p,
    const std::array<Scalar, Variables>& d) {
  // The same table as a product with one variable, read backwards: x_v times monomial i of the
  // derivative is monomial k of p, and contributes its exponent of x_v.
  BarycentricPolynomial<Scalar, Variables, Degree - 1> result;
  const auto& index = detail::kProduct<Variables, Degree - 1, 1>;
  for (std::size_t i = 0; i < result.size; ++i) {
    Scalar sum(0);
    for (std::size_t v = 0; v < Variables; ++v) {
      const auto k = index[i][v];
      sum = sum + Scalar(int{p.exponents[k][v]}) * d[v] * p.coefficients[k];
    }
    result.coefficients[i] = sum;
  }
  return result;
}

/// Value at barycentric coordinates.
template <class Scalar, std::size_t Variables, std::size_t Degree>
Scalar evaluate(const BarycentricPolynomial<Scalar, Variables, Degree>& p,
                const std::array<Scalar, Variables>& at) {
  Scalar sum(0);
  for (std::size_t i = 0; i < p.size; ++i) {
    Scalar term = p.coefficients[i];
    for (std::size_t v = 0; v < Variables; ++v)
      for (int e = 0; e < p.exponents[i][v]; ++e) term = term * at[v];
    sum = sum + term;
  }
  return sum;
}

}  // namespace tensortopo
