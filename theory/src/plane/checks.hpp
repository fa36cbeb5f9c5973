// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tensortopo/theory/check.hpp"

namespace tensortopo::theory {

// What the statements about planes try, and the witnesses at which the paper's wording fails.

Check check_planar_extrema();
Outcome extrema_along_a_circle();

Check check_planar_pairs();
Outcome critical_points_along_a_circle();

Check check_degenerate_points();
Outcome three_degenerate_points();
Outcome one_degenerate_point();

Check check_spurious_solutions();
Outcome fewer_than_nine_solutions();

Check check_redundancy();

Check check_points_at_infinity();
Outcome saddles_at_infinity();

Check check_complement_pencil();

Check check_enclosed_extremum();

Check check_edge_roots();
Outcome root_without_change_of_sign();

}  // namespace tensortopo::theory
