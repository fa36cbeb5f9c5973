// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Neutral surfaces and degenerate curves of a whole linear field.
#include "dominant_form.hpp"
#include "levels/tensor_sphere.hpp"
#include "topology/checks.hpp"
#include "topology/level_choice.hpp"
#include "topology/signature.hpp"

namespace tensortopo::theory {
namespace {

// The characteristic tensor, if the neutral surface is not singular.
std::optional<Tensor> regular_normal(const Trial& trial, Facts<Rational>& facts) {
  const auto n = characteristic_multiple(trial.field);
  if (!n) return facts.not_applicable(kRankBelow4), std::nullopt;
  if (discriminant_form(deviator(*n)) == 0) {
    return facts.not_applicable("two equal characteristic eigenvalues"), std::nullopt;
  }
  return n;
}

Tensor tensor_of(const Deviator<Integer>& d) { return to_tensor(tensor_cast<Rational>(d)); }

// A random tensor of the span.
Tensor random_tensor(const SpanBasis& basis, Random& random) {
  Tensor t;
  for (const auto& b : basis) t = t + Rational(random.nonzero(9)) * tensor_of(b);
  return t;
}

}  // namespace

void neutral_surface_topology(const Trial& trial, Facts<Rational>& facts) {
  const auto n = regular_normal(trial, facts);
  if (!n) return;
  const auto surface = projective_neutral_surface(span_basis(deviator(*n)));
  if (!surface) return facts.undecided(kBudgetExceeded);
  facts.about([&] { return normal_place(*n) + ": " + text(*surface); });
  facts.configuration({mode_squared(*n)});
  facts.holds("no boundary", surface->boundary_loops == 0);
  facts.holds("number of components", surface->components == facts.claimed_count(1));
  facts.holds("Euler characteristic", surface->euler == facts.claimed_count(-1));
  facts.holds("not orientable", !surface->orientable);
}

// Characteristic tensor diag(1, 1, -2): all of a line of neutral tensors is singular.
Outcome singular_neutral_surface() {
  const Tensor n = {1, 1, -2, 0, 0, 0};
  // A derivative of det along b is <t^2, b>, quadratic in t: zero on the line of all multiples of
  // p first + q second if it is at three of its points.
  const Tensor first = {1, -1, 0, 0, 0, 0}, second = {0, 0, 0, 1, 0, 0};
  for (const Tensor& t : {first, second, first + second}) {
    if (inner(t, n) != 0 || determinant(t) != 0) return Outcome::holds();
    for (const auto& b : span_basis(deviator(n))) {
      if (inner(square(t), tensor_of(b)) != 0) return Outcome::holds();
    }
  }
  return Outcome::violated(normal_place(n) +
                           ": the determinant and all its derivatives in the "
                           "span vanish at p " +
                           text(first) + " + q " + text(second) +
                           ", so the neutral surface crosses itself along a line");
}

void neutral_surface_orientability(const Trial& trial, Facts<Rational>& facts) {
  const auto n = regular_normal(trial, facts);
  if (!n) return;
  Random random = trial.random;
  const SpanBasis basis = span_basis(deviator(*n));
  const auto neutral = projective_neutral_surface(basis);
  if (!neutral) return facts.undecided(kBudgetExceeded);
  facts.about([&] { return normal_place(*n) + ", mode 0: " + text(*neutral); });
  facts.holds("the neutral surface is not orientable", !neutral->orientable);
  // A second reason: the determinant changes its sign with the tensor's. So over the neutral
  // surface the sides are the sheets of its double cover on the sphere; the cover is connected, and
  // a path in it leads from one side to the other.
  const auto cover = sphere_surface(basis, ModeLevel::neutral());
  if (!cover) return facts.undecided(kBudgetExceeded);
  facts.about([&] { return normal_place(*n) + ", double cover: " + text(*cover); });
  facts.holds("components of the cover", cover->components == facts.claimed_count(1));
  facts.holds("Euler characteristic of the cover", cover->euler == 2 * neutral->euler);
  const Tensor t = random_tensor(basis, random), opposite = Rational(-1) * t;
  facts.equal("determinant of the opposite tensor", determinant(opposite), -determinant(t));
  const LevelChoice choice = level_choice(*n, random);
  facts.configuration({mode_squared(*n), choice.below.value_or(0), choice.above.value_or(0)});
  // In space: a level separates larger modes from smaller ones, so nothing is one-sided.
  for (const auto& parameter :
       {std::optional(Rational(0)), std::optional(fraction(random.integer(20, 900), 1009))}) {
    const auto inside =
        tetrahedron_surface(trial.field.vertex, ModeLevel::of_parameter(*parameter));
    if (!inside) return facts.undecided(kBudgetExceeded);
    facts.about(
        [&] { return "in the tetrahedron, s = " + parameter->str() + ": " + text(*inside); });
    facts.holds("orientable in space", inside->orientable);
  }
  for (const auto& parameter : {choice.below, choice.above}) {
    if (!parameter) continue;
    const ModeLevel level = ModeLevel::of_parameter(*parameter);
    const auto surface = sphere_surface(basis, level);
    if (!surface) return facts.undecided(kBudgetExceeded);
    facts.about(
        [&] { return normal_place(*n) + ", s = " + parameter->str() + ": " + text(*surface); });
    // Of t and -t one has mode mu if the other has -mu: this is the surface itself, no cover.
    facts.holds("orientable", surface->orientable);
    facts.equal("mode^2 of the opposite tensor", mode_squared(opposite), mode_squared(t));
  }
}

void degenerate_curve_circle(const Trial& trial, Facts<Rational>& facts) {
  const auto n = characteristic_multiple(trial.field);
  if (!n) return facts.not_applicable(kRankBelow4);
  if (determinant(*n) == 0) return facts.not_applicable("characteristic determinant 0");
  // A degenerate tensor is a multiple of e e^T - |e|^2 / 3 for one line e, and in the span if and
  // only if e.N e = 0: a conic. With real points and not degenerate, it is a circle.
  facts.configuration({mode_squared(*n)});
  const Signature form =
      signature({{n->xx, n->xy, n->xz}, {n->xy, n->yy, n->yz}, {n->xz, n->yz, n->zz}});
  facts.about([&] { return normal_place(*n); });
  facts.holds("positive squares of the conic", form.positive == facts.claimed_count(2));
  facts.holds("negative squares of the conic", form.negative == facts.claimed_count(1));
  Random random = trial.random;
  const Vector3<Rational> e = {Rational(random.nonzero(9)), Rational(random.integer(-9, 9)),
                               Rational(random.integer(-9, 9))};
  const Tensor t = projection_to(e) - isotropic(Rational(dot(e, e) / Rational(3)));
  facts.zero("discriminant of e e^T - |e|^2 / 3", discriminant_form(deviator(t)));
  facts.equal("its product with the characteristic tensor", inner(t, *n), dot(e, *n * e));
}

// Characteristic tensor diag(1, 0, -1): the conic is a pair of lines.
Outcome two_degenerate_conics() {
  const Tensor n = {1, 0, -1, 0, 0, 0};
  const auto on_conic = [&](const Vector3<Rational>& e) { return dot(e, n * e) == 0; };
  // A quadratic form is zero on a line if it is at three of its points; both lines hold (0, 1, 0).
  for (const int sign : {1, -1}) {
    const Vector3<Rational> e = {1, 0, sign}, kernel = {0, 1, 0};
    if (!on_conic(e) || !on_conic(kernel) || !on_conic(e + kernel)) return Outcome::holds();
  }
  return Outcome::violated(normal_place(n) +
                           ": e e^T - |e|^2 / 3 is in the span for all e = (p, q, p) and all e = "
                           "(p, q, -p), two circles that meet in e = (0, 1, 0)");
}

}  // namespace tensortopo::theory
