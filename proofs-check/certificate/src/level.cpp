// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "level.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "direction.hpp"

namespace certificate {
namespace {

/// All coefficients, and so all values.
template <class N, std::size_t V, std::size_t D>
Answer have_sign(const Polynomial<N, V, D>& p, int sign, Zero zero) {
  Answer result = Answer::yes;
  for (const N& x : p.coefficients) {
    const Answer one = has_sign(x, sign, zero);
    if (one == Answer::no) return one;
    if (one == Answer::unsure) result = one;
  }
  return result;
}

template <std::size_t V>
Forms<Ball, V> ball_forms(const std::array<Corner, V>& corners) {
  std::array<const Tensor<Ball>*, V> balls;
  for (std::size_t i = 0; i < V; ++i) balls[i] = corners[i].ball;
  return Forms<Ball, V>(balls);
}

/// The same multiplied by a power of 2.
template <std::size_t V>
Forms<mpz_class, V> exact_forms(const std::array<Corner, V>& corners) {
  long shift = corners[0].shift;
  for (const Corner& corner : corners) shift = std::max(shift, corner.shift);
  std::array<Tensor<mpz_class>, V> tensors;
  std::array<const Tensor<mpz_class>*, V> places;
  for (std::size_t i = 0; i < V; ++i) {
    tensors[i] = corners[i].exact();
    for (mpz_class& x : tensors[i]) x <<= static_cast<unsigned long>(shift - corners[i].shift);
    places[i] = &tensors[i];
  }
  return Forms<mpz_class, V>(places);
}

}  // namespace

/// Answers questions about the forms by doubles, and by integers what these leave open.
template <std::size_t V>
class Level::Simplex {
 public:
  Simplex(const Level& level, const std::array<Corner, V>& corners)
      : level_(level), corners_(corners), balls_(ball_forms(corners)) {}

  const Forms<Ball, V>& balls() const { return balls_; }
  template <class Question>
  bool is_true(const Question& question) {
    Answer answer = question(balls_);
    if (answer != Answer::unsure) return ++level_.by_balls_, answer == Answer::yes;
    if (!exact_) exact_ = exact_forms(corners_);
    return ++level_.by_integers_, question(*exact_) == Answer::yes;
  }

 private:
  const Level& level_;
  const std::array<Corner, V>& corners_;
  Forms<Ball, V> balls_;
  std::optional<Forms<mpz_class, V>> exact_;
};

Level::Level(mpz_class numerator, mpz_class denominator)
    : sign_(sgn(numerator)),
      exact_{54 * denominator * denominator, -numerator * numerator} {
  const long size = static_cast<long>(mpz_sizeinbase(exact_.q.get_mpz_t(), 2));
  balls_ = {ball_of(exact_.q, size), ball_of(exact_.p, size)};
  const long root_size = static_cast<long>(mpz_sizeinbase(denominator.get_mpz_t(), 2));
  root_ = {ball_of(denominator, root_size), ball_of(mpz_class(-numerator), root_size)};
}

template <class N, std::size_t V>
Polynomial<N, V, 6> Level::degree_six(const Forms<N, V>& f) const {
  const auto form = [&](const auto& factors) {
    return combination(factors.q, f.q * f.q, factors.p, f.p * f.p * f.p);
  };
  if constexpr (std::is_same_v<N, Ball>) return form(balls_);
  else return form(exact_);
}

/// Is all of the simplex on this side? Points of mode exactly mu are below.
template <class N, std::size_t V>
Answer Level::lies(bool above, const Forms<N, V>& f) const {
  const auto q_is = [&](int sign, Zero zero) { return have_sign(f.q, sign, zero); };
  const auto f_is = [&](int sign, Zero zero) {
    return [&f, this, sign, zero] { return have_sign(degree_six(f), sign, zero); };
  };
  if (sign_ == 0) return above ? q_is(1, Zero::fails) : q_is(-1, Zero::will_do);
  if (sign_ > 0)
    return above ? both(q_is(1, Zero::fails), f_is(1, Zero::fails))
                 : either(q_is(-1, Zero::will_do), f_is(-1, Zero::will_do));
  return above ? either(q_is(1, Zero::will_do), f_is(-1, Zero::fails))
               : both(q_is(-1, Zero::fails), f_is(1, Zero::will_do));
}

/// Is all of the simplex on the side of the first corner, by a form that vanishes at mu only? (F
/// does so at -mu as well, where the answer would need parts as narrow as all between.) With a
/// linear bound s of sqrt(P/54), from above by convexity or from below by Cauchy's inequality.
template <std::size_t V>
bool Level::lies_by_norm(const std::array<Corner, V>& corners, const Forms<Ball, V>& f) const {
  if (sign_ == 0) return false;
  const int side = corners[0].above ? 1 : -1;
  Polynomial<Ball, V, 1> s;
  if (side == sign_) {
    for (std::size_t i = 0; i < V; ++i) {
      const Ball square = trace(*corners[i].ball, *corners[i].ball);
      const Ball root((1 + 0x1p-40) * std::sqrt(square.value / 54), 0);
      if (has_sign(Ball(54) * root * root - square, 1, Zero::fails) != Answer::yes) return false;
      s.coefficients[i] = root;
    }
  } else {
    // For all E with 54 tr(E^2) < 1: here about the mean of the corners.
    Tensor<Ball> e{};
    for (const Corner& corner : corners) {
      const double length = std::sqrt(trace(*corner.ball, *corner.ball).value);
      for (std::size_t k = 0; k < 6; ++k) e[k].value += (*corner.ball)[k].value / length;
    }
    const double factor = (1 - 0x1p-40) / std::sqrt(54 * trace(e, e).value);
    for (Ball& x : e) x.value *= factor;
    if (has_sign(Ball(1) - Ball(54) * trace(e, e), 1, Zero::fails) != Answer::yes) return false;
    for (std::size_t i = 0; i < V; ++i) s.coefficients[i] = trace(*corners[i].ball, e);
  }
  const auto form = combination(root_.q, f.q, root_.p, f.p * s);
  return have_sign(form, side, Zero::fails) == Answer::yes;
}

template <std::size_t V>
bool Level::is_one_sided(const std::array<Corner, V>& corners) const {
  Simplex<V> simplex(*this, corners);
  return simplex.is_true([&](const auto& f) { return lies(corners[0].above, f); }) ||
         lies_by_norm(corners, simplex.balls());
}

template bool Level::is_one_sided<1>(const std::array<Corner, 1>&) const;
template bool Level::is_one_sided<2>(const std::array<Corner, 2>&) const;
template bool Level::is_one_sided<3>(const std::array<Corner, 3>&) const;

template <std::size_t V>
Proved<V> Level::prove(const std::array<Corner, V>& corners) const {
  Simplex<V> simplex(*this, corners);
  const bool is_crossed = std::any_of(corners.begin(), corners.end(), [&](const Corner& corner) {
    return corner.above != corners[0].above;
  });
  if (!is_crossed && simplex.is_true([&](const auto& f) { return lies(corners[0].above, f); }))
    return {Proof::empty, {}};
  const auto direction = likely_direction(simplex.balls());
  if (!direction) return {};
  const bool increases = simplex.is_true([&](const auto& f) {
    return both(have_sign(f.p, 1, Zero::fails), [&] {
      const auto g = increase(f, *direction);
      return either(have_sign(g, 1, Zero::fails), [&] { return have_sign(g, -1, Zero::fails); });
    });
  });
  return increases ? Proved<V>{Proof::monotone, *direction} : Proved<V>{};
}

template Proved<2> Level::prove<2>(const std::array<Corner, 2>&) const;
template Proved<3> Level::prove<3>(const std::array<Corner, 3>&) const;
template Proved<4> Level::prove<4>(const std::array<Corner, 4>&) const;

bool Level::above(const Corner& corner) const {
  const std::array point{corner};
  return Simplex<1>(*this, point).is_true([&](const auto& f) { return lies(true, f); });
}

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

/// Neither this sign of the form nor the other.
bool Level::on_level(const Corner& corner) const {
  const std::array point{corner};
  return Simplex<1>(*this, point).is_true([&](const auto& f) {
    const auto is_zero = [](const auto& x) {
      return both(have_sign(x, 1, Zero::will_do),
                  [&] { return have_sign(x, -1, Zero::will_do); });
    };
    if (sign_ == 0) return both(is_zero(f.q), [&] { return have_sign(f.p, 1, Zero::fails); });
    return both(have_sign(f.q, sign_, Zero::fails), [&] { return is_zero(degree_six(f)); });
  });
}

}  // namespace certificate
