// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace tensortopo::test {

/// Levels next to 0, and next to -1 and 1.
inline constexpr std::array<const char*, 6> kNearLevels{
    "1/1000", "-1/1000", "999/1000", "-999/1000", "999999/1000000", "-999999/1000000"};

/// Laws that the everyday tests try on few random fields and the long ones on many.

/// In tetrahedra of independent normal tensors the extraction gives the components and the edge
/// crossings that brute force sees wherever that decides, and leaves nothing unresolved.
void expect_agreement_with_brute_force(const std::string& mode, int count, std::uint64_t seed);

/// The extraction in double and at 50 digits have the same topology and the same crossings.
void expect_agreement_with_fifty_digits(const std::string& mode, int count, std::uint64_t seed);

/// Surfaces in small meshes of independent normal tensors, or of a smooth field, are flawless:
/// see `flaws`.
void expect_flawless_surfaces(const std::string& mode, int count, int cubes, bool smooth,
                              std::uint64_t seed);

}  // namespace tensortopo::test
