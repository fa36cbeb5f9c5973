// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "level.hpp"

#include <algorithm>
#include <utility>

#include "direction.hpp"

namespace certificate {

Level::Level(mpz_class numerator, mpz_class denominator)
    : sign_(sgn(numerator)),
      exact_q_(54 * denominator * denominator),
      exact_p_(numerator * numerator) {
  const long size = static_cast<long>(mpz_sizeinbase(exact_q_.get_mpz_t(), 2));
  ball_q_ = ball_of(exact_q_, size);
  ball_p_ = ball_of(exact_p_, size);
}

template <>
const Ball& Level::q_factor<Ball>() const { return ball_q_; }
template <>
const mpz_class& Level::q_factor<mpz_class>() const { return exact_q_; }
template <>
const Ball& Level::p_factor<Ball>() const { return ball_p_; }
template <>
const mpz_class& Level::p_factor<mpz_class>() const { return exact_p_; }

/// Is all of the simplex on the side of its vertices? Points of the level have F = 0 and Q of the
/// sign of mu; exactly there lie points below, so *below* allows for zeros.
template <class N, std::size_t V>
bool Level::is_empty(const Forms<N, V>& f, bool above, bool& unsure) const {
  Signs q;
  for (const N& x : f.q.coefficients) q.add(x);
  if (sign_ == 0) {
    unsure = q.unsure && !(above ? q.negative : q.positive);
    return !q.unsure && (above ? !q.negative && !q.zero : !q.positive);
  }
  // Q alone may do: above for mu < 0 and Q >= 0, below for mu > 0 and Q <= 0.
  const bool q_decides = sign_ < 0 ? above : !above;
  const bool q_against = above ? q.negative : q.positive;
  if (q_decides && !q_against && !q.unsure) return true;
  if (!q_decides && (q_against || q.zero)) return false;

  Signs s;
  const auto form = combination(q_factor<N>(), f.q * f.q, p_factor<N>(), f.p * f.p * f.p);
  for (const N& x : form.coefficients) s.add(x);
  // For mu > 0 F is positive above, for mu < 0 (and Q < 0) it is negative there.
  const bool inside_positive = sign_ > 0;
  const bool against = above == inside_positive ? s.negative : s.positive;
  const bool zero_is_fatal = above;
  const bool f_fails = against || (zero_is_fatal && s.zero);
  if (q_decides) {  // either form alone proves it
    unsure = (q.unsure && !q_against) || (s.unsure && !f_fails);
    return !f_fails && !s.unsure;
  }
  unsure = (q.unsure || s.unsure) && !f_fails;  // both are needed
  return !f_fails && !q.unsure && !s.unsure;
}

namespace {

template <std::size_t V>
Forms<Ball, V> ball_forms(const std::array<Corner, V>& corners) {
  std::array<const Tensor<Ball>*, V> balls;
  for (std::size_t i = 0; i < V; ++i) balls[i] = corners[i].ball;
  return Forms<Ball, V>(balls);
}

/// The same multiplied by a power of 2.
template <std::size_t V>
std::unique_ptr<Forms<mpz_class, V>> exact_forms(const std::array<Corner, V>& corners) {
  long shift = corners[0].shift;
  for (const Corner& corner : corners) shift = std::max(shift, corner.shift);
  std::array<Tensor<mpz_class>, V> tensors;
  std::array<const Tensor<mpz_class>*, V> places;
  for (std::size_t i = 0; i < V; ++i) {
    tensors[i] = corners[i].exact();
    for (mpz_class& x : tensors[i]) x <<= static_cast<unsigned long>(shift - corners[i].shift);
    places[i] = &tensors[i];
  }
  return std::make_unique<Forms<mpz_class, V>>(places);
}

}  // namespace

template <std::size_t V>
bool Level::is_one_sided(const std::array<Corner, V>& corners) const {
  bool unsure = false;
  if (is_empty(ball_forms(corners), corners[0].above, unsure)) return ++balls_, true;
  return unsure && is_empty(*exact_forms(corners), corners[0].above, unsure) &&
         (++exact_count_, true);
}

template bool Level::is_one_sided<3>(const std::array<Corner, 3>&) const;

template <std::size_t V>
Proved<V> Level::prove(const std::array<Corner, V>& corners) const {
  const bool mixed = std::any_of(corners.begin(), corners.end(), [&](const Corner& corner) {
    return corner.above != corners[0].above;
  });
  std::unique_ptr<Forms<mpz_class, V>> exact;
  const auto exactly = [&]() -> const Forms<mpz_class, V>& {
    if (!exact) exact = exact_forms(corners);
    return *exact;
  };

  const auto f = ball_forms(corners);
  bool unsure = false;
  if (!mixed && is_empty(f, corners[0].above, unsure))
    return ++balls_, Proved<V>{Proof::empty, {}};
  if (unsure && is_empty(exactly(), corners[0].above, unsure))
    return ++exact_count_, Proved<V>{Proof::empty, {}};

  const auto direction = likely_direction(f);
  if (!direction) return {};
  const auto increases = [&](const auto& forms) {
    Signs p, g;
    for (const auto& x : forms.p.coefficients) p.add(x);
    if (p.negative || p.zero) return Signs{true, true, true, false};
    g.unsure = p.unsure;
    const auto form = increase(forms, *direction);
    for (const auto& x : form.coefficients) g.add(x);
    return g;
  };
  const auto strict = [](const Signs& s) {
    return !s.unsure && !s.zero && s.positive != s.negative;
  };
  const auto fails = [](const Signs& s) { return s.zero || (s.positive && s.negative); };
  const Signs by_balls = increases(f);
  if (strict(by_balls)) return ++balls_, Proved<V>{Proof::monotone, *direction};
  if (fails(by_balls)) return {};
  if (strict(increases(exactly())))
    return ++exact_count_, Proved<V>{Proof::monotone, *direction};
  return {};
}

template Proved<2> Level::prove<2>(const std::array<Corner, 2>&) const;
template Proved<3> Level::prove<3>(const std::array<Corner, 3>&) const;
template Proved<4> Level::prove<4>(const std::array<Corner, 4>&) const;

namespace {

/// The signs of Q and F at one tensor.
template <class N>
std::pair<Signs, Signs> signs_at(const Tensor<N>& m, const N& q_factor, const N& p_factor) {
  const Forms<N, 1> forms({&m});
  const N& p = forms.p.coefficients[0];
  const N& q = forms.q.coefficients[0];
  std::pair<Signs, Signs> signs;
  signs.first.add(q);
  signs.second.add(N(q_factor * N(q * q) - p_factor * N(N(p * p) * p)));
  return signs;
}

bool is_above(int sign, const Signs& q, const Signs& f) {
  if (sign == 0) return q.positive;
  return sign > 0 ? q.positive && f.positive : !q.negative || f.negative;
}

bool is_certain(int sign, const Signs& q, const Signs& f) {
  if (q.unsure) return false;
  return sign == 0 || (sign > 0 ? !q.positive : !q.negative) || !f.unsure;
}

}  // namespace

bool Level::above(const Tensor<Ball>& ball, const Tensor<mpz_class>& exact) const {
  /// A corner that need not be made.
  struct Given : ExactTensors {
    const Tensor<mpz_class>& tensor;
    explicit Given(const Tensor<mpz_class>& t) : tensor(t) {}
    Tensor<mpz_class> exact(std::uint32_t) const override { return tensor; }
  };
  const Given source(exact);
  return above({&ball, 0, &source, 0});
}

bool Level::above(const Corner& corner) const {
  const auto [q, f] = signs_at(*corner.ball, ball_q_, ball_p_);
  if (is_certain(sign_, q, f)) return ++balls_, is_above(sign_, q, f);
  const auto [exact_q, exact_f] = signs_at(corner.exact(), exact_q_, exact_p_);
  return ++exact_count_, is_above(sign_, exact_q, exact_f);
}

bool Level::on_level(const Corner& corner) const {
  const auto [q, f] = signs_at(*corner.ball, ball_q_, ball_p_);
  if (sign_ == 0 ? !q.unsure : !f.unsure) return false;
  const Tensor<mpz_class> m = corner.exact();
  const auto [exact_q, exact_f] = signs_at(m, exact_q_, exact_p_);
  if (trace(m, m) == 0) return false;
  if (sign_ == 0) return exact_q.zero;
  return exact_f.zero && (sign_ > 0 ? exact_q.positive : exact_q.negative);
}

}  // namespace certificate
