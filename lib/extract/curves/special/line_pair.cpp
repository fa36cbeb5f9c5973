// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/curves/special/line_pair.hpp"

#include "extract/curves/points/certified_zero.hpp"

namespace tensortopo {

namespace {

/// rational + surd sqrt(d), for a d >= 0 that is the same for all.
struct Surd {
  Rational rational, surd;
};

int sign_of(const Surd& x, const Rational& d) {
  const Rational difference = x.rational * x.rational - x.surd * x.surd * d;
  const int r = x.rational.sign(), s = d == 0 ? 0 : x.surd.sign();
  if (r == s || s == 0) return r;
  if (r == 0) return s;
  return difference == 0 ? 0 : (difference > 0 ? r : s);
}

MultiprecisionInterval enclosed(const Surd& x, const MultiprecisionInterval& root) {
  return interval_of(x.rational) + interval_of(x.surd) * root;
}

}  // namespace

LinePair::LinePair(const SymmetricTensor<Rational>& form) : kernel_(kernel_of(form)) {
  const Vector3<Rational> x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  if (kernel_.x != 0)
    u_ = y, v_ = z;
  else if (kernel_.y != 0)
    u_ = x, v_ = z;
  else
    u_ = x, v_ = y;
  // a s^2 + 2 b s t + c t^2 at s u + t v vanishes where a s = (-b -+ sqrt(b^2 - a c)) t.
  Rational a = polar(form, u_, u_);
  const Rational b = polar(form, u_, v_), c = polar(form, v_, v_);
  if (a == 0) {
    if (c == 0) {
      axes_ = true;
      return;
    }
    std::swap(u_, v_);
    a = c;
    square_ = b * b;
  } else {
    square_ = b * b - a * c;
  }
  along_ = {a, Rational(-b)};
}

ExactDirection LinePair::direction(std::size_t k) const {
  if (axes_) return interval_of(k == 0 ? u_ : v_);
  const auto root = sqrt_of(interval_of(square_));
  const auto s = interval_of(along_[1]) + (k == 0 ? -root : root);
  return normalized(s * interval_of(u_) + interval_of(along_[0]) * interval_of(v_));
}

ExactDirection LinePair::normal(std::size_t k) const {
  return normalized(cross(interval_of(kernel_), direction(k)));
}

std::vector<ExactDirection> LinePair::zeros_of(const SymmetricTensor<Rational>& other) const {
  std::vector<ExactDirection> result;
  const Rational at_kernel = polar(other, kernel_, kernel_);
  const auto p = interval_of(kernel_);
  if (at_kernel == 0) result.push_back(normalized(p));
  const Rational d = axes_ ? Rational(0) : square_;
  const auto root = sqrt_of(interval_of(d));
  for (std::size_t k = 0; k < 2; ++k) {
    // The direction is s u + t v; with p it spans the line.
    const Surd s = axes_ ? Surd{k == 0 ? 1 : 0, 0} : Surd{along_[1], k == 0 ? -1 : 1};
    const Rational t = axes_ ? Rational(k == 0 ? 0 : 1) : along_[0];
    const Rational pu = polar(other, kernel_, u_), pv = polar(other, kernel_, v_);
    const Rational uu = polar(other, u_, u_), uv = polar(other, u_, v_), vv = polar(other, v_, v_);
    const auto times = [&](const Surd& x, const Surd& y) {
      return Surd{x.rational * y.rational + x.surd * y.surd * d,
                  x.rational * y.surd + x.surd * y.rational};
    };
    const Surd ss = times(s, s);
    const Surd mixed{s.rational * pu + t * pv, s.surd * pu};
    const Surd at_line{ss.rational * uu + 2 * t * s.rational * uv + t * t * vv,
                       ss.surd * uu + 2 * t * s.surd * uv};
    const auto g = enclosed(s, root) * interval_of(u_) + interval_of(t) * interval_of(v_);
    const auto b = enclosed(mixed, root), c = enclosed(at_line, root);
    if (at_kernel == 0) {
      // Of 2 b x y + c y^2 at x p + y g the other zero is x : y = -c : 2 b.
      if (sign_of(mixed, d) != 0) result.push_back(normalized((-c) * p + (b + b) * g));
      continue;
    }
    const Surd mm = times(mixed, mixed);
    const Surd square{mm.rational - at_kernel * at_line.rational,
                      mm.surd - at_kernel * at_line.surd};
    const int sign = sign_of(square, d);
    if (sign < 0) continue;
    const auto a = interval_of(at_kernel);
    const auto r = sign == 0 ? MultiprecisionInterval(0.0) : sqrt_of(enclosed(square, root));
    result.push_back(normalized((r - b) * p + a * g));
    if (sign > 0) result.push_back(normalized((-r - b) * p + a * g));
  }
  return result;
}

}  // namespace tensortopo
