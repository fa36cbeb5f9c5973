// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "level.hpp"

#include <algorithm>
#include <optional>

#include "direction.hpp"

namespace certificate {

/// Answers questions about a rule's forms by doubles, and by integers what these leave open.
template <class Rule, std::size_t V>
class Level::Simplex {
  template <class N>
  using Form = decltype(std::declval<Rule>().forms(std::array<const Tensor<N>*, V>()));

 public:
  Simplex(const Level& level, const Rule& rule, const std::array<Corner, V>& corners)
      : level_(level), rule_(rule), corners_(corners) {
    std::array<const Tensor<Ball>*, V> tensors;
    for (std::size_t i = 0; i < V; ++i) tensors[i] = corners[i].ball;
    balls_ = rule.forms(tensors);
  }

  const Form<Ball>& balls() const { return balls_; }
  bool took_integers() const { return exact_.has_value(); }
  bool is_true(const auto& question) { return is_true(question(balls_), question); }
  bool is_true(Answer by_balls, const auto& question) {
    if (by_balls != Answer::unsure) return ++level_.by_balls_, by_balls == Answer::yes;
    if (!exact_) exact_ = exact_form();
    return ++level_.by_integers_, question(*exact_) == Answer::yes;
  }
  bool lies(bool above) {
    return is_true([&](const auto& f) { return rule_.lies(above, f); });
  }
  bool is_on() { return is_true([&](const auto& f) { return rule_.is_on(f); }); }
  /// By the form of lower degree first, which mostly does.
  bool is_on_side(bool up) { return rule_.lies_by_norm(up, balls_) || lies(up); }
  /// By the rule's forms along d, and by integers for all values of the function.
  bool increases(const auto& rising, const std::array<int, V>& d) {
    Answer answer = Answer::yes;
    for (const auto& form : rising)
      answer = both(answer, [&] { return have_sign(form, 1, Zero::fails); });
    return is_true(answer, [&](const auto& f) {
      return both(rule_.is_defined(f), [&] { return have_sign(increase(f, d), 1, Zero::fails); });
    });
  }

 private:
  /// Multiplied by a power of 2.
  Form<mpz_class> exact_form() const {
    long shift = corners_[0].shift;
    for (const Corner& corner : corners_) shift = std::max(shift, corner.shift);
    std::array<Tensor<mpz_class>, V> tensors;
    std::array<const Tensor<mpz_class>*, V> places;
    for (std::size_t i = 0; i < V; ++i) {
      tensors[i] = corners_[i].exact();
      for (mpz_class& x : tensors[i]) x <<= static_cast<unsigned long>(shift - corners_[i].shift);
      places[i] = &tensors[i];
    }
    return rule_.forms(places);
  }

  const Level& level_;
  const Rule& rule_;
  const std::array<Corner, V>& corners_;
  Form<Ball> balls_;
  std::optional<Form<mpz_class>> exact_;
};

Multiples Level::multiples() const {
  const auto* rule = std::get_if<InvariantRule>(&rule_);
  return rule == nullptr ? Multiples{} : rule->multiples();
}

bool Level::ask(const Corner& corner, const auto& question) const {
  const std::array corners{corner};
  return visit([&](const auto& rule) { return question(Simplex(*this, rule, corners)); });
}

/// Are all corners, and what is between them, in the reach of one?
template <std::size_t V>
bool are_in_reach(const std::array<Corner, V>& corners) {
  const Corner& middle = *std::min_element(corners.begin(), corners.end(),
                                           [](auto& a, auto& b) { return a.reach < b.reach; });
  const Ball square = Ball(middle.reach, 0) * Ball(middle.reach, 0);
  const auto is_in_reach = [&](const Corner& corner) {
    const Ball x = trace(*middle.ball, *corner.ball);
    const Ball room = x * x - square * trace(*corner.ball, *corner.ball);
    return both(has_sign(x, 1, Zero::fails),
                [&] { return has_sign(room, 1, Zero::fails); }) == Answer::yes;
  };
  return middle.reach < HUGE_VAL && std::all_of(corners.begin(), corners.end(), is_in_reach);
}

template <std::size_t V>
Proved<V> Level::prove(const std::array<Corner, V>& corners, bool asks_for_side) const {
  const bool is_crossed =
      !asks_for_side && std::any_of(corners.begin(), corners.end(), [&](const Corner& corner) {
        return corner.above != corners[0].above;
      });
  if (!is_crossed && are_in_reach(corners)) return {Proof::empty, {}, false};
  const auto by = [&]<class Rule>(const Rule& rule) -> Proved<V> {
    Simplex<Rule, V> simplex(*this, rule, corners);
    if (!is_crossed && simplex.is_on_side(corners[0].above))
      return {Proof::empty, {}, !asks_for_side && simplex.took_integers()};
    if (asks_for_side) return {};
    const auto rise = rule.rise(simplex.balls());
    const auto direction = [&](bool within_chart) {
      const auto d = likely_direction<V>(rise, within_chart);
      if (!d) return d;
      // Entries of both signs, so that in some chart moving along d is moving in parallel.
      const auto [low, high] = std::minmax_element(d->begin(), d->end());
      return *low < 0 && *high > 0 ? d : std::nullopt;
    };
    // The form of a level grows along the corners themselves where it is positive.
    const bool within_chart = !is_crossed || std::is_same_v<Rule, InvariantRule>;
    auto d = direction(within_chart);
    if (!d && !within_chart) d = direction(true);
    bool is_proved = d && simplex.increases(rise(*d), *d);
    // Next to a critical value rounding hides from guesses which way is up; across an edge it is known.
    if (V == 2 && is_crossed && !is_proved) {
      d.emplace().fill(-65536), (*d)[corners[1 % V].above ? 1 : 0] = 65536;
      is_proved = simplex.increases(rise(*d), *d);
    }
    return {is_proved ? Proof::monotone : Proof::open, d.value_or(std::array<int, V>{}),
            simplex.took_integers()};
  };
  return visit(by);
}

template Proved<1> Level::prove<1>(const std::array<Corner, 1>&, bool) const;
template Proved<2> Level::prove<2>(const std::array<Corner, 2>&, bool) const;
template Proved<3> Level::prove<3>(const std::array<Corner, 3>&, bool) const;
template Proved<4> Level::prove<4>(const std::array<Corner, 4>&, bool) const;

bool Level::above(const Corner& corner) const {
  return ask(corner, [](auto simplex) { return simplex.lies(true); });
}

double Level::reach(const Corner& corner) const {
  return visit(
      [&](const auto& rule) { return rule.reach(rule.template forms<Ball, 1>({corner.ball})); });
}

bool Level::on_level(const Corner& corner) const {
  return ask(corner, [](auto simplex) { return simplex.is_on(); });
}

}  // namespace certificate
