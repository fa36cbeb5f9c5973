// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/curves/special/pencil_points.hpp"

#include <algorithm>

#include "extract/curves/points/certified_zero.hpp"
#include "tensortopo/scalar/extended.hpp"

namespace tensortopo {

namespace {

/// Coefficients from the constant one on; the last is not zero.
using Polynomial = std::vector<Rational>;

Polynomial trimmed(Polynomial p) {
  while (!p.empty() && p.back() == 0) p.pop_back();
  return p;
}

/// The quotient, and what is left in `p`.
Polynomial divide(Polynomial& p, const Polynomial& q) {
  Polynomial quotient(p.size() >= q.size() ? p.size() - q.size() + 1 : 0);
  while (p.size() >= q.size()) {
    const std::size_t shift = p.size() - q.size();
    const Rational factor = p.back() / q.back();
    quotient[shift] = factor;
    for (std::size_t i = 0; i < q.size(); ++i) p[shift + i] = p[shift + i] - factor * q[i];
    p.pop_back();
    p = trimmed(std::move(p));
  }
  return quotient;
}

/// With leading coefficient one.
Polynomial greatest_common_divisor(Polynomial p, Polynomial q) {
  while (!q.empty()) {
    divide(p, q);
    std::swap(p, q);
  }
  if (!p.empty()) {
    const Rational lead = p.back();
    for (Rational& c : p) c = c / lead;
  }
  return p;
}

/// The polynomial with the same zeros, all of them simple.
Polynomial without_multiple_zeros(Polynomial p) {
  Polynomial slope;
  for (std::size_t i = 1; i < p.size(); ++i) slope.push_back(Rational(i) * p[i]);
  const Polynomial common = greatest_common_divisor(p, slope);
  return common.size() < 2 ? p : divide(p, common);
}

/// The common divisor of the minors of a + t b and the deviator of its square.
Polynomial degeneracy_polynomial(const Deviator<Rational>& a, const Deviator<Rational>& b) {
  const auto entries = [](const Deviator<Rational>& d) {
    return std::array<Rational, 5>{d.a, d.b, d.xy, d.yz, d.xz};
  };
  const auto ta = thrice(a), tb = thrice(b);
  const auto s0 = square(ta), s2 = square(tb), both = square(ta + tb);
  const std::array<std::array<Rational, 5>, 2> t{entries(a), entries(b)};
  const std::array<std::array<Rational, 5>, 3> s{
      entries(deviator(s0)), entries(deviator(both - s0 - s2)), entries(deviator(s2))};
  Polynomial common;
  for (std::size_t i = 0; i < 5; ++i)
    for (std::size_t j = 0; j < i; ++j) {
      Polynomial minor(4);
      for (std::size_t k = 0; k < 2; ++k)
        for (std::size_t l = 0; l < 3; ++l)
          minor[k + l] = minor[k + l] + (t[k][i] * s[l][j] - t[k][j] * s[l][i]);
      common = greatest_common_divisor(std::move(common), trimmed(std::move(minor)));
      if (common.size() == 1) return common;
    }
  return without_multiple_zeros(std::move(common));
}

using Weights = std::array<MultiprecisionInterval, 2>;

/// By bisection in Bernstein form: the zeros of a polynomial with simple zeros in an open
/// interval of s = y / (x + y).
class ZeroIsolation {
 public:
  explicit ZeroIsolation(const Polynomial& p) {
    Polynomial bernstein = p;
    if (p.size() == 4) bernstein[1] = p[1] / 3, bernstein[2] = p[2] / 3;
    search(bernstein, 0, 1);
  }
  const std::vector<Weights>& zeros() const { return zeros_; }

 private:
  static constexpr int kBits = 480;

  static int variations(const Polynomial& p) {
    int count = 0, last = 0;
    for (const Rational& c : p) {
      const int sign = c.sign();
      if (sign != 0 && last != 0 && sign != last) ++count;
      if (sign != 0) last = sign;
    }
    return count;
  }
  void add(const Rational& low, const Rational& high) {
    const auto l = interval_of(low), h = interval_of(high);
    const MultiprecisionInterval y(l.low, h.high);
    zeros_.push_back({MultiprecisionInterval(1.0) - y, y});
  }
  void search(Polynomial p, Rational low, Rational high) {
    const int count = variations(p);
    if (count == 0) return;
    const Rational middle = (low + high) / 2;
    if (count == 1 && (high - low) * ldexp_one(kBits) < low) return add(low, high);
    Polynomial left, right;
    for (std::size_t n = p.size(); n > 0; --n) {
      left.push_back(p[0]);
      right.insert(right.begin(), p[n - 1]);
      for (std::size_t i = 0; i + 1 < n; ++i) p[i] = (p[i] + p[i + 1]) / 2;
    }
    if (left.back() == 0) add(middle, middle);
    search(std::move(left), low, middle);
    search(std::move(right), middle, high);
  }
  static Rational ldexp_one(int bits) {
    return Rational(boost::multiprecision::mpz_int(1) << bits);
  }

  std::vector<Weights> zeros_;
};

/// The positive zeros y / x of a polynomial with simple zeros.
std::vector<Weights> positive_zeros(Polynomial p) {
  if (p.size() < 2) return {};
  if (p[0] == 0) p.erase(p.begin());
  if (p.size() < 2) return {};
  if (p.back() < 0)
    for (Rational& c : p) c = -c;
  if (p.size() == 2) {
    if (p[0] > 0) return {};
    return {{interval_of(p[1]), interval_of(Rational(-p[0]))}};
  }
  if (p.size() == 3) {
    const Rational square = p[1] * p[1] - 4 * p[0] * p[2];
    if (square <= 0 || (p[0] > 0 && p[1] > 0)) return {};
    // Without cancellation: of the two zeros one has the sum, its product with the other is known.
    const auto root = sqrt_of(interval_of(square));
    const MultiprecisionInterval twice_lead = interval_of(Rational(2 * p[2]));
    const MultiprecisionInterval twice_constant = interval_of(Rational(2 * p[0]));
    const MultiprecisionInterval slope = interval_of(p[1]);
    if (p[1] <= 0) {
      std::vector<Weights> zeros{{twice_lead, root - slope}};
      if (p[0] > 0) zeros.push_back({root - slope, twice_constant});
      return zeros;
    }
    return {{root + slope, -twice_constant}};
  }
  return ZeroIsolation(p).zeros();
}

SymmetricTensor<MultiprecisionInterval> in_intervals(const SymmetricTensor<Rational>& t) {
  return {interval_of(t.xx), interval_of(t.yy), interval_of(t.zz),
          interval_of(t.xy), interval_of(t.yz), interval_of(t.xz)};
}

}  // namespace

std::optional<std::vector<PencilPoint>> degenerate_points_between(const Deviator<Rational>& a,
                                                                  const Deviator<Rational>& b) {
  std::vector<PencilPoint> result;
  const auto ta = in_intervals(thrice(a)), tb = in_intervals(thrice(b));
  for (const Weights& w : positive_zeros(degeneracy_polynomial(a, b))) {
    PencilPoint point;
    const auto t = w[0] * ta + w[1] * tb;
    const Verdict sign = sign_in(determinant(t));
    if (!is_strict(sign)) return std::nullopt;
    point.linear = sign == Verdict::positive;
    point.direction = dominant_direction(t);
    using End = MultiprecisionInterval::End;
    const End x = w[0].low + w[0].high, y = w[1].low + w[1].high;
    point.weights = {to_extended(End(x / (x + y))), to_extended(End(y / (x + y)))};
    result.push_back(std::move(point));
  }
  return result;
}

std::optional<std::vector<ExactDirection>> pencil_directions(const Deviator<Rational>& a,
                                                             const Deviator<Rational>& b) {
  std::vector<ExactDirection> result;
  for (const auto& t : {a, b})
    if (const auto kind = kind_of(t); kind.degenerate) result.push_back(kind.direction);
  for (const auto& other : {b, Rational(-1) * b}) {
    const auto points = degenerate_points_between(a, other);
    if (!points) return std::nullopt;
    for (const auto& point : *points) result.push_back(point.direction);
  }
  for (std::size_t i = 0; i < result.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (!are_apart(result[i], result[j])) return std::nullopt;
  return result;
}

}  // namespace tensortopo
