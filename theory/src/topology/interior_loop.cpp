// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// A loop of the complex domain's boundary that meets no face of a tetrahedron.
#include <algorithm>

#include "topology/boundary_curve.hpp"
#include "topology/checks.hpp"
#include "topology/loop_cut.hpp"

namespace tensortopo::theory {
namespace {

// With the loop in the surface of mode +mu; nothing if it is not proved inside.
std::optional<LoopTetrahedron> turned_to_loop(const LoopTetrahedron& t) {
  const int mode = mode_of_loop_inside(t.values, t.s, t.vertices, t.side);
  if (mode == 0) return std::nullopt;
  return mode > 0 ? t : t.opposite();
}

// One third of the diagonal entry across which v lies, and of xz, at the ends of the interval of
// alpha; of the signs of these the mean weights of the two loops are made.
struct EndSigns {
  Rational diagonal, product;
};
EndSigns at_end(const Rational& eigenvalue, const Rational& medium, const Rational& s, int sign) {
  const Rational one(1), alpha = Rational(-2) * eigenvalue / (one + Rational(sign) * s);
  return {eigenvalue + alpha / Rational(2) * (one + s * s / Rational(3)),
          medium + (one - s * s) * alpha / Rational(2)};
}

// No weight has one sign on both loops, nor a sign on each of them.
void at_most_one_loop(const std::array<Rational, 3>& l, const Rational& s, Facts<Rational>& facts) {
  const EndSigns upper = at_end(l[1], l[1], s, 1), lower = at_end(l[1], l[1], s, -1);
  facts.positive("yy of the boundary's tensor at the upper end of alpha", upper.diagonal);
  facts.negative("yy at the lower end", lower.diagonal);
  facts.positive("xz / (x z) at the upper end", upper.product);
  facts.negative("xz / (x z) at the lower end", lower.product);
  // Beyond the critical mode the lower end is across the major eigenvector.
  const Rational critical = (l[0] - l[1]) / (l[0] + l[1]);
  const Rational beyond = (critical + Rational(1)) / Rational(2);
  facts.positive("xx at the lower end above the critical mode",
                 at_end(l[0], l[1], beyond, 1).diagonal);
  facts.positive("yy at the upper end above it", at_end(l[1], l[1], beyond, 1).diagonal);
}

std::optional<std::array<Rational, 3>> drawn_values(const Trial& trial, Random& random) {
  if (trial.frame) return trial.frame->eigenvalues;
  const int high = random.integer(2, 9), middle = random.integer(1, high - 1);
  return std::array{Rational(high), Rational(middle), Rational(-high - middle)};
}

void loop_facts(const LoopTetrahedron& t, const LoopCut& cut, int lost, int joined,
                Facts<Rational>& facts) {
  facts.about([&] { return text(t) + ": " + text(cut.surface); });
  facts.holds("orientable", cut.surface.orientable);
  facts.holds("as many sheets as components, or one more that a tube joins",
              cut.has_handle() || cut.sheets == cut.surface.components + joined);
  // Cut open along the boundary of the complex domain, and the two sides of the loop filled with
  // discs, it is a part of a sphere.
  facts.holds("Euler characteristic two less than that of the filled pieces",
              cut.surface.euler + cut.arcs + lost == 2 * cut.pieces - cut.boundary_loops);
}

}  // namespace

void interior_boundary_loop(const Trial& trial, Facts<Rational>& facts) {
  Random random = trial.random;
  const std::array<Rational, 3> l = *drawn_values(trial, random);
  if (l[1] == 0) return facts.not_applicable("characteristic determinant 0");
  if (l[0] == l[1]) return facts.not_applicable("two equal characteristic eigenvalues");
  const Rational critical = (l[0] - l[1]) / (l[0] + l[1]);
  if (critical < fraction(1, 12)) return facts.not_applicable("mu0 next to 0");
  const Rational s = critical * fraction(random.integer(40, 92), 100);
  const auto drawn = tetrahedron_around_loop(l, s, random.integer(0, 1) == 0 ? 1 : -1, random);
  if (!drawn) return facts.not_applicable("no tetrahedron found around the loop");
  const auto t = turned_to_loop(*drawn);
  if (!t) return facts.not_applicable("the loop was not proved inside");
  const auto found = cut_along_loops(*t);
  if (!found)
    return facts.not_applicable(
        "several arcs of the other loop, or cuts that the complex does not resolve");
  static const auto handle = cut_along_loops(*turned_to_loop(loop_of_handle())),
                    tube = cut_along_loops(*turned_to_loop(loop_of_tube()));
  const int lost = facts.claimed_count(2), joined = facts.claimed_count(1);
  facts.configuration_of(TetrahedronField<Rational>{t->deviators()}, {t->s});
  loop_facts(*t, *found, lost, joined, facts);
  loop_facts(loop_of_handle(), *handle, lost, joined, facts);
  loop_facts(loop_of_tube(), *tube, lost, joined, facts);
  facts.about([&] { return text(*t); });
  facts.holds("both kinds in the fixed ones", handle->has_handle() && !tube->has_handle());
  at_most_one_loop(l, s, facts);
}

Outcome loop_that_meets_no_face() {
  const LoopTetrahedron& t = loop_of_handle();
  const auto turned = turned_to_loop(t);
  const auto found = turned ? cut_along_loops(*turned) : std::nullopt;
  // What face curves and the arc between them bound is planar but for the gluing along the arc.
  if (!found || !found->has_handle() ||
      found->surface.euler + found->arcs == 2 * found->pieces - found->boundary_loops) {
    return Outcome::holds();
  }
  return Outcome::violated(text(t) + ": " + text(found->surface) +
                           "; a loop of the complex domain's boundary is inside and meets no "
                           "face, and face curves show Euler characteristic " +
                           std::to_string(found->surface.euler + 2));
}

LoopOutcome loop_outcome(const LoopTetrahedron& t) {
  LoopOutcome result;
  const auto turned = turned_to_loop(t);
  result.is_inside = turned.has_value();
  if (turned) result.cut = cut_along_loops(*turned);
  return result;
}

}  // namespace tensortopo::theory
