// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/curves/points/exact_direction.hpp"

#include <array>

#include "extract/curves/points/certified_zero.hpp"
#include "tensortopo/scalar/extended.hpp"

namespace tensortopo {

MultiprecisionInterval interval_of(const Rational& x) {
  MultiprecisionInterval result;
  mpfr_set_q(result.low.backend().data(), x.backend().data(), MPFR_RNDD);
  mpfr_set_q(result.high.backend().data(), x.backend().data(), MPFR_RNDU);
  return result;
}

ExactDirection interval_of(const Vector3<Rational>& v) {
  return {interval_of(v.x), interval_of(v.y), interval_of(v.z)};
}

MultiprecisionInterval sqrt_of(const MultiprecisionInterval& x) {
  MultiprecisionInterval result;
  if (x.low > 0) mpfr_sqrt(result.low.backend().data(), x.low.backend().data(), MPFR_RNDD);
  if (x.high > 0) mpfr_sqrt(result.high.backend().data(), x.high.backend().data(), MPFR_RNDU);
  return result;
}

ExactDirection normalized(const ExactDirection& e) {
  MultiprecisionInterval::End size(0);
  for (const MultiprecisionInterval* x : {&e.x, &e.y, &e.z}) size = std::max(size, magnitude(*x));
  if (size == 0) return e;
  const long exponent = mpfr_get_exp(size.backend().data());
  const auto scaled = [&](const MultiprecisionInterval& x) {
    MultiprecisionInterval result;
    mpfr_mul_2si(result.low.backend().data(), x.low.backend().data(), -exponent, MPFR_RNDD);
    mpfr_mul_2si(result.high.backend().data(), x.high.backend().data(), -exponent, MPFR_RNDU);
    return result;
  };
  return {scaled(e.x), scaled(e.y), scaled(e.z)};
}

Vector3<Extended> rounded_direction(const ExactDirection& e) {
  using End = MultiprecisionInterval::End;
  const ExactDirection n = normalized(e);
  const auto middle = [](const MultiprecisionInterval& x) { return End((x.low + x.high) / 2); };
  const Vector3<End> m{middle(n.x), middle(n.y), middle(n.z)};
  const End scale = 1 / sqrt(dot(m, m));
  return {to_extended(End(scale * m.x)), to_extended(End(scale * m.y)),
          to_extended(End(scale * m.z))};
}

bool is_zero(const Vector3<Rational>& v) { return v.x == 0 && v.y == 0 && v.z == 0; }

Vector3<Rational> kernel_of(const SymmetricTensor<Rational>& t) {
  const Vector3<Rational> x{t.xx, t.xy, t.xz}, y{t.xy, t.yy, t.yz}, z{t.xz, t.yz, t.zz};
  for (const auto& k : {cross(x, y), cross(y, z), cross(z, x)})
    if (!is_zero(k)) return k;
  return {};
}

std::optional<std::size_t> position_in(std::span<const ExactDirection> list,
                                       const ExactDirection& e) {
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (are_apart(list[i], e)) continue;
    if (found) return std::nullopt;
    found = i;
  }
  return found;
}

ExactDirection dominant_direction(const SymmetricTensor<MultiprecisionInterval>& t) {
  const auto squares = trace(square(t)), cubes = MultiprecisionInterval(3.0) * determinant(t);
  const auto r = squares * t;
  const MultiprecisionInterval x = r.xx + cubes, y = r.yy + cubes, z = r.zz + cubes;
  const auto mx = magnitude(x), my = magnitude(y), mz = magnitude(z);
  if (mx >= my && mx >= mz) return normalized({x, r.xy, r.xz});
  if (my >= mz) return normalized({r.xy, y, r.yz});
  return normalized({r.xz, r.yz, z});
}

TensorKind kind_of(const Deviator<Rational>& d) {
  TensorKind kind;
  const std::array<Rational, 5> t{d.a, d.b, d.xy, d.yz, d.xz};
  kind.zero = d == Deviator<Rational>{};
  if (kind.zero) return kind;
  // Degenerate exactly if the deviator of its square is a multiple of it.
  const auto tensor = thrice(d);
  const auto s = deviator(square(tensor));
  const std::array<Rational, 5> q{s.a, s.b, s.xy, s.yz, s.xz};
  for (std::size_t i = 0; i < 5; ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (t[i] * q[j] != t[j] * q[i]) return kind;
  kind.degenerate = true;
  kind.linear = determinant(tensor) > 0;
  kind.direction =
      dominant_direction({interval_of(tensor.xx), interval_of(tensor.yy), interval_of(tensor.zz),
                          interval_of(tensor.xy), interval_of(tensor.yz), interval_of(tensor.xz)});
  return kind;
}

}  // namespace tensortopo
