// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/scalar/nearest.hpp"

#include <limits>

namespace tensortopo {

template <class Scalar>
Scalar nearest(const Rational& value) {
  Scalar result;
  mpfr_set_q(result.backend().data(), value.backend().data(), MPFR_RNDN);
  return result;
}

template <>
double nearest<double>(const Rational& value) {
  mpfr_t rounded;
  mpfr_init2(rounded, std::numeric_limits<double>::digits);
  mpfr_set_q(rounded, value.backend().data(), MPFR_RNDN);
  const double result = mpfr_get_d(rounded, MPFR_RNDN);
  mpfr_clear(rounded);
  return result;
}

template Real50 nearest<Real50>(const Rational&);
template Real100 nearest<Real100>(const Rational&);

}  // namespace tensortopo
