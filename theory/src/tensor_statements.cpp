// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The mode of one tensor.
#include <array>

#include "groups.hpp"
#include "tensortopo/scalar/sign.hpp"
#include "tensortopo/tensor/mode.hpp"
#include "tensortopo/tensor/mode_parameter.hpp"
#include "tensortopo/theory/checks.hpp"

namespace tensortopo::theory {
namespace {

using Tensor = SymmetricTensor<Rational>;

Rational cube(const Rational& x) { return x * x * x; }

// The paper's definition, squared: mode^2 = 54 det^2 / |T|^6.
Rational mode_squared(const Tensor& t) {
  const Rational det = determinant(t);
  return Rational(54) * det * det / cube(inner(t, t));
}

// Eigenvalues of mode +mu(s), up to a positive factor (design of the parameter: notation.md).
std::array<Rational, 3> eigenvalues_of(const Rational& s) {
  return {Rational(3) + s, Rational(-2) * s, s - Rational(3)};
}

// What the trigonometric formula for the eigenvalues says without arcs: with y = sqrt(3/2) times
// an eigenvalue of the unit tensor, sin(3 x) = 3 y - 4 y^3 = -mu, and the range of each x.
bool satisfies_trigonometric_formula(const std::array<Rational, 3>& l, const Rational& mu_squared,
                                     Sign mu_sign) {
  const Rational size = l[0] * l[0] + l[1] * l[1] + l[2] * l[2];
  const Rational quarter = Rational(1) / Rational(4);
  for (std::size_t i = 0; i < 3; ++i) {
    const Rational y2 = Rational(3) * l[i] * l[i] / (Rational(2) * size);
    const Rational factor = Rational(3) - Rational(4) * y2;
    if (y2 * factor * factor != mu_squared) return false;
    if (sign_of(l[i]) * sign_of(factor) != -mu_sign) return false;
    if (i == 1 ? y2 > quarter : y2 < quarter) return false;
  }
  return l[0] > 0 && l[2] < 0;
}

Outcome check_extreme_modes(const Trial& trial) {
  Random random = trial.random;
  const Basis basis = random_basis(random);
  const Rational k(random.nonzero(9));
  // One eigenvalue 2 k, twice -k: linear for k > 0, planar for k < 0.
  const Tensor degenerate = tensor_of({Rational(2) * k, -k, -k}, basis);
  if (mode_squared(degenerate) != 1 || sign_of(determinant(degenerate)) != sign_of(k)) {
    return Outcome::violated("degenerate " + text(degenerate));
  }
  const Tensor neutral = tensor_of({k, Rational(0), -k}, basis);
  if (determinant(neutral) != 0) return Outcome::violated("neutral " + text(neutral));
  // The other way round: a tensor of mode +-1 satisfies (T - r)(T + 2 r) = 0, r its repeated
  // eigenvalue -3 det / |T|^2, and no other tensor does.
  for (const Tensor& t : {degenerate, neutral, tensor_at_random_point(trial, random)}) {
    const Rational size = inner(t, t);
    if (size == 0) continue;
    const Rational r = Rational(-3) * determinant(t) / size, rr = Rational(2) * r * r;
    const Tensor product = square(t) + r * t - Tensor{rr, rr, rr, 0, 0, 0};
    if ((mode_squared(t) == 1) != (product == Tensor{})) return Outcome::violated(text(t));
  }
  return Outcome::holds();
}

Outcome check_eigenvalues(const Trial& trial) {
  Random random = trial.random;
  const Rational s = random.part();
  std::array<Rational, 3> l = eigenvalues_of(s);
  const Tensor t = tensor_of(l, random_basis(random));
  const Rational mu_squared = mode_squared(t);
  const Sign sign = sign_of(determinant(t));
  const std::array<Rational, 3> opposite = {-l[2], -l[1], -l[0]};
  if (satisfies_trigonometric_formula(l, mu_squared, sign) &&
      satisfies_trigonometric_formula(opposite, mu_squared, -sign)) {
    return Outcome::holds();
  }
  return Outcome::violated("s = " + s.str() + ", tensor " + text(t));
}

// As printed, with the mode at the point in place of the mode asked for: a neutral tensor passes.
Outcome printed_equation_at_neutral_tensor() {
  const Tensor t = {1, 0, -1, 0, 0, 0};
  const Rational det = determinant(t);
  const Rational printed = Rational(54) * det * det - mode_squared(t) * cube(inner(t, t));
  const Rational asked = mode_squared_from_s2(Rational(Rational(1) / Rational(16)));
  if (printed != 0 || mode_squared(t) == asked) return Outcome::holds();
  return Outcome::violated("neutral tensor " + text(t) +
                           " satisfies the printed equation, as every tensor does, "
                           "and is not of mode 143/343 or -143/343");
}

}  // namespace

Check check_mode_range(const Rational& factor) {
  return [factor](const Trial& trial) {
    Random random = trial.random;
    const Tensor general = tensor_at_random_point(trial, random);
    const Basis basis = random_basis(random);
    // Tensors at an end of the range too, where a bound that is not sharp shows.
    const Tensor linear = tensor_of({Rational(2), Rational(-1), Rational(-1)}, basis);
    for (const Tensor& t : {general, linear, Rational(-1) * linear}) {
      const Rational det = determinant(t);
      if (factor * det * det > cube(inner(t, t))) return Outcome::violated(text(t));
    }
    const bool sharp =
        factor * determinant(linear) * determinant(linear) == cube(inner(linear, linear));
    return sharp ? Outcome::holds() : Outcome::violated("not attained at " + text(linear));
  };
}

Check check_discriminant(const Rational& factor) {
  return [factor](const Trial& trial) {
    Random random = trial.random;
    const Rational p = random.fraction(), q = random.fraction(), r = -(p + q);
    const Tensor known = tensor_of({p, q, r}, random_basis(random));
    const Rational product = (p - q) * (q - r) * (r - p);
    if (discriminant_form(deviator(known)) != product * product) {
      return Outcome::violated("discriminant of " + text(known));
    }
    for (const Tensor& t : {known, tensor_at_random_point(trial, random)}) {
      const Rational det = determinant(t);
      const Rational left = cube(inner(t, t)) - factor * det * det;
      if (left != Rational(2) * discriminant_form(deviator(t))) return Outcome::violated(text(t));
    }
    return Outcome::holds();
  };
}

Check check_mode_parameter(const Rational& nine) {
  return [nine](const Trial& trial) {
    Random random = trial.random;
    const auto formula = [&](const Rational& s2) {
      return Rational(s2 * (nine - s2) * (nine - s2) / cube(Rational(3) + s2));
    };
    const Rational s = random.part(), other = random.part();
    const std::array<Rational, 3> l = eigenvalues_of(s);
    const Tensor t = tensor_of(l, random_basis(random));
    const std::string witness = "s = " + s.str() + ", tensor " + text(t);
    if (mode_squared(t) != formula(s * s)) return Outcome::violated(witness);
    if (sign_of(determinant(t)) != sign_of(s)) return Outcome::violated(witness);
    if (Rational(-3) * l[1] != s * (l[0] - l[2])) return Outcome::violated(witness);
    if ((s < other) != (formula(s * s) < formula(other * other))) {
      return Outcome::violated("not increasing between s = " + s.str() + " and " + other.str());
    }
    return Outcome::holds();
  };
}

Check check_degree_six_equation(const Rational& factor) {
  return [factor](const Trial& trial) {
    Random random = trial.random;
    const Rational s = random.part(), other = random.part();
    const Rational mu_squared = mode_squared_from_s2(Rational(s * s));
    const auto satisfies = [&](const Tensor& t) {
      const Rational det = determinant(t);
      return factor * det * det == mu_squared * cube(inner(t, t));
    };
    const Basis basis = random_basis(random);
    const Tensor on = tensor_of(eigenvalues_of(s), basis);
    const Tensor off = tensor_of(eigenvalues_of(other), basis);
    const std::string words = "mode parameter s = " + s.str() + ", tensor ";
    for (const Rational& scale : {Rational(1), Rational(-1), Rational(random.nonzero(9))}) {
      if (!satisfies(scale * on)) return Outcome::violated(words + text(scale * on));
      if (satisfies(scale * off) != (s == other)) return Outcome::violated(words + text(off));
    }
    const Tensor t = tensor_at_random_point(trial, random);
    if (inner(t, t) != 0 && satisfies(t) != (mode_squared(t) == mu_squared)) {
      return Outcome::violated(words + text(t));
    }
    return Outcome::holds();
  };
}

std::vector<Statement> tensor_statements() {
  return {
      {"mode-range",
       "3D Tensors and Modes, definition of the mode",
       "The mode of a tensor lies between -1 and 1.",
       "a nonzero traceless tensor",
       "",
       check_mode_range(),
       {}},
      {"mode-extremes",
       "3D Tensors and Modes, special modes",
       "Mode 1 means linear degenerate, mode -1 planar degenerate, mode 0 neutral.",
       "a nonzero traceless tensor",
       "",
       check_extreme_modes,
       {}},
      {"eigenvalues-of-mode",
       "3D Tensors and Modes, eigenvalues in terms of the mode",
       "The eigenvalues of a unit tensor are sines of thirds of the arc sine of minus its mode.",
       "eigenvalues (3 + s, -2 s, s - 3) or their opposites, 0 <= s <= 1 rational",
       "",
       check_eigenvalues,
       {}},
      {"mode-parameter",
       "none (sine of the angle of Theorem 1)",
       "With s = sin(theta) the eigenvalues are as (3 + s, -2 s, s - 3), and the mode is "
       "s (9 - s^2) / (3 + s^2)^(3/2), increasing on [0, 1].",
       "0 <= s <= 1 rational",
       "",
       check_mode_parameter(),
       {}},
      {"discriminant",
       "none",
       "|T|^6 - 54 det(T)^2 is twice the product of the squared differences of eigenvalues.",
       "a traceless tensor",
       "",
       check_discriminant(),
       {}},
      {"degree-six-equation", "Mode Surfaces Analysis, degree-six equation",
       "The points of mode mu or -mu satisfy 54 det(T)^2 - mu(T)^2 |T|^6 = 0, in which mu(T) is "
       "the mode at the point.",
       "T nonzero; mu of a rational parameter s",
       "The constant mu in place of mu(T); and T = 0, which has no mode, satisfies it too.",
       check_degree_six_equation(), printed_equation_at_neutral_tensor},
  };
}

}  // namespace tensortopo::theory
