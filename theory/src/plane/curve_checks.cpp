// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Closed mode curves in a triangle.
#include <algorithm>

#include "plane/checks.hpp"
#include "plane/level_curves.hpp"
#include "plane/witness_planes.hpp"
#include "tensors.hpp"

namespace tensortopo::theory {
namespace {

constexpr std::size_t kMostCells = 20000;

// What a closed curve surrounds.
struct Enclosed {
  int extrema = 0, saddles = 0;
};

// For each closed curve; nothing if a critical point is in a cell that the curves may cross.
std::optional<std::vector<Enclosed>> enclosed(const Plane& plane, const LevelCurves& curves,
                                              const PointFamily& critical) {
  std::vector<Enclosed> result(curves.closed().size());
  const std::vector<CriticalKind> kinds = real_points(plane, critical);
  const auto cells = curves.cells_of(critical);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!cells[i]) continue;
    if (!curves.is_empty(*cells[i])) return std::nullopt;
    for (std::size_t k = 0; k < result.size(); ++k) {
      if (!curves.surrounds(k, *cells[i])) continue;
      ++(kinds[i].morse == Sign::positive ? result[k].extrema : result[k].saddles);
    }
  }
  return result;
}

// The nested curves of mode 9/10 around the minimum of the witness, and the extrema in each.
std::vector<Enclosed> nested_curves() {
  const Plane plane = *plane_of(three_fold_ring().face());
  const auto curves = LevelCurves::trace(plane, fraction(81, 100), kMostCells);
  if (!curves) return {};
  const auto all = enclosed(plane, *curves, critical_system(plane).critical);
  std::vector<Enclosed> result;
  for (std::size_t k = 0; all && k < all->size(); ++k) {
    if (curves->closed()[k].mode == Sign::positive) result.push_back((*all)[k]);
  }
  return result;
}

void enclosed_extremum(const Trial& trial, Facts<Rational>& facts) {
  const auto plane = plane_of(trial.field);
  if (!plane) return facts.not_applicable("dependent tensors");
  Random random = trial.random;
  const Rational s = fraction(random.integer(1, 23), 24);
  const CriticalSystem system = critical_system(*plane);
  if (system.position != Position::general) return facts.not_applicable(words(system.position));
  const Rational mode = mode_squared_from_s2(Rational(s * s));
  const auto curves = LevelCurves::trace(*plane, mode, kMostCells);
  if (!curves) return facts.undecided("curves not resolved for s = " + s.str());
  static const std::vector<Enclosed> nested = nested_curves();
  facts.about([&] { return "s = " + s.str() + " in the first face of " + text(trial.field); });
  const int one = facts.claimed_count(1), two = facts.claimed_count(2);
  const auto all = enclosed(*plane, *curves, system.critical);
  facts.holds("critical points only in cells without a curve", all.has_value());
  for (std::size_t k = 0; all && k < all->size(); ++k) {
    const Enclosed& inside = (*all)[k];
    facts.holds("an extremum inside a closed curve", inside.extrema >= one);
    facts.holds("one extremum more than saddles inside", inside.extrema - inside.saddles == one);
    facts.holds("the corners of the triangle outside", !curves->surrounds_a_corner(k));
  }
  facts.holds("two nested curves of mode 9/10 in the witness",
              static_cast<int>(nested.size()) == two);
  facts.holds("one extremum in the inner one, all four in the outer one",
              nested.size() != 2 || (std::min(nested[0].extrema, nested[1].extrema) == 1 &&
                                     std::max(nested[0].extrema, nested[1].extrema) == 4));
}

}  // namespace

Check check_enclosed_extremum() { return enclosed_extremum; }

}  // namespace tensortopo::theory
