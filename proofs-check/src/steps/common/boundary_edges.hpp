// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "certificates/step.hpp"

namespace proofs {

/// A value of alpha as a fraction with a positive denominator.
struct Fraction {
  Polynomial numerator, denominator;
};

/// Crossings of the boundary with the open edge m_i = 0, on which alpha lies strictly between the
/// two other eigenvalues. A sign that coefficients do not give fails a check.
int edge_crossings(Checks& c, std::size_t i, const std::vector<Fraction>& roots);

/// The two roots in alpha on the edge m_i = 0 for s = p / q.
std::vector<Fraction> roots_on_edge(std::size_t i, const Polynomial& p, const Polynomial& q);

/// How often the boundary crosses the edges m_x = 0, m_y = 0 and m_z = 0 of the triangle of squares
/// for s0 < s < 1, and for 0 < s < s0; characteristic eigenvalues b1 > b2 > 0.
std::array<int, 3> crossings_above_bifurcation(Checks& c);
std::array<int, 3> crossings_below_bifurcation(Checks& c);

}  // namespace proofs
