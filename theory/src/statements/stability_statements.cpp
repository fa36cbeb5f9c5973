// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// How far the mode of a field can be from that of a field close to it.
#include <algorithm>

#include "groups.hpp"
#include "tensors.hpp"

namespace tensortopo::theory {
namespace {

// The signed Lode angle f = arcsin(mode) / 3 of a tensor of parameter s, of either sign, has
// tan f = s / sqrt(3). Squares of sines and cosines of differences are then rational.
Rational squared_sine_of_difference(const Rational& s, const Rational& t) {
  const Rational three(3), gap = s - t;
  return three * gap * gap / ((three + s * s) * (three + t * t));
}

Rational signed_part(Random& random) {
  const Rational part = random.part();
  return random.integer(0, 1) == 0 ? part : Rational(-part);
}

const auto perturbed_angle = [](const Trial& trial, auto& facts) {
  Random random = trial.random;
  const Tensor exact = tensor_at_random_point(trial, random);
  const Tensor other =
      exact + fraction(1, random.integer(1, 30)) * tensor_at_random_point(trial, random);
  const Tensor step = exact - other;
  if (inner(step, step) >= inner(exact, exact)) {
    return facts.not_applicable("a step that is not shorter than the deviator");
  }
  facts.configuration({Rational(inner(step, step) / inner(exact, exact)),
                       Rational(inner(exact, other) / inner(exact, exact))});
  const auto d = facts.tensor(exact), e = facts.tensor(other), by = facts.tensor(step);
  const auto product = inner(d, e), one = facts.claimed(1);
  facts.about([&] { return text(exact) + " and " + text(other); });
  facts.positive("cosine of the angle", product);
  facts.not_negative(
      "squared sine of the angle against e^2 / |D|^2",
      one * inner(by, by) * inner(e, e) - (inner(d, d) * inner(e, e) - squared(product)));
  // The nearest point of the other's ray attains the bound.
  const Tensor nearest = Rational(inner(exact, other) / inner(other, other)) * other;
  const auto rest = d - facts.tensor(nearest);
  facts.equal("squared distance of the nearest point", one * inner(rest, rest) * inner(e, e),
              inner(d, d) * inner(e, e) - squared(product));
};

const auto perturbed_mode = [](const Trial& trial, auto& facts) {
  Random random = trial.random;
  const Rational s = signed_part(random), t = signed_part(random);
  const Basis basis = random_basis(random);
  const Tensor exact = tensor_of(eigenvalues_of(s), basis);
  // A tensor of the other parameter with any eigenvectors and size, and one on the same
  // eigenvectors, as close as its ray comes.
  const Tensor turned =
      fraction(random.integer(1, 40), 20) * tensor_of(eigenvalues_of(t), random_basis(random));
  const Tensor aligned = tensor_of(eigenvalues_of(t), basis);
  const Tensor nearest = Rational(inner(exact, aligned) / inner(aligned, aligned)) * aligned;
  facts.configuration({s, t, Rational(inner(exact, turned) / inner(turned, turned))});
  const auto one = facts.claimed(1);
  const auto sine = facts.number(squared_sine_of_difference(s, t));
  const auto bound = [&](const Tensor& other) {
    const Tensor step = exact - other;
    return facts.number(Rational(inner(step, step) / inner(exact, exact)));
  };
  facts.about([&] { return text(exact) + " and " + text(turned); });
  if (inner(exact - turned, exact - turned) < inner(exact, exact)) {
    facts.not_negative("e^2 / |D|^2 less the squared sine of the difference",
                       one * bound(turned) - sine);
  }
  facts.about([&] { return text(exact) + " and " + text(nearest); });
  facts.equal("the same for the nearest tensor on the same eigenvectors", one * bound(nearest),
              sine);
};

// -t D, t > 0, is (1 + t) |D| away and has the opposite mode.
Outcome isotropic_within_reach() {
  const Tensor d = {2, -1, -1, 0, 0, 0};
  const Tensor other = fraction(-1, 100) * d, step = d - other;
  const bool reached = inner(step, step) == fraction(101 * 101, 100 * 100) * inner(d, d);
  if (!reached || determinant(d) <= 0 || determinant(other) >= 0 || mode_squared(d) != 1 ||
      mode_squared(other) != 1) {
    return Outcome::holds();
  }
  return Outcome::violated("D = " + text(d) + " and D' = " + text(other) +
                           ": |D - D'| = 101/100 |D|, mode 1 and mode -1");
}

// 10 A and -10 A become 11 A and -9 A: a tenth of each. In between mode -1 becomes mode 1.
Outcome relative_at_vertices_only() {
  const Tensor a = {2, -1, -1, 0, 0, 0};
  const Rational w = fraction(21, 40), rest = Rational(1) - w;
  const Tensor before = rest * (Rational(10) * a) + w * (Rational(-10) * a);
  const Tensor after = rest * (Rational(11) * a) + w * (Rational(-9) * a);
  if (determinant(before) >= 0 || determinant(after) <= 0) return Outcome::holds();
  return Outcome::violated("ends 10 A and -10 A, A = " + text(a) +
                           ", become 11 A and -9 A, a tenth of each: at weight 21/40 of the second "
                           "end mode -1 becomes mode 1");
}

// Maxima of a sequence, each with its persistence: by how much, in terms of `is_more_than`, it
// exceeds the higher one of the two levels at which it meets larger maxima. Counts those for which
// that is so; the largest one always counts.
template <class IsMore>
int lasting_maxima(const std::vector<Rational>& s, const IsMore& is_more) {
  int count = 0;
  for (std::size_t i = 0; i < s.size(); ++i) {
    const auto is_larger = [&](std::size_t k) { return s[k] > s[i] || (s[k] == s[i] && k < i); };
    const bool is_maximum =
        (i == 0 || !is_larger(i - 1)) && (i + 1 == s.size() || !is_larger(i + 1));
    if (!is_maximum) continue;
    std::optional<Rational> left, right;
    Rational least = s[i];
    for (std::size_t k = i; k-- > 0;) {
      least = std::min(least, s[k]);
      if (is_larger(k)) {
        left = least;
        break;
      }
    }
    least = s[i];
    for (std::size_t k = i + 1; k < s.size(); ++k) {
      least = std::min(least, s[k]);
      if (is_larger(k)) {
        right = least;
        break;
      }
    }
    if (!left && !right) {
      ++count;
      continue;
    }
    const Rational merged = !left ? *right : !right ? *left : std::max(*left, *right);
    count += is_more(s[i], merged) ? 1 : 0;
  }
  return count;
}

void lasting_features(const Trial& trial, Facts<Rational>& facts) {
  Random random = trial.random;
  // A path of tensors; on each edge the mode is taken as monotone, which makes it a function given
  // by the parameters at its vertices.
  const Basis basis = random_basis(random);
  const int m = random.integer(3, 12);
  // sin(bound) = 2 k / (1 + k^2), k = 1/m: so its cosine is rational too.
  const Rational k = fraction(1, m), size = Rational(1) + k * k, radius = (k + k) / size,
                 cosine = (Rational(1) - k * k) / size;
  const Rational twice = facts.claimed(2);
  const Rational sine_of_twice = twice * radius * cosine;
  facts.equal("sine of twice the bound", sine_of_twice * size * size,
              Rational(4) * k * (Rational(1) - k * k));
  std::vector<Rational> before, after;
  std::vector<Rational> numbers = {radius};
  for (int i = 0; i < 9; ++i) {
    const Rational s = signed_part(random);
    const Tensor d = tensor_of(eigenvalues_of(s), basis);
    // The nearest tensor of another parameter, if it is within the radius.
    Rational t = signed_part(random);
    for (int step = 0; step < 12 && squared_sine_of_difference(s, t) > radius * radius; ++step) {
      t = (s + t) / Rational(2);
    }
    if (squared_sine_of_difference(s, t) > radius * radius) t = s;
    const Tensor aligned = tensor_of(eigenvalues_of(t), basis);
    const Tensor other = Rational(inner(d, aligned) / inner(aligned, aligned)) * aligned;
    facts.about([&] { return text(d) + " and " + text(other); });
    facts.not_negative("within the radius",
                       radius * radius * inner(d, d) - inner(d - other, d - other));
    before.push_back(s), after.push_back(t);
    numbers.push_back(s), numbers.push_back(t);
  }
  facts.configuration(numbers);
  const auto by_more_than_twice = [&](const Rational& s, const Rational& t) {
    return squared_sine_of_difference(s, t) > sine_of_twice * sine_of_twice;
  };
  const auto at_all = [](const Rational& s, const Rational& t) { return s > t; };
  facts.about([&] { return "radius " + radius.str(); });
  // Differences of signed Lode angles are at most 60 degrees, and twice the bound below 90.
  facts.positive("cosine of twice the bound", cosine * cosine - radius * radius);
  facts.holds("maxima of persistence above twice the bound are maxima of the other field",
              lasting_maxima(before, by_more_than_twice) <= lasting_maxima(after, at_all));
  facts.holds("and the other way round",
              lasting_maxima(after, by_more_than_twice) <= lasting_maxima(before, at_all));
  // A maximum of just less than twice the bound need not last: 0, x, 0, x becomes flat.
  const std::vector<Rational> bump = {Rational(0), fraction(1, 10), Rational(0), fraction(1, 10)},
                              flat = {fraction(1, 20), fraction(1, 20), fraction(1, 20),
                                      fraction(1, 20)};
  facts.holds(
      "two maxima that become one",
      lasting_maxima(bump, at_all) == facts.claimed_count(2) && lasting_maxima(flat, at_all) == 1);
  facts.positive("within more than half of their persistence",
                 squared_sine_of_difference(fraction(1, 10), Rational(0)) -
                     squared_sine_of_difference(fraction(1, 20), Rational(0)));
}

}  // namespace

std::vector<Statement> stability_statements() {
  return {
      {.id = "perturbed-angle",
       .paper = "none (fields close to a field)",
       .claim = "Deviators D and D' with |D - D'| <= e < |D| are at most arcsin(e / |D|) apart, as "
                "vectors; the nearest point of a ray attains this.",
       .hypotheses = "D a deviator, |D - D'| < |D|",
       .special = "|D| <= e, isotropic points above all: then D' can have any mode, or vanish.",
       .check = perturbed_angle,
       .needed = {{"e < |D|", isotropic_within_reach}},
       .steps = {"perturbed-acute", "perturbed-angle", "perturbed-attained",
                 "perturbed-isotropic"}},
      {.id = "perturbed-mode",
       .paper = "none (fields close to a field)",
       .claim = "Then their signed Lode angles, arcsin(mode) / 3, differ by at most "
                "arcsin(e / |D|); tensors on the same eigenvectors attain this.",
       .hypotheses = "parameters of either sign, |D - D'| < |D|",
       .sharper = "Coq has checked the bound: the theorem stability of lode-screen.",
       .special = "e is a bound at the point. Deviators changed by at most e_i at vertices change "
                  "by at most the interpolated e_i between; but r |D_i| at vertices is no bound by "
                  "r |D| between them.",
       .check = perturbed_mode,
       .needed = {{"a radius relative to |D| at the point itself", relative_at_vertices_only}},
       .steps = {"signed-lode-angle", "rearrangement", "distance-of-tensors", "perturbed-between",
                 "perturbed-relative"}},
      {.id = "lasting-features",
       .paper = "none (fields close to a field)",
       .claim = "If f and f' are continuous on one compact domain and have |D - D'| <= e < |D| at "
                "all its points, and b is the largest arcsin(e / |D|), their persistence diagrams, "
                "in the signed Lode angle, differ by at most b: a component of a superlevel or sublevel set whose persistence is more "
                "than 2 b has a counterpart in f'.",
       .hypotheses = "a path of nine tensors and one of tensors within a relative radius of them",
       .special = "Where |D| <= e nothing is said: an open set that holds such points is to be left "
                  "out, so that the domain is compact. 2 b cannot be made smaller.",
       .check = lasting_features,
       .steps = {"perturbed-angle", "signed-lode-angle"},
       .reader = "Functions that differ by at most b have diagrams within b of each other "
                 "(Cohen-Steiner, Edelsbrunner and Harer 2007); the signed Lode angle "
                 "increases with the mode, so both have the same levels, components and handles. "
                 "Tried are components on a path only."},
  };
}

}  // namespace tensortopo::theory
