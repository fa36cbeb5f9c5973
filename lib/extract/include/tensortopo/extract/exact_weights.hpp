// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace tensortopo {

/// Homogeneous barycentric coordinates that are exact: integers below 2^52, not negative, times a
/// power of two. Only their ratios mean a place.
template <std::size_t Vertices>
class ExactWeights {
 public:
  /// Vertex `corner` of the simplex, with weight one.
  static ExactWeights at_corner(std::size_t corner);

  /// The coordinates a u + b v; nothing if they need more bits.
  static std::optional<ExactWeights> combination(int a, const ExactWeights& u, int b,
                                                 const ExactWeights& v);

  /// These times 2^e: the same place.
  ExactWeights scaled(int e) const;

  std::array<double, Vertices> values() const;

  /// Both places being on edge (from, to) of the simplex: whether this one is nearer to `from`.
  bool comes_before(const ExactWeights& other, std::size_t from, std::size_t to) const;

 private:
  std::array<std::int64_t, Vertices> digits_{};
  int exponent_ = 0;
};

extern template class ExactWeights<3>;
extern template class ExactWeights<4>;

}  // namespace tensortopo
