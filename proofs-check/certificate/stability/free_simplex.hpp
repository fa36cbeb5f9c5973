// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Simplices in which no member has a zero, or a critical point of a mode.
#pragma once

#include <array>

#include "widened.hpp"

namespace certificate {

/// A mode, and its product with the root of six, up to their errors.
struct ModeBall {
  Ball mode, times_root_six;

  ModeBall(const mpz_class& numerator, const mpz_class& denominator);
};

/// Are all tensors of a ball on one side of the mode, none of them zero? No only if some are not.
Answer vertex_is_free(const Widened& vertex, const ModeBall& mode);

/// The same of the inside of a simplex of V = 2, 3 or 4 vertices; yes or unsure.
template <std::size_t V>
Answer simplex_is_free(const std::array<Widened, V>& corners, const ModeBall& mode);

}  // namespace certificate
