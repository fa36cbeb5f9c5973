// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "tensortopo/mesh/tet_complex.hpp"

namespace tensortopo {

/// The edge of a tetrahedron between the two corners that are not among these bits.
inline std::size_t edge_without(unsigned corners) {
  for (std::size_t e = 0; e < kTetEdges.size(); ++e)
    if (((1u << kTetEdges[e][0] | 1u << kTetEdges[e][1]) & corners) == 0) return e;
  return 0;
}

/// The edge between these two.
inline std::size_t edge_between(unsigned corners) { return edge_without(15u & ~corners); }

}  // namespace tensortopo
