// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "tensortopo/scalar/interval.hpp"
#include "tensortopo/scalar/rational.hpp"
#include "tensortopo/scalar/real.hpp"
#include "tensortopo/tensor/symmetric_tensor.hpp"
#include "tensortopo/theory/bounded.hpp"

namespace tensortopo::theory {

/// The numbers that a statement can be tried with. Only rational ones decide everything; the others
/// carry what they do not know, so that a sign is either certain or left open.
enum class Arithmetic : std::uint8_t { rational, interval, real100, real53 };

inline constexpr std::array kArithmetics = {Arithmetic::rational, Arithmetic::interval,
                                            Arithmetic::real100, Arithmetic::real53};

/// "rational", "interval", "real100", "double".
std::string_view name(Arithmetic arithmetic);
std::optional<Arithmetic> arithmetic_called(std::string_view name);

using Bounded53 = Bounded<double>;
using Bounded100 = Bounded<Real100>;

/// The number itself, or the narrowest that contains it in the scalar.
template <class Scalar>
Scalar enclosing(const Rational& number);

/// The sign, unknown if the scalar cannot tell.
Verdict certified_sign(const Rational& number);
using tensortopo::certified_sign;

/// A bound on how far the number may be from 0: 0 for rational ones.
double reach(const Rational& number);
double reach(const Interval& number);
double reach(const Bounded53& number);
double reach(const Bounded100& number);

}  // namespace tensortopo::theory
