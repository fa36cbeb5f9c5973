// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/extract/exact_weights.hpp"

#include <algorithm>
#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

namespace tensortopo {

namespace {

/// Sums of two such numbers stay below 2^63, and what is kept is a double.
constexpr int kBits = 52;
constexpr int kBitsOnTheWay = 61;

}  // namespace

template <std::size_t Vertices>
ExactWeights<Vertices> ExactWeights<Vertices>::at_corner(std::size_t corner) {
  ExactWeights result;
  result.digits_[corner] = 1;
  return result;
}

template <std::size_t Vertices>
std::optional<ExactWeights<Vertices>> ExactWeights<Vertices>::combination(int a,
                                                                          const ExactWeights& u,
                                                                          int b,
                                                                          const ExactWeights& v) {
  ExactWeights sum;
  sum.exponent_ = std::min(u.exponent_, v.exponent_);
  std::uint64_t all = 0;
  for (std::size_t i = 0; i < Vertices; ++i) {
    for (const auto& [factor, w] : {std::pair{a, &u}, std::pair{b, &v}}) {
      const auto term = static_cast<std::uint64_t>(w->digits_[i]) * static_cast<unsigned>(factor);
      const int shift = w->exponent_ - sum.exponent_;
      if (term != 0 && static_cast<int>(std::bit_width(term)) + shift > kBitsOnTheWay)
        return std::nullopt;
      if (term != 0) sum.digits_[i] += static_cast<std::int64_t>(term << shift);
    }
    all |= static_cast<std::uint64_t>(sum.digits_[i]);
  }
  const int spare = std::countr_zero(all);
  if (static_cast<int>(std::bit_width(all)) - spare > kBits) return std::nullopt;
  for (auto& d : sum.digits_) d >>= spare;
  sum.exponent_ += spare;
  return sum;
}

template <std::size_t Vertices>
ExactWeights<Vertices> ExactWeights<Vertices>::scaled(int e) const {
  ExactWeights result = *this;
  result.exponent_ += e;
  return result;
}

template <std::size_t Vertices>
std::array<double, Vertices> ExactWeights<Vertices>::values() const {
  std::array<double, Vertices> result;
  for (std::size_t i = 0; i < Vertices; ++i)
    result[i] = std::ldexp(static_cast<double>(digits_[i]), exponent_);
  return result;
}

template <std::size_t Vertices>
bool ExactWeights<Vertices>::comes_before(const ExactWeights& other, std::size_t from,
                                          std::size_t to) const {
  using Wide = boost::multiprecision::int128_t;
  return Wide(digits_[to]) * other.digits_[from] < Wide(other.digits_[to]) * digits_[from];
}

template class ExactWeights<3>;
template class ExactWeights<4>;

}  // namespace tensortopo
