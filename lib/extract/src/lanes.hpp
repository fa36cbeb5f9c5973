// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>

#ifndef __GNUC__
#error "lanes.hpp wants the vector extensions of GCC and Clang"
#endif

// No vector is passed between functions that are not inlined.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace tensortopo {

/// Four doubles side by side, each of another simplex, with the arithmetic of a scalar: a formula
/// that is a template over its scalar takes every lane through the operations that a double would
/// go through, in their order, so each lane gets the same bits. Nothing branches on a lane: a
/// comparison is a `Mask`, which `select` turns into a choice.
///
/// Whoever uses them is compiled twice, for any processor (two pairs) and for AVX2, so all that
/// lies in between has to be inlined (`gnu::flatten`): vectors have no calling convention in common.
struct Lanes {
  static constexpr std::size_t count = 4;
  using Vector = double __attribute__((vector_size(32)));
  using Mask = long long __attribute__((vector_size(32)));  ///< of a lane: -1 (true) or 0

  Vector v;

  Lanes() = default;
  [[gnu::always_inline]] explicit Lanes(double x) : v{x, x, x, x} {}
  [[gnu::always_inline]] explicit Lanes(int x) : Lanes(static_cast<double>(x)) {}
  [[gnu::always_inline]] explicit Lanes(const Vector& w) : v(w) {}

  [[gnu::always_inline]] double operator[](std::size_t lane) const { return v[lane]; }

  [[gnu::always_inline]] friend Lanes operator+(const Lanes& x, const Lanes& y) {
    return Lanes(x.v + y.v);
  }
  [[gnu::always_inline]] friend Lanes operator-(const Lanes& x, const Lanes& y) {
    return Lanes(x.v - y.v);
  }
  [[gnu::always_inline]] friend Lanes operator*(const Lanes& x, const Lanes& y) {
    return Lanes(x.v * y.v);
  }
  [[gnu::always_inline]] friend Lanes operator/(const Lanes& x, const Lanes& y) {
    return Lanes(x.v / y.v);
  }
  [[gnu::always_inline]] friend Lanes operator-(const Lanes& x) { return Lanes(-x.v); }
  [[gnu::always_inline]] friend Mask operator<(const Lanes& x, const Lanes& y) {
    return x.v < y.v;
  }
  [[gnu::always_inline]] friend Mask operator>(const Lanes& x, const Lanes& y) {
    return x.v > y.v;
  }
  [[gnu::always_inline]] friend Mask operator<=(const Lanes& x, const Lanes& y) {
    return x.v <= y.v;
  }
  [[gnu::always_inline]] friend Lanes sqrt(const Lanes& x) {
    return Lanes(Vector{std::sqrt(x.v[0]), std::sqrt(x.v[1]), std::sqrt(x.v[2]),
                        std::sqrt(x.v[3])});
  }
};

/// x where the mask is set, y elsewhere.
[[gnu::always_inline]] inline Lanes select(Lanes::Mask mask, const Lanes& x, const Lanes& y) {
  return Lanes(mask ? x.v : y.v);
}

[[gnu::always_inline]] inline Lanes abs(const Lanes& x) {
  constexpr long long rest = 0x7fffffffffffffff;
  return Lanes(reinterpret_cast<Lanes::Vector>(reinterpret_cast<Lanes::Mask>(x.v) &
                                               Lanes::Mask{rest, rest, rest, rest}));
}

/// A bit for each lane in which the mask is set.
[[gnu::always_inline]] inline unsigned bits(Lanes::Mask mask) {
  unsigned result = 0;
  for (std::size_t lane = 0; lane < Lanes::count; ++lane)
    result |= static_cast<unsigned>(mask[lane] & 1) << lane;
  return result;
}

}  // namespace tensortopo
