// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "extract/curves/points/enclosures.hpp"
#include "tensortopo/scalar/extended.hpp"
#include "tensortopo/scalar/rational.hpp"
#include "tensortopo/tensor/deviator.hpp"

namespace tensortopo {

/// A direction known to 150 digits: a set of vectors, none of them zero, that contains it.
using ExactDirection = Vector3<MultiprecisionInterval>;

MultiprecisionInterval interval_of(const Rational& x);
ExactDirection interval_of(const Vector3<Rational>& v);

/// The roots of the numbers of an interval that are not negative; one of them must be so.
MultiprecisionInterval sqrt_of(const MultiprecisionInterval& x);

/// The same direction, the largest coordinate being about one.
ExactDirection normalized(const ExactDirection& e);

/// The middle, rounded, of length about one.
Vector3<Extended> rounded_direction(const ExactDirection& e);

bool is_zero(const Vector3<Rational>& v);

/// A vector that a singular form maps to zero; zero if there are several.
Vector3<Rational> kernel_of(const SymmetricTensor<Rational>& form);

/// The position of the only direction of a list that can be the one given; nothing if there is
/// none, or more than one.
std::optional<std::size_t> position_in(std::span<const ExactDirection> list,
                                       const ExactDirection& e);

/// What a tensor is, exactly.
struct TensorKind {
  bool zero = false;
  bool degenerate = false;   ///< mode 1 or -1
  bool linear = false;       ///< mode 1, if degenerate
  ExactDirection direction;  ///< of the dominant eigenvector, if degenerate
};
TensorKind kind_of(const Deviator<Rational>& t);

/// The dominant eigenvector of a degenerate tensor: with T = s (e e^T - I / 3), e unit, the trace
/// of T^2 times T and that of T^3 times I make a multiple of e e^T.
ExactDirection dominant_direction(const SymmetricTensor<MultiprecisionInterval>& degenerate);

}  // namespace tensortopo
