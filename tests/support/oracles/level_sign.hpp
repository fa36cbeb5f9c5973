// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "tensortopo/tensor/deviator.hpp"
#include "tensortopo/tensor/symmetric_tensor.hpp"

namespace tensortopo::test {

/// A deviator in the coordinates (xx - yy, yy - zz, xy, yz, xz) as plain numbers.
template <class Real>
using Five = std::array<Real, 5>;

/// A deviator whose coordinates are unevaluated sums of two doubles: the differences of the
/// diagonal entries of a tensor of doubles are exact in it.
struct ExactDeviator {
  Five<double> high{}, low{};

  ExactDeviator() = default;
  ExactDeviator(const SymmetricTensor<double>& t);  // NOLINT(google-explicit-constructor)
  ExactDeviator(const Deviator<double>& d);         // NOLINT(google-explicit-constructor)
};

/// 3 |T|^2 of a deviator.
template <class Real>
Real square_norm(const Five<Real>& t) {
  const Real c = t[0] + t[1];
  return t[0] * t[0] + t[1] * t[1] + c * c + Real(6) * (t[2] * t[2] + t[3] * t[3] + t[4] * t[4]);
}

/// 27 det T of a deviator.
template <class Real>
Real cubic_form(const Five<Real>& t) {
  const Real x = t[0] + t[0] + t[1], y = t[1] - t[0], z = -x - y;
  const Real nine(9);
  return x * y * z - nine * (x * t[3] * t[3] + y * t[4] * t[4] + z * t[2] * t[2]) +
         Real(54) * t[2] * t[3] * t[4];
}

/// A number with the sign of mode(T) - m, free of roots: mode |mode| - m |m|, times |T|^6 and a
/// positive constant.
template <class Real>
Real level_form(const Real& squared_norm, const Real& cubic, const Real& signed_square) {
  const Real square = cubic < Real(0) ? Real(-(cubic * cubic)) : Real(cubic * cubic);
  return square + square - signed_square * squared_norm * squared_norm * squared_norm;
}

/// The question "is the mode above m?" on the linear span of up to four tensors.
///
/// Always answered exactly: in long double where the value is clear of its rounding error, else
/// in rational arithmetic. On the level itself, and where the deviator vanishes, the answer is no,
/// so the level asked for is always "m plus an infinitesimal".
class LevelQuestion {
 public:
  LevelQuestion(std::span<const ExactDeviator> corners, double mode);

  /// Whether mode(sum of weights[i] * corner i) > m. Weights must not all be zero.
  bool is_above(std::span<const std::int64_t> weights) const { return sign(weights) > 0; }

  /// The sign of mode(sum of weights[i] * corner i) - m; 0 also where the deviator vanishes.
  int sign(std::span<const std::int64_t> weights) const;

  double mode() const { return mode_; }
  /// Number of corners.
  std::size_t size() const { return size_; }
  /// Corner i rounded to long double.
  const Five<long double>& corner(std::size_t i) const { return rounded_[i]; }

 private:
  int exact_sign(std::span<const std::int64_t> weights) const;

  std::size_t size_;
  std::array<ExactDeviator, 4> corners_{};
  std::array<Five<long double>, 4> rounded_{};
  std::array<long double, 4> bound_{};  ///< largest coordinate of each corner
  double mode_;
  long double signed_square_;
};

/// Number of crossings of {mode = m} on the open segment between corners i and j of the question.
///
/// Counted between the critical points of the mode along the segment, which are roots of a cubic;
/// a tangency counts as none from below and as two from above.
int exact_edge_crossings(const LevelQuestion& question, std::size_t i, std::size_t j);

}  // namespace tensortopo::test
