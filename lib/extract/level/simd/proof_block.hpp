// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include "extract/level/edge_crossing.hpp"
#include "extract/level/simd/lane_kernels.hpp"

namespace tensortopo {

namespace detail {

/// Which places of a block have a row of their own: those that asked for one, in their order.
class BlockRows {
 public:
  static constexpr std::size_t size = 64;

  /// @param place  grows from call to call, and is below the size
  std::size_t add(std::size_t place) {
    row_[place] = static_cast<unsigned char>(count_ + 1);
    return count_++;
  }

  std::size_t count() const { return count_; }
  bool has(std::size_t place) const { return row_[place] != 0; }
  std::size_t operator[](std::size_t place) const { return row_[place] - 1u; }

 private:
  std::array<unsigned char, size> row_{};  ///< one more than the row; 0 if there is none
  std::size_t count_ = 0;
};

}  // namespace detail

/// Proofs of some simplices of a mesh, made together ahead of their use. In a scalar without lanes
/// there are none.
template <class Scalar, std::size_t Vertices>
class ProofBlock {
 public:
  static constexpr std::size_t size = detail::BlockRows::size;

  /// Asks for the proof of a simplex; `place` grows from call to call, and is below the size.
  template <class Index>
  void want(std::size_t place, const std::array<Index, Vertices>& vertices,
            const std::vector<Deviator<Scalar>>& tensors) {
    if constexpr (std::is_same_v<Scalar, double>) {
      const std::size_t row = rows_.add(place);
      for (std::size_t i = 0; i < Vertices; ++i)
        tensors_[row][i] = tensors[static_cast<std::size_t>(vertices[i])];
    }
  }

  void make(const Level<Scalar>& level) {
    if constexpr (std::is_same_v<Scalar, double>)
      prove_simplices<Vertices>(std::span(tensors_).first(rows_.count()), level,
                                std::span(proofs_).first(rows_.count()));
  }

  /// Null if it was not asked for.
  const SimplexProof<Scalar, Vertices>* of(std::size_t place) const {
    return rows_.has(place) ? &proofs_[rows_[place]] : nullptr;
  }

 private:
  static constexpr std::size_t kept = std::is_same_v<Scalar, double> ? size : 0;
  std::array<std::array<Deviator<Scalar>, Vertices>, kept> tensors_;
  std::array<SimplexProof<Scalar, Vertices>, kept> proofs_;
  detail::BlockRows rows_;
};

/// Simplices that may be proved empty, in the same way; in a scalar without lanes one by one.
template <class Scalar, std::size_t Vertices>
class EmptyBlock {
 public:
  static constexpr std::size_t size = detail::BlockRows::size;

  template <class Index>
  void want(std::size_t place, const std::array<Index, Vertices>& vertices,
            const std::vector<Deviator<Scalar>>& tensors) {
    const std::size_t row = rows_.add(place);
    for (std::size_t i = 0; i < Vertices; ++i)
      tensors_[row][i] = tensors[static_cast<std::size_t>(vertices[i])];
  }

  void make(const Level<Scalar>& level) {
    if constexpr (std::is_same_v<Scalar, double>)
      prove_empty<Vertices>(std::span(tensors_).first(rows_.count()), level,
                            std::span(empty_).first(rows_.count()));
    else
      for (std::size_t row = 0; row < rows_.count(); ++row)
        empty_[row] = is_proved_empty(tensors_[row], level);
  }

  /// Whether it was asked for, and is proved empty.
  bool is_empty(std::size_t place) const { return rows_.has(place) && empty_[rows_[place]] != 0; }

 private:
  std::array<std::array<Deviator<Scalar>, Vertices>, size> tensors_;
  std::array<char, size> empty_;
  detail::BlockRows rows_;
};

/// Edges whose ends are on different sides, in the same way: their crossing, if it is the only one.
template <class Scalar>
class CrossingBlock {
 public:
  static constexpr std::size_t size = detail::BlockRows::size;

  /// @param rising  whether the second end is above
  template <class Index>
  void want(std::size_t place, const std::array<Index, 2>& edge,
            const std::vector<Deviator<Scalar>>& tensors, char rising) {
    if constexpr (std::is_same_v<Scalar, double>) {
      const std::size_t row = rows_.add(place);
      for (std::size_t i = 0; i < 2; ++i)
        ends_[row][i] = tensors[static_cast<std::size_t>(edge[i])];
      rising_[row] = rising;
    }
  }

  void make(const Level<Scalar>& level) {
    if constexpr (std::is_same_v<Scalar, double>)
      single_crossings(std::span(ends_).first(rows_.count()),
                       std::span(rising_).first(rows_.count()), level,
                       std::span(weights_).first(rows_.count()));
  }

  /// Nothing if it was not asked for, or more is needed to tell.
  std::optional<EdgeCrossing<Scalar>> of(std::size_t place) const {
    if (!rows_.has(place)) return std::nullopt;
    const std::size_t row = rows_[place];
    if (weights_[row] < Scalar(0)) return std::nullopt;
    return EdgeCrossing<Scalar>{weights_[row], rising_[row] != 0};
  }

 private:
  static constexpr std::size_t kept = std::is_same_v<Scalar, double> ? size : 0;
  std::array<std::array<Deviator<Scalar>, 2>, kept> ends_;
  std::array<Scalar, kept> weights_;
  std::array<char, kept> rising_;
  detail::BlockRows rows_;
};

/// Arcs of faces, in the same way: whether they are sampled well enough by their ends.
template <class Scalar>
class StraightBlock {
 public:
  static constexpr std::size_t size = detail::BlockRows::size;

  void want(std::size_t place, const GraphArc& arc) { arcs_[rows_.add(place)] = arc; }

  void make(const Level<Scalar>& level, const LeastCosines& least) {
    if constexpr (std::is_same_v<Scalar, double>)
      straight_arcs(std::span(arcs_).first(rows_.count()), level, least,
                    std::span(straight_).first(rows_.count()));
  }

  /// Whether it was asked for and is; if not, more may be needed to tell.
  bool is_straight(std::size_t place) const {
    return rows_.has(place) && straight_[rows_[place]] != 0;
  }

 private:
  std::array<GraphArc, size> arcs_;
  std::array<char, size> straight_{};
  detail::BlockRows rows_;
};

}  // namespace tensortopo
