// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tensortopo/scalar/real.hpp"

/// The scalars of the extractor: double, or 50 digits in the reference that tests compare with.
#ifdef TENSORTOPO_EXTRACT_REFERENCE
#define TENSORTOPO_FOR_EACH_EXTRACTOR(X) X(Real50)
#else
#define TENSORTOPO_FOR_EACH_EXTRACTOR(X) X(double)
#endif

/// The scalars of what both use: predicates in double turn to 50 digits.
#define TENSORTOPO_FOR_EACH_PRECISION(X) X(double) X(Real50)
