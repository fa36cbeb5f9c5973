// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Simplices in which all members cross the degenerate tensors in the same way.
#pragma once

#include <array>

#include "widened.hpp"

namespace certificate {

/// Is it shown that no member has, in a closed simplex of V = 2, 3 or 4 vertices, a zero, or a linear
/// degenerate point at which it is not transverse to the linear degenerate tensors? (Of two vertices: a
/// linear degenerate point.) Yes or unsure.
template <std::size_t V>
Answer simplex_is_transverse(const std::array<Widened, V>& corners);

}  // namespace certificate
