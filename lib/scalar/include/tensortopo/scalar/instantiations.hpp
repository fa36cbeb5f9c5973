// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

/// \file
/// The scalar types that the library ships, as one list. A source file that defines templates ends
/// with `TENSORTOPO_FOR_EACH_…(X)`, X being a macro that instantiates them for one type; adding a
/// type here adds it everywhere. Include scalar/real.hpp, rational.hpp and interval.hpp as needed
/// in that source: this header includes nothing, so that a client of double pays for no library.

/// Ordered fields with roots (rounded).
#define TENSORTOPO_FOR_EACH_REAL(X) X(double) X(Real50) X(Real100)

/// Fields: the reals, the exact rationals and the enclosures.
#define TENSORTOPO_FOR_EACH_FIELD(X) TENSORTOPO_FOR_EACH_REAL(X) X(Rational) X(Interval)
