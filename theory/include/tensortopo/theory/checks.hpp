// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tensortopo/theory/statement.hpp"

namespace tensortopo::theory {

// The checks whose truth hangs on a number of the paper take it as an argument: a test passes a
// wrong one and must see a witness. Each default is the number that the statement has.

/// `factor` det(T)^2 <= |T|^6: that is, |mode| <= 1 for the mode of the paper.
Check check_mode_range(const Rational& factor = Rational(54));

/// |T|^6 - `factor` det(T)^2 = 2 disc(T).
Check check_discriminant(const Rational& factor = Rational(54));

/// Eigenvalues (3 + s, -2 s, s - 3) have the mode s (`nine` - s^2) / (3 + s^2)^(3/2).
Check check_mode_parameter(const Rational& nine = Rational(9));

/// `factor` det(T)^2 = mu^2 |T|^6 at the tensors of mode mu and -mu, and at no others.
Check check_degree_six_equation(const Rational& factor = Rational(54));

/// 1/2 - v.T^2 v + `quarter` cos^2(theta) (v.T v)^2, T characteristic, has the sign that the
/// number of the field's tensors of mode mu or -mu with medium eigenvector v asks for.
Check check_real_domain(const Rational& quarter = Rational(Rational(1) / Rational(4)));

/// mu_0^2 + `weight` mode(T)^2 = 1, T characteristic, at the parameter s_0 at which the boundary
/// of the complex domain reaches the minor eigenvector of T.
Check check_bifurcation(const Rational& weight = Rational(1));

}  // namespace tensortopo::theory
