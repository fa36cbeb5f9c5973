// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "extract/level/exact_place.hpp"

namespace tensortopo {

/// Homogeneous barycentric coordinates that are exact: integers below 2^104, not negative, times a
/// power of two. Only their ratios mean a place.
template <std::size_t Vertices>
class ExactWeights {
 public:
  /// Vertex `corner` of the simplex, with weight one.
  static ExactWeights at_corner(std::size_t corner);

  /// The sum of the places' coordinates, each times its factor; nothing if that needs more bits.
  /// @pre as many places as factors, 4 at most; no factor is negative
  static std::optional<ExactWeights> combination(std::span<const std::int64_t> factors,
                                                 std::span<const ExactWeights> places);

  /// These times 2^e: the same place.
  ExactWeights scaled(int e) const;

  ExactPlace<Vertices> values() const;

  /// Both places being on edge (from, to) of the simplex: whether this one is nearer to `from`.
  bool comes_before(const ExactWeights& other, std::size_t from, std::size_t to) const;

 private:
  struct Digits {
    std::uint64_t high = 0, low = 0;  ///< high 2^64 + low
  };
  std::array<Digits, Vertices> digits_{};
  int exponent_ = 0;
};

extern template class ExactWeights<2>;
extern template class ExactWeights<3>;
extern template class ExactWeights<4>;

}  // namespace tensortopo
