// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <iosfwd>
#include <optional>

#include "tensortopo/tensor/symmetric_tensor.hpp"

namespace tensortopo::test {

/// The degenerate points of a plane, counted.
struct DegenerateCount {
  int in_plane = 0;        ///< in the projective plane
  int linear = 0;          ///< inside the triangle, of mode 1
  int planar = 0;          ///< inside the triangle, of mode -1
  bool on_a_side = false;  ///< one more is on a side of the triangle

  friend bool operator==(const DegenerateCount&, const DegenerateCount&) = default;
};
std::ostream& operator<<(std::ostream& out, const DegenerateCount& count);

/// By elimination over the integers and Sturm sequences, sharing nothing with the extractor.
/// Nothing unless there are four simple solutions over the complex numbers.
std::optional<DegenerateCount> exact_degenerate_points(
    const std::array<SymmetricTensor<double>, 3>& corners);

}  // namespace tensortopo::test
