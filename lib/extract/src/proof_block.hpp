// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include "lane_kernels.hpp"
#include "tensortopo/extract/edge_crossings.hpp"

namespace tensortopo {

/// Proofs of some simplices of a mesh, made together ahead of their use. In a scalar without lanes
/// there are none.
template <class Scalar, std::size_t Vertices>
class ProofBlock {
 public:
  static constexpr std::size_t size = 64;

  /// Asks for the proof of a simplex; `place` grows from call to call, and is below the size.
  template <class Index>
  void want(std::size_t place, const std::array<Index, Vertices>& vertices,
            const std::vector<Deviator<Scalar>>& tensors) {
    if constexpr (std::is_same_v<Scalar, double>) {
      for (std::size_t i = 0; i < Vertices; ++i)
        tensors_[count_][i] = tensors[static_cast<std::size_t>(vertices[i])];
      row_[place] = static_cast<unsigned char>(++count_);
    }
  }

  void make(const Level<Scalar>& level) {
    if constexpr (std::is_same_v<Scalar, double>)
      prove_simplices<Vertices>(std::span(tensors_).first(count_), level,
                                std::span(proofs_).first(count_));
  }

  /// Null if it was not asked for.
  const SimplexProof<Scalar, Vertices>* of(std::size_t place) const {
    return row_[place] == 0 ? nullptr : &proofs_[row_[place] - 1u];
  }

 private:
  static constexpr std::size_t kept = std::is_same_v<Scalar, double> ? size : 0;
  std::array<std::array<Deviator<Scalar>, Vertices>, kept> tensors_;
  std::array<SimplexProof<Scalar, Vertices>, kept> proofs_;
  std::array<unsigned char, size> row_{};  ///< one more than the proof's; 0 if there is none
  std::size_t count_ = 0;
};

/// Edges whose ends are on different sides, in the same way: their crossing, if it is the only one.
template <class Scalar>
class CrossingBlock {
 public:
  static constexpr std::size_t size = 64;

  /// @param rising  whether the second end is above
  template <class Index>
  void want(std::size_t place, const std::array<Index, 2>& edge,
            const std::vector<Deviator<Scalar>>& tensors, char rising) {
    if constexpr (std::is_same_v<Scalar, double>) {
      for (std::size_t i = 0; i < 2; ++i)
        ends_[count_][i] = tensors[static_cast<std::size_t>(edge[i])];
      rising_[count_] = rising;
      row_[place] = static_cast<unsigned char>(++count_);
    }
  }

  void make(const Level<Scalar>& level) {
    if constexpr (std::is_same_v<Scalar, double>)
      single_crossings(std::span(ends_).first(count_), std::span(rising_).first(count_), level,
                       std::span(weights_).first(count_));
  }

  /// Nothing if it was not asked for, or more is needed to tell.
  std::optional<EdgeCrossing<Scalar>> of(std::size_t place) const {
    if (row_[place] == 0) return std::nullopt;
    const std::size_t row = row_[place] - 1u;
    if (weights_[row] < Scalar(0)) return std::nullopt;
    return EdgeCrossing<Scalar>{weights_[row], rising_[row] != 0};
  }

 private:
  static constexpr std::size_t kept = std::is_same_v<Scalar, double> ? size : 0;
  std::array<std::array<Deviator<Scalar>, 2>, kept> ends_;
  std::array<Scalar, kept> weights_;
  std::array<char, kept> rising_;
  std::array<unsigned char, size> row_{};  ///< one more than the crossing's; 0 if there is none
  std::size_t count_ = 0;
};

}  // namespace tensortopo
