// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tensortopo/scalar/rational.hpp"

namespace tensortopo::theory {

/// How many squares of each sign a quadratic form is the sum of.
struct Signature {
  int positive = 0, negative = 0, zero = 0;

  friend bool operator==(const Signature&, const Signature&) = default;
};

/// Of a symmetric matrix, by congruences.
Signature signature(std::vector<std::vector<Rational>> matrix);

}  // namespace tensortopo::theory
