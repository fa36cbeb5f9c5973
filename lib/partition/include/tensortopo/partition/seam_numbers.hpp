// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tensortopo/partition/curve_seam.hpp"
#include "tensortopo/partition/surface_seam.hpp"

namespace tensortopo {

/// A seam as plain numbers, which processes can send to each other.
/// Law       `seam_of_numbers(numbers_of(s))` is s, bit for bit.
std::vector<std::int64_t> numbers_of(const SurfaceSeam& seam);

/// @throws std::invalid_argument unless the numbers are those of a seam, and each index is below
///         what it counts; memory is in proportion to the numbers
SurfaceSeam seam_of_numbers(std::span<const std::int64_t> numbers);

/// The same of a seam of curves.
/// Law       `curve_seam_of_numbers(numbers_of(s))` is s, bit for bit.
std::vector<std::int64_t> numbers_of(const CurveSeam& seam);

/// @throws std::invalid_argument as `seam_of_numbers`
CurveSeam curve_seam_of_numbers(std::span<const std::int64_t> numbers);

}  // namespace tensortopo
