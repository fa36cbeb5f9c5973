// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "tensors.hpp"
#include "tensortopo/theory/facts.hpp"
#include "tensortopo/theory/trial.hpp"
#include "topology/loop_cut.hpp"

namespace tensortopo::theory {

// What the statements about topology try, and the witnesses at which the paper's wording fails.

void bifurcation_topology(const Trial& trial, Facts<Rational>& facts);
Outcome torus_in_space();

void bifurcation_surface(const Trial& trial, Facts<Rational>& facts);

void neutral_surface_topology(const Trial& trial, Facts<Rational>& facts);
Outcome singular_neutral_surface();

void neutral_surface_orientability(const Trial& trial, Facts<Rational>& facts);
Outcome orientable_neutral_surface();

void degenerate_curve_circle(const Trial& trial, Facts<Rational>& facts);
Outcome two_degenerate_conics();

void no_closed_component(const Trial& trial, Facts<Rational>& facts);
Outcome neutral_tetrahedron();

void interior_boundary_loop(const Trial& trial, Facts<Rational>& facts);
Outcome loop_that_meets_no_face();

/// What is found about one tetrahedron that is meant to hold a loop.
struct LoopOutcome {
  bool is_inside = false;      ///< proved
  std::optional<LoopCut> cut;  ///< if resolved
};
LoopOutcome loop_outcome(const LoopTetrahedron& t);

/// Names a characteristic tensor.
std::string normal_place(const Tensor& n);

inline constexpr const char* kRankBelow4 = "rank below 4";
/// Of levels too close to a critical one.
inline constexpr const char* kBudgetExceeded = "the level takes more cells than the budget has";

}  // namespace tensortopo::theory
