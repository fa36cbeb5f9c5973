// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <cstring>

#ifndef __GNUC__
#error "lanes.hpp wants the vector extensions of GCC and Clang"
#endif

namespace tensortopo {

// Without linkage, like all templates over it: sources compiled for different processors would
// otherwise share what is compiled for one of them.
namespace {

/// Four doubles side by side, each of another simplex, with the arithmetic of a scalar: a formula
/// that is a template over its scalar takes every lane through the operations that a double would
/// go through, in their order, so each lane gets the same bits. Nothing branches on a lane: a
/// comparison is a `Mask`, which `select` turns into a choice.
struct Lanes {
  static constexpr std::size_t count = 4;
  using Vector = double __attribute__((vector_size(32)));
  using Mask = long long __attribute__((vector_size(32)));  ///< of a lane: -1 (true) or 0

  Vector v;

  Lanes() = default;
  explicit Lanes(double x) : v{x, x, x, x} {}
  explicit Lanes(int x) : Lanes(static_cast<double>(x)) {}
  explicit Lanes(const Vector& w) : v(w) {}

  double operator[](std::size_t lane) const { return v[lane]; }

  friend Lanes operator+(const Lanes& x, const Lanes& y) { return Lanes(x.v + y.v); }
  friend Lanes operator-(const Lanes& x, const Lanes& y) { return Lanes(x.v - y.v); }
  friend Lanes operator*(const Lanes& x, const Lanes& y) { return Lanes(x.v * y.v); }
  friend Lanes operator/(const Lanes& x, const Lanes& y) { return Lanes(x.v / y.v); }
  friend Lanes operator-(const Lanes& x) { return Lanes(-x.v); }
  friend Mask operator<(const Lanes& x, const Lanes& y) { return x.v < y.v; }
  friend Mask operator>(const Lanes& x, const Lanes& y) { return x.v > y.v; }
  friend Mask operator<=(const Lanes& x, const Lanes& y) { return x.v <= y.v; }
  friend Lanes sqrt(const Lanes& x) {
    // One instruction where errno is not asked for.
    double in[count], out[count];
    std::memcpy(in, &x.v, sizeof in);
    for (std::size_t lane = 0; lane < count; ++lane) out[lane] = std::sqrt(in[lane]);
    Lanes result;
    std::memcpy(&result.v, out, sizeof out);
    return result;
  }
};

/// x where the mask is set, y elsewhere.
inline Lanes select(Lanes::Mask mask, const Lanes& x, const Lanes& y) {
  return Lanes(mask ? x.v : y.v);
}

inline Lanes abs(const Lanes& x) {
  constexpr long long rest = 0x7fffffffffffffff;
  return Lanes(reinterpret_cast<Lanes::Vector>(reinterpret_cast<Lanes::Mask>(x.v) &
                                               Lanes::Mask{rest, rest, rest, rest}));
}

/// A bit for each lane in which the mask is set.
inline unsigned bits(Lanes::Mask mask) {
  unsigned result = 0;
  for (std::size_t lane = 0; lane < Lanes::count; ++lane)
    result |= static_cast<unsigned>(mask[lane] & 1) << lane;
  return result;
}

}  // namespace
}  // namespace tensortopo
