// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The torus, the double torus, and the surface between them.
#include <vector>

#include "dominant_form.hpp"
#include "levels/tensor_sphere.hpp"
#include "plane/critical_points.hpp"
#include "topology/checks.hpp"
#include "topology/level_choice.hpp"
#include "topology/signature.hpp"

namespace tensortopo::theory {
namespace {

using Four = std::array<Tensor, 4>;

Four tensors_of(const SpanBasis& basis) {
  Four result;
  for (std::size_t i = 0; i < 4; ++i) {
    const Deviator<Integer>& b = basis[i];
    result[i] = to_tensor(tensor_cast<Rational>(b));
  }
  return result;
}

// The derivative of det at t along x, from values of det.
Rational determinant_slope(const Tensor& t, const Tensor& x) {
  return (determinant(t + x) - determinant(t - x)) / Rational(2) - determinant(x);
}

// The second derivative of det at t along x and y.
Rational determinant_bend(const Tensor& t, const Tensor& x, const Tensor& y) {
  const auto along = [&](const Tensor& z) {
    return Rational(determinant(t + z) + determinant(t - z) - Rational(2) * determinant(t));
  };
  return (along(x + y) - along(x) - along(y)) / Rational(2);
}

// |t|^5 / 3 sqrt(6) times the derivative of the mode at t along x.
Rational mode_slope(const Tensor& t, const Tensor& x) {
  return inner(t, t) * determinant_slope(t, x) - Rational(3) * determinant(t) * inner(t, x);
}

// t^2 - |t|^2 / 3 - (tr t^3 / |t|^2) t: what a field must be orthogonal to for its mode to be
// critical at t.
Tensor companion(const Tensor& t) {
  const Rational size = inner(t, t);
  return square(t) - isotropic(Rational(size / Rational(3))) -
         Rational(Rational(3) * determinant(t) / size) * t;
}

// Second derivatives of the mode at a critical d, on the tensors of the basis made orthogonal to
// d, up to a positive factor.
std::vector<std::vector<Rational>> mode_bend(const Tensor& d, const Four& basis) {
  Four across;
  for (std::size_t i = 0; i < 4; ++i) {
    across[i] = inner(d, d) * basis[i] - inner(d, basis[i]) * d;
  }
  std::vector<std::vector<Rational>> form(4, std::vector<Rational>(4));
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      form[i][j] = inner(d, d) * determinant_bend(d, across[i], across[j]) -
                   Rational(3) * determinant(d) * inner(across[i], across[j]);
  return form;
}

}  // namespace

std::string normal_place(const Tensor& n) { return "characteristic tensor along " + text(n); }

void bifurcation_topology(const Trial& trial, Facts<Rational>& facts) {
  const auto n = characteristic_multiple(trial.field);
  if (!n) return facts.not_applicable(kRankBelow4);
  const Rational of_normal = mode_squared(*n);
  const Rational sum = facts.claimed(1);
  const int holes_above = facts.claimed_count(1), holes_below = facts.claimed_count(2);
  const int pieces = facts.claimed_count(1);
  if (trial.frame) {
    const auto& l = trial.frame->eigenvalues;
    const Rational s0 = (l[0] - l[1]) / (l[0] + l[1]);
    facts.about([&] { return normal_place(*n); });
    facts.equal("mode^2 of s0 = (l1 - l2) / (l1 + l2), and of the characteristic tensor",
                mode_squared_from_s2(Rational(s0 * s0)) + of_normal, sum);
  }
  Random random = trial.random;
  const LevelChoice choice = level_choice(*n, random);
  const SpanBasis basis = span_basis(deviator(*n));
  // At infinity are the differences of the vertex tensors: a degenerate one among them and, as the
  // determinant is odd, a neutral one; so all modes between, up to their sign.
  const auto& v = trial.field.vertex;
  const auto far = plane_of(TriangleField<Rational>{{v[1] - v[0], v[2] - v[0], v[3] - v[0]}});
  facts.about([&] { return "plane at infinity of " + text(trial.field); });
  facts.holds("independent differences", far.has_value());
  if (far) {
    const DegenerateSystem degenerate = degenerate_system(*far);
    if (degenerate.position == Position::general) {
      facts.holds("degenerate points at infinity", !real_points(*far, degenerate.points).empty());
    }
  }
  facts.configuration({of_normal, choice.below.value_or(0), choice.above.value_or(0)});
  for (const auto& s : {choice.below, choice.above}) {
    if (!s) continue;
    const ModeLevel level = ModeLevel::of_parameter(*s);
    const bool above = level.mu_squared + of_normal > sum;
    const auto surface = sphere_surface(basis, level);
    if (!surface) return facts.undecided(kBudgetExceeded);
    facts.about([&] { return normal_place(*n) + ", s = " + s->str() + ": " + text(*surface); });
    facts.holds("no boundary", surface->boundary_loops == 0);
    facts.holds("orientable", surface->orientable);
    facts.holds("number of components", surface->components == pieces);
    facts.holds("Euler characteristic",
                surface->euler == 2 - 2 * (above ? holes_above : holes_below));
  }
}

// xy - yz and the like have weights of sum 0: they are at infinity. One of mode 0, one of mode^2
// 1/2, and between them, at infinity too, all modes between.
Outcome torus_in_space() {
  const TetrahedronField<Rational> field = witness_field();
  const auto n = characteristic_multiple(field);
  const ModeLevel level{fraction(2, 5), 1};
  const Tensor from = to_tensor(field.at({1, -1, 0, 0})), to = to_tensor(field.at({1, 1, -2, 0}));
  const bool crossed = n && mode_squared(from) < level.mu_squared &&
                       mode_squared(to) > level.mu_squared &&
                       level.mu_squared + mode_squared(*n) > 1;
  if (!crossed) return Outcome::holds();
  const auto surface = sphere_surface(span_basis(deviator(*n)), level);
  if (!surface || surface->components != 1) return Outcome::holds();
  return Outcome::violated(
      "vertex tensors " + text(field) + ", mode^2 = " + level.mu_squared.str() +
      ": the surface has one component and meets the plane at infinity "
      "between " +
      text(from) + " and " + text(to) + ", so no part of it in space is closed");
}

void bifurcation_surface(const Trial& trial, Facts<Rational>& facts) {
  const auto n = characteristic_multiple(trial.field);
  if (!n) return facts.not_applicable(kRankBelow4);
  if (determinant(*n) == 0) return facts.not_applicable("characteristic determinant 0");
  if (discriminant_form(deviator(*n)) == 0) {
    return facts.not_applicable("two equal characteristic eigenvalues");
  }
  facts.configuration({mode_squared(*n)});
  const Four basis = tensors_of(span_basis(deviator(*n)));
  Tensor d = companion(*n);
  if (determinant(d) < 0) d = Rational(-1) * d;
  facts.about([&] { return normal_place(*n); });
  facts.zero("trace of the singular tensor", trace(d));
  facts.zero("<D, characteristic tensor>", inner(d, *n));
  facts.equal("mode^2 of D and of the characteristic tensor", mode_squared(d) + mode_squared(*n),
              facts.claimed(1));
  const Signature bend = signature(mode_bend(d, basis));
  facts.holds("directions in which the mode grows from D", bend.positive == facts.claimed_count(1));
  facts.holds("directions in which it falls", bend.negative == facts.claimed_count(2));
  facts.holds("the ray of D itself", bend.zero == 1);
  for (const Tensor& b : basis) facts.zero("slope of the mode at D", mode_slope(d, b));
  if (trial.frame) {
    const auto& l = trial.frame->eigenvalues;
    const Tensor named =
        tensor_of({l[1] - l[2], l[2] - l[0], l[0] - l[1]}, trial.frame->eigenvectors);
    facts.equal("D is along the tensor of eigenvalues l2 - l3, l3 - l1, l1 - l2",
                squared(inner(d, named)), inner(d, d) * inner(named, named));
  }
  // No other tensor t of the span is critical: the slopes vanish if and only if the companion of t
  // is a multiple k N of the characteristic tensor. If k = 0, t has two equal eigenvalues and is of
  // mode 1 or -1. Otherwise N is a polynomial in t and commutes with it; as N has three
  // eigenvalues, t has its eigenvectors, and in the plane of such traceless tensors D is the one
  // direction across N.
  Random random = trial.random;
  Tensor t;
  for (const Tensor& b : basis) t = t + Rational(random.nonzero(9)) * b;
  const Tensor of_t = companion(t);
  for (const Tensor& b : basis) {
    facts.equal("slope of the mode as a product with the companion", mode_slope(t, b),
                inner(t, t) * inner(of_t, b));
  }
}

}  // namespace tensortopo::theory
