// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "exact_edge.hpp"

#include <cstddef>
#include <stdexcept>

#include "tensortopo/scalar/rational.hpp"
#include "tensortopo/tensor/deviator.hpp"

namespace tensortopo::test {

namespace {

/// Coefficients from the constant one up; no leading zeros; empty for zero.
using Polynomial = std::vector<Rational>;

Polynomial trimmed(Polynomial p) {
  while (!p.empty() && p.back() == 0) p.pop_back();
  return p;
}

Polynomial operator*(const Polynomial& p, const Polynomial& q) {
  if (p.empty() || q.empty()) return {};
  Polynomial product(p.size() + q.size() - 1, Rational(0));
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = 0; j < q.size(); ++j) product[i + j] += p[i] * q[j];
  return product;
}

Polynomial combined(const Rational& a, const Polynomial& p, const Rational& b,
                    const Polynomial& q) {
  Polynomial sum(std::max(p.size(), q.size()), Rational(0));
  for (std::size_t i = 0; i < p.size(); ++i) sum[i] += a * p[i];
  for (std::size_t i = 0; i < q.size(); ++i) sum[i] += b * q[i];
  return trimmed(sum);
}

Polynomial derivative(const Polynomial& p) {
  Polynomial result;
  for (std::size_t i = 1; i < p.size(); ++i) result.push_back(Rational(static_cast<int>(i)) * p[i]);
  return trimmed(result);
}

Rational evaluate(const Polynomial& p, const Rational& x) {
  Rational value(0);
  for (std::size_t i = p.size(); i-- > 0;) value = value * x + p[i];
  return value;
}

/// The remainder of p divided by q, up to a positive factor that keeps numbers short.
Polynomial remainder(Polynomial p, const Polynomial& q) {
  while (p.size() >= q.size()) {
    const Rational factor = p.back() / q.back();
    const std::size_t shift = p.size() - q.size();
    for (std::size_t i = 0; i < q.size(); ++i) p[i + shift] -= factor * q[i];
    p.back() = 0;
    p = trimmed(p);
  }
  if (!p.empty()) {
    const Rational scale = p.back() < 0 ? Rational(-p.back()) : p.back();
    for (auto& c : p) c /= scale;
  }
  return p;
}

class SturmChain {
 public:
  explicit SturmChain(const Polynomial& p) : chain_{p} {
    Polynomial next = derivative(p);
    while (!next.empty()) {
      chain_.push_back(next);
      next = remainder(chain_[chain_.size() - 2], next);
      for (auto& c : next) c = -c;
    }
  }

  /// Distinct roots in (low, high], which must not be multiple ones at the ends.
  int roots(const Rational& low, const Rational& high) const {
    return variations(low) - variations(high);
  }

 private:
  int variations(const Rational& x) const {
    int count = 0, last = 0;
    for (const auto& p : chain_) {
      const Rational value = evaluate(p, x);
      const int sign = value > 0 ? 1 : value < 0 ? -1 : 0;
      if (sign == 0) continue;
      count += last != 0 && sign != last;
      last = sign;
    }
    return count;
  }

  std::vector<Polynomial> chain_;
};

struct EdgeProblem {
  Polynomial norm, determinant, form;
  Rational mu;

  int sign(const Rational& x) const {
    const Rational f = evaluate(form, x);
    return f > 0 ? 1 : f < 0 ? -1 : 0;
  }
  /// The mode at x has the sign of mu: a root of the form nearby is one of mode mu, not of -mu.
  bool is_on_own_branch(const Rational& x) const {
    return (evaluate(determinant, x) > 0) == (mu > 0);
  }

  /// Sign of mode - mu at x.
  int side(const Rational& x) const {
    const Rational q = evaluate(determinant, x);
    const int sign_q = q > 0 ? 1 : q < 0 ? -1 : 0, sign_mu = mu > 0 ? 1 : -1;
    return sign_q != sign_mu ? -sign_mu : sign_mu * sign(x);
  }
};

EdgeProblem problem(const SymmetricTensor<double>& s, const SymmetricTensor<double>& t,
                    const ModeValue& mode) {
  const auto exact = [](const SymmetricTensor<double>& u) {
    return deviator(tensor_cast<Rational>(u));
  };
  const Deviator<Rational> d0 = exact(s), step = exact(t) - d0;
  const auto line = [](const Rational& a, const Rational& b) { return trimmed({a, b}); };
  const Polynomial a = line(d0.a, step.a), b = line(d0.b, step.b), xy = line(d0.xy, step.xy),
                   yz = line(d0.yz, step.yz), xz = line(d0.xz, step.xz);
  const Rational one(1), two(2);
  const Polynomial c = combined(one, a, one, b);
  const Polynomial x = combined(one, a, one, c), y = combined(one, b, -one, a),
                   z = combined(-one, b, -one, c);
  EdgeProblem result;
  result.mu = to_scalar<Rational>(mode);
  const auto plus = [&](const Polynomial& p, const Rational& k, const Polynomial& q) {
    return combined(one, p, k, q);
  };
  result.norm = plus(plus(a * a, one, b * b), one, c * c);
  for (const Polynomial& e : {xy, yz, xz}) result.norm = plus(result.norm, Rational(6), e * e);
  result.determinant = x * (y * z);
  result.determinant = plus(result.determinant, Rational(-9), x * (yz * yz));
  result.determinant = plus(result.determinant, Rational(-9), y * (xz * xz));
  result.determinant = plus(result.determinant, Rational(-9), z * (xy * xy));
  result.determinant = plus(result.determinant, Rational(54), xy * (yz * xz));
  result.form = combined(two, result.determinant * result.determinant, -result.mu * result.mu,
                         result.norm * (result.norm * result.norm));
  return result;
}

}  // namespace

std::vector<ExactCrossing> exact_crossings(const SymmetricTensor<double>& s,
                                           const SymmetricTensor<double>& t,
                                           const ModeValue& mode) {
  const EdgeProblem edge = problem(s, t, mode);
  if (edge.form.empty()) throw std::invalid_argument("the segment lies on the level");
  const SturmChain chain(edge.form);
  std::vector<ExactCrossing> crossings;
  bool above = edge.side(Rational(0)) > 0;
  const auto report = [&](const Rational& low, const Rational& high) {
    const auto add = [&](bool rising) {
      crossings.push_back({static_cast<double>(low), static_cast<double>(high), rising});
      above = rising;
    };
    if ((edge.side(high) > 0) != above) {
      add(!above);
    } else if (above && edge.is_on_own_branch(low)) {
      add(false), add(true);  // touches from above: twice through mu + 0
    }
  };
  // Bisect until each part holds one root; no end is a root but for 0 and 1.
  const auto isolate = [&](const auto& self, const Rational& low, const Rational& high,
                           int roots) -> void {
    if (roots == 0) return;
    const Rational width = high - low;
    if (roots == 1 && width < Rational(1, 1 << 20)) return report(low, high);
    Rational middle = low + width / 2;
    while (evaluate(edge.form, middle) == 0) middle += width / 7;
    int first = 0;
    if (roots == 1 && edge.sign(low) * edge.sign(high) < 0)
      first = edge.sign(low) != edge.sign(middle) ? 1 : 0;
    else
      first = chain.roots(low, middle);
    self(self, low, middle, first);
    self(self, middle, high, roots - first);
  };
  isolate(isolate, Rational(0), Rational(1), chain.roots(Rational(0), Rational(1)));
  return crossings;
}

}  // namespace tensortopo::test
