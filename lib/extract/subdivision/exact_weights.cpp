// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/subdivision/exact_weights.hpp"

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

namespace tensortopo {

namespace {

using Whole = boost::multiprecision::uint128_t;

/// What is kept is the sum of two doubles, of 53 bits each.
constexpr int kBits = 104;
/// Sums of four such numbers stay below 2^128.
constexpr int kBitsOnTheWay = 126;

Whole joined(std::uint64_t high, std::uint64_t low) { return Whole(high) << 64 | low; }

std::uint64_t low_half(const Whole& n) {
  return static_cast<std::uint64_t>(Whole(n & ~std::uint64_t{0}));
}
std::uint64_t high_half(const Whole& n) { return static_cast<std::uint64_t>(Whole(n >> 64)); }

int width_of(const Whole& n) { return n == 0 ? 0 : static_cast<int>(msb(n)) + 1; }

}  // namespace

template <std::size_t Vertices>
ExactWeights<Vertices> ExactWeights<Vertices>::at_corner(std::size_t corner) {
  ExactWeights result;
  result.digits_[corner].low = 1;
  return result;
}

template <std::size_t Vertices>
std::optional<ExactWeights<Vertices>> ExactWeights<Vertices>::combination(
    std::span<const std::int64_t> factors, std::span<const ExactWeights> places) {
  ExactWeights result;
  int exponent = places[0].exponent_;
  for (const auto& w : places) exponent = std::min(exponent, w.exponent_);
  std::array<Whole, Vertices> sums{};
  Whole all = 0;
  for (std::size_t i = 0; i < Vertices; ++i) {
    for (std::size_t k = 0; k < places.size(); ++k) {
      const auto& w = places[k];
      const Whole digits = joined(w.digits_[i].high, w.digits_[i].low);
      const Whole share = static_cast<std::uint64_t>(factors[k]);
      if (digits == 0 || share == 0) continue;
      const int shift = w.exponent_ - exponent;
      if (width_of(digits) + width_of(share) + shift > kBitsOnTheWay) return std::nullopt;
      sums[i] += digits * share << shift;
    }
    all |= sums[i];
  }
  const int spare = all == 0 ? 0 : static_cast<int>(lsb(all));
  if (width_of(all) - spare > kBits) return std::nullopt;
  for (std::size_t i = 0; i < Vertices; ++i) {
    sums[i] >>= spare;
    result.digits_[i] = {high_half(sums[i]), low_half(sums[i])};
  }
  result.exponent_ = exponent + spare;
  return result;
}

template <std::size_t Vertices>
ExactWeights<Vertices> ExactWeights<Vertices>::scaled(int e) const {
  ExactWeights result = *this;
  result.exponent_ += e;
  return result;
}

template <std::size_t Vertices>
ExactPlace<Vertices> ExactWeights<Vertices>::values() const {
  ExactPlace<Vertices> place;
  for (std::size_t i = 0; i < Vertices; ++i) {
    const Whole digits = joined(digits_[i].high, digits_[i].low);
    const auto high = static_cast<double>(digits);
    const Whole back(high);
    const double low = back > digits ? -static_cast<double>(Whole(back - digits))
                                     : static_cast<double>(Whole(digits - back));
    place.high[i] = std::ldexp(high, exponent_);
    place.low[i] = std::ldexp(low, exponent_);
  }
  return place;
}

template <std::size_t Vertices>
bool ExactWeights<Vertices>::comes_before(const ExactWeights& other, std::size_t from,
                                          std::size_t to) const {
  using Wide = boost::multiprecision::uint256_t;
  const auto at = [](const ExactWeights& w, std::size_t i) {
    return Wide(joined(w.digits_[i].high, w.digits_[i].low));
  };
  return at(*this, to) * at(other, from) < at(other, to) * at(*this, from);
}

template class ExactWeights<2>;
template class ExactWeights<3>;
template class ExactWeights<4>;

}  // namespace tensortopo
