// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "algebra/polynomial.hpp"

namespace proofs {

/// Distinct real roots of f in the open interval, by a Sturm sequence of its square-free part. f
/// holds no variable but `name`; throws std::domain_error if f is zero.
long count_roots(const Polynomial& f, const std::string& name, const Rational& low,
                 const Rational& high);

/// Distinct complex roots. Throws as above.
long count_complex_roots(const Polynomial& f, const std::string& name);
/// Distinct complex roots of both. Throws as above.
long count_common_roots(const Polynomial& f, const Polynomial& g, const std::string& name);

}  // namespace proofs
