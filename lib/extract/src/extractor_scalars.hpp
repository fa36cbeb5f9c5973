// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tensortopo/scalar/real.hpp"

/// The scalars that the extractor is built for: production and its reference.
#define TENSORTOPO_FOR_EACH_EXTRACTOR(X) X(double) X(Real50)
