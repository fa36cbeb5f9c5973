// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

namespace tensortopo {

/// A deviator known within rounding: each of a, b, xy, yz, xz (see `Deviator`) is in [low, high],
/// after multiplication by some positive number, which does not change the mode.
struct DeviatorBox {
  /// Bounds, in that order.
  std::array<double, 5> low{}, high{};
};

}  // namespace tensortopo
