// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The mode of one tensor.
#include "groups.hpp"
#include "tensors.hpp"

namespace tensortopo::theory {
namespace {

const auto mode_range = [](const Trial& trial, auto& facts) {
  Random random = trial.random;
  const Tensor general = tensor_at_random_point(trial, random);
  // Tensors at an end of the range too, where a bound that is not sharp shows.
  const Tensor linear = tensor_of({2, -1, -1}, random_basis(random));
  const auto factor = facts.claimed(54);
  const auto slack = [&](const auto& t) {
    return cubed(inner(t, t)) - factor * squared(determinant(t));
  };
  for (const Tensor& t : {general, linear, Rational(-1) * linear}) {
    facts.about([&] { return text(t); });
    facts.not_negative("|T|^6 - 54 det(T)^2", slack(facts.tensor(t)));
  }
  facts.zero("|T|^6 - 54 det(T)^2 of a degenerate tensor", slack(facts.tensor(linear)));
};

const auto extreme_modes = [](const Trial& trial, auto& facts) {
  using Scalar = ScalarOf<std::decay_t<decltype(facts)>>;
  Random random = trial.random;
  const Basis basis = random_basis(random);
  const Rational k(random.nonzero(9));
  // One eigenvalue 2 k, twice -k: linear for k > 0, planar for k < 0.
  const Tensor degenerate = tensor_of({Rational(2) * k, -k, -k}, basis);
  const Tensor neutral = tensor_of({k, Rational(0), -k}, basis);
  facts.about([&] { return text(degenerate); });
  const auto extreme = facts.claimed(1);
  facts.equal("mode^2 of a degenerate tensor", mode_squared(facts.tensor(degenerate)), extreme);
  facts.sign("its determinant", determinant(facts.tensor(degenerate)), sign_of(k));
  facts.zero("determinant of a neutral tensor", determinant(facts.tensor(neutral)));
  // The other way round: with r = -3 det / |T|^2, which is the repeated eigenvalue if there is one,
  // (T - r)(T + 2 r) is zero for the tensors of mode +-1 and for no others.
  const auto twice = facts.claimed(2), thrice = facts.claimed(3);
  for (const Tensor& t : {degenerate, neutral, tensor_at_random_point(trial, random)}) {
    if (inner(t, t) == 0) continue;
    facts.about([&] { return text(t); });
    const auto image = facts.tensor(t);
    const Scalar r = -(thrice * determinant(image) / inner(image, image));
    const auto product = square(image) + r * image - isotropic<Scalar>(twice * r * r);
    if (mode_squared(t) == 1) {
      facts.equal("(T - r)(T + 2 r)", product, isotropic(Scalar(0)));
    } else {
      facts.positive("|(T - r)(T + 2 r)|^2", inner(product, product));
    }
  }
};

// What the trigonometric formula for the eigenvalues says without arcs: with y = sqrt(3/2) times
// an eigenvalue of the unit tensor, sin(3 x) = 3 y - 4 y^3 = -mu, and the range of each x.
const auto eigenvalues = [](const Trial& trial, auto& facts) {
  using Scalar = ScalarOf<std::decay_t<decltype(facts)>>;
  Random random = trial.random;
  const Rational s = random.part();
  const std::array<Rational, 3> upper = eigenvalues_of(s);
  const Tensor exact = tensor_of(upper, random_basis(random));
  facts.configuration({s});
  const auto t = facts.tensor(exact);
  const Scalar mu_squared = mode_squared(t);
  const Scalar three_halves = facts.claimed(3, 2), quarter = facts.claimed(1, 4);
  facts.about([&] { return "s = " + s.str() + ", tensor " + text(exact); });
  for (const bool opposite : {false, true}) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Rational value = opposite ? Rational(-upper[2 - i]) : upper[i];
      const Scalar l = facts.number(value);
      const Scalar y2 = three_halves * l * l / inner(t, t);
      const Scalar factor = Scalar(3) - Scalar(4) * y2;
      facts.equal("(3 y - 4 y^3)^2 and mode^2", y2 * squared(factor), mu_squared);
      const Scalar det = opposite ? Scalar(-determinant(t)) : determinant(t);
      facts.same_sign("3 y - 4 y^3 and -mode", l * factor, -det);
      // In the outer thirds of the sine the squares are at least 1/4.
      facts.not_negative("range of y", i == 1 ? quarter - y2 : y2 - quarter);
    }
  }
};

const auto mode_parameter_of = [](const Trial& trial, auto& facts) {
  Random random = trial.random;
  const Rational s = random.part(), other = random.part();
  const Tensor exact = tensor_of(eigenvalues_of(s), random_basis(random));
  facts.configuration({s, other});
  const auto nine = facts.claimed(9), three = facts.claimed(3), minus_three = facts.claimed(-3);
  const auto formula = [&](const auto& x) {
    return squared(x) * squared(nine - squared(x)) / cubed(three + squared(x));
  };
  const auto t = facts.tensor(exact);
  const auto x = facts.number(s), y = facts.number(other);
  facts.about([&] { return "s = " + s.str() + " and " + other.str() + ", " + text(exact); });
  facts.equal("mode^2 as a function of s", mode_squared(t), formula(x));
  facts.sign("determinant", determinant(t), sign_of(s));
  const auto l = eigenvalues_of(s);
  facts.equal("s from the eigenvalues", minus_three * facts.number(l[1]),
              x * (facts.number(l[0]) - facts.number(l[2])));
  facts.sign("growth of mode^2 with s", formula(y) - formula(x), sign_of(Rational(other - s)));
};

const auto discriminant = [](const Trial& trial, auto& facts) {
  Random random = trial.random;
  const Rational p = random.fraction(), q = random.fraction(), r = -(p + q);
  const Tensor known = tensor_of({p, q, r}, random_basis(random));
  const auto factor = facts.claimed(54), twice = facts.claimed(2);
  facts.about([&] { return text(known); });
  facts.equal("discriminant as a sum of squares", discriminant_form(deviator(facts.tensor(known))),
              facts.number(squared(Rational((p - q) * (q - r) * (r - p)))));
  for (const Tensor& exact : {known, tensor_at_random_point(trial, random)}) {
    facts.about([&] { return text(exact); });
    const auto t = facts.tensor(exact);
    const auto form = discriminant_form(deviator(t));
    facts.equal("|T|^6 - 54 det(T)^2 and twice the discriminant",
                cubed(inner(t, t)) - factor * squared(determinant(t)), twice * form);
    facts.not_negative("the discriminant", form);
  }
};

const auto degree_six_equation = [](const Trial& trial, auto& facts) {
  Random random = trial.random;
  const Rational s = random.part(), other = random.part();
  facts.configuration({s, other});
  const auto mu_squared = facts.number(mode_squared_from_s2(Rational(s * s)));
  const auto factor = facts.claimed(54);
  const auto form = [&](const Tensor& exact) {
    const auto t = facts.tensor(exact);
    return factor * squared(determinant(t)) - mu_squared * cubed(inner(t, t));
  };
  const Basis basis = random_basis(random);
  const Tensor on = tensor_of(eigenvalues_of(s), basis);
  const Tensor off = tensor_of(eigenvalues_of(other), basis);
  facts.about([&] { return "s = " + s.str() + " and " + other.str() + ", tensor " + text(on); });
  for (const Rational& scale : {Rational(1), Rational(-1), Rational(random.nonzero(9))}) {
    facts.zero("the form at a tensor of mode mu or -mu", form(scale * on));
    facts.sign("the form at a tensor of another mode", form(scale * off),
               sign_of(Rational(other - s)));
  }
};

// As printed, with the mode at the point in place of the mode asked for: a neutral tensor passes.
Outcome printed_equation_at_neutral_tensor() {
  const Tensor t = {1, 0, -1, 0, 0, 0};
  const Rational printed =
      Rational(54) * squared(determinant(t)) - mode_squared(t) * cubed(inner(t, t));
  const Rational asked = mode_squared_from_s2(fraction(1, 16));
  if (printed != 0 || mode_squared(t) == asked) return Outcome::holds();
  return Outcome::violated("neutral tensor " + text(t) +
                           " satisfies the printed equation, as every tensor does, "
                           "and is not of mode 143/343 or -143/343");
}

// The difference of some order of a sequence: zero for polynomials of a lower degree.
template <class Scalar, class Function>
Scalar difference(int order, const Function& value_at) {
  Scalar sum(0);
  int binomial = 1;
  for (int k = 0; k <= order; ++k) {
    const Scalar term = Scalar((order - k) % 2 == 0 ? binomial : -binomial) * value_at(k);
    sum = sum + term;
    binomial = binomial * (order - k) / (k + 1);
  }
  return sum;
}

const auto rational_mode = [](const Trial& trial, auto& facts) {
  using Scalar = ScalarOf<std::decay_t<decltype(facts)>>;
  Random random = trial.random;
  const Tensor from = tensor_at_random_point(trial, random);
  const Tensor along = tensor_at_random_point(trial, random);
  if (inner(along, along) == 0) return facts.not_applicable("a zero tensor was drawn");
  const auto on_line = [&](int k) { return facts.tensor(from + Rational(k) * along); };
  const auto numerator = [&](int k) { return squared(determinant(on_line(k))); };
  const auto denominator = [&](int k) {
    const auto t = on_line(k);
    return cubed(inner(t, t));
  };
  const int degree = facts.claimed_count(6);
  facts.about([&] { return "along " + text(from) + " + k " + text(along); });
  facts.zero("difference of det(T)^2 above its degree", difference<Scalar>(degree + 1, numerator));
  facts.zero("difference of |T|^6 above its degree", difference<Scalar>(degree + 1, denominator));
  facts.positive("leading coefficient of |T|^6", difference<Scalar>(degree, denominator));
};

// The square of a polynomial of degree six would have the degree twelve.
Outcome not_a_polynomial() {
  const Tensor from = {1, 0, -1, 0, 0, 0}, along = {0, 1, -1, 0, 0, 0};
  const Rational rest = difference<Rational>(
      13, [&](int k) { return mode_squared(Tensor(from + Rational(k) * along)); });
  if (rest == 0) return Outcome::holds();
  return Outcome::violated("along " + text(from) + " + k " + text(along) +
                           ": the difference of order 13 of mode^2 is not 0");
}

const auto lode_screen = [](const Trial& trial, auto& facts) {
  Random random = trial.random;
  const auto signed_part = [&] {
    const Rational part = random.part();
    return random.integer(0, 1) == 0 ? part : Rational(-part);
  };
  const Rational s = signed_part(), other = signed_part();
  const Basis basis = random_basis(random);
  const Tensor exact = tensor_of(eigenvalues_of(s), basis);
  const Tensor turned = tensor_of(eigenvalues_of(other), random_basis(random));
  const Tensor aligned = tensor_of(eigenvalues_of(other), basis);
  facts.configuration({s, other, inner(exact, turned), inner(square(exact), turned)});
  const auto t = facts.tensor(exact);
  facts.about([&] { return text(exact) + " and " + text(turned); });
  // Vectors of ordered eigenvalues are 3 (1, 0, -1) + s (1, -2, 1): polar angle atan(s / sqrt(3)),
  // a third of the arc sine of the mode; and alignment of the eigenvectors is the best there is.
  const auto product = facts.claimed(18) + facts.claimed(6) * facts.number(s) * facts.number(other);
  facts.equal("inner product of tensors with common eigenvectors", inner(t, facts.tensor(aligned)),
              product);
  facts.not_negative("what turning the eigenvectors takes from the inner product",
                     product - inner(t, facts.tensor(turned)));
};

}  // namespace

std::vector<Statement> tensor_statements() {
  return {
      {.id = "mode-range",
       .paper = "3D Tensors and Modes, definition of the mode",
       .claim = "The mode of a tensor lies between -1 and 1.",
       .hypotheses = "a nonzero traceless tensor",
       .sharper = "Both ends are attained, by the degenerate tensors.",
       .special = "The zero tensor has no mode.",
       .check = mode_range,
       .steps = {"mode-range", "discriminant-gram", "discriminant-squares"}},
      {.id = "mode-extremes",
       .paper = "3D Tensors and Modes, special modes",
       .claim = "Mode 1 means linear degenerate, mode -1 planar degenerate, mode 0 neutral.",
       .hypotheses = "a nonzero traceless tensor",
       .check = extreme_modes,
       .steps = {"mode-ends", "discriminant-eigenvalues"}},
      {.id = "eigenvalues-of-mode",
       .paper = "3D Tensors and Modes, eigenvalues in terms of the mode",
       .claim = "The eigenvalues of a unit tensor are sines of thirds of the arc sine of minus its "
                "mode.",
       .hypotheses = "eigenvalues (3 + s, -2 s, s - 3) or their opposites, 0 <= s <= 1 rational",
       .check = eigenvalues,
       .steps = {"trigonometric-eigenvalues", "eigenvalues-ordered"}},
      {.id = "mode-parameter",
       .paper = "none (sine of the angle of Theorem 1)",
       .claim = "With s = sin(theta) the eigenvalues are as (3 + s, -2 s, s - 3), and the mode is "
                "s (9 - s^2) / (3 + s^2)^(3/2), increasing on [0, 1].",
       .hypotheses = "0 <= s <= 1 rational",
       .check = mode_parameter_of,
       .steps = {"mode-parameter-eigenvalues", "mode-parameter", "mode-parameter-inverse",
                 "mode-grows"}},
      {.id = "discriminant",
       .paper = "none",
       .claim = "|T|^6 - 54 det(T)^2 is twice the product of the squared differences of "
                "eigenvalues.",
       .hypotheses = "a traceless tensor",
       .check = discriminant,
       .steps = {"discriminant-eigenvalues", "discriminant-gram", "discriminant-squares"}},
      {.id = "lode-screen",
       .paper = "none (rules out cells without a surface)",
       .claim = "A third of the arc cosine of the mode changes by no more than the angle between "
                "the tensors.",
       .hypotheses = "two tensors with rational eigenvectors",
       .check = lode_screen,
       .steps = {"squared-rotation", "distance-of-tensors", "rearrangement",
                 "angle-of-eigenvalues"}},
      {.id = "degree-six-equation",
       .paper = "Mode Surfaces Analysis, degree-six equation",
       .claim = "The points of mode mu or -mu satisfy 54 det(T)^2 - mu(T)^2 |T|^6 = 0, in which "
                "mu(T) is the mode at the point.",
       .hypotheses = "T nonzero; mu of a rational parameter s",
       .corrected = "The constant mu in place of mu(T); and T = 0, which has no mode, satisfies it "
                    "too.",
       .special =
           "At mu = 0 the form is a square: its roots are double and it does not change sign.",
       .flaws = {Flaw::wording},
       .check = degree_six_equation,
       .paper_at_witness = printed_equation_at_neutral_tensor,
       .steps = {"mode-equation", "degree-six-form"},
       .restates = "the definition of the mode, on tensors made with a given one"},
      {.id = "mode-not-polynomial",
       .paper = "Related Work, the mode as a function",
       .claim = "In a linear field the mode is a polynomial of degree six.",
       .hypotheses = "a line in a linear field, not all of one tensor",
       .corrected =
           "Its square is the quotient of det(T)^2 and |T|^6, both of degree six; the mode "
           "is bounded, and no polynomial unless it is constant.",
       .flaws = {Flaw::wording},
       .check = rational_mode,
       .paper_at_witness = not_a_polynomial,
       .reader = "A bounded quotient that is a polynomial is constant.",
       .restates = "the degrees of det(T) and |T|^2 along a line"},
  };
}

}  // namespace tensortopo::theory
