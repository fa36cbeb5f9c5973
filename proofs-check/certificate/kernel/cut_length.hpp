// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Which edge of a cell to cut: a proposal, of which nothing needs to be true.
#pragma once

#include "forms.hpp"

namespace certificate {

/// The square of the length of an edge between two unit tensors: |m - k|^2, but next to modes 1 and
/// -1 changes across the degenerate curve count more than those along it.
///
/// Let e be the dominant eigenvector of the mean. The trace-free part of the block beside e is zero
/// on the curve, and of the size rho = sqrt(1 - mode^2) on the levels around it. Its change counts
/// 1 / rho times; changes of e and along e count as they are. So a thin tube takes fewer cells,
/// which are longer along the curve. Next to the curve rho counts as rho^2 of the level at least: else
/// edges there, far inside a wide tube, would seem so long that others were never cut. Levels of
/// other invariants, whose tensors have more entries, are not tubes.
///
/// @param tube  rho^2 of the level
inline double cut_length(const Tensor<double>& m, const Tensor<double>& k, double tube) {
  static constexpr std::size_t kEntry[3][3] = {{0, 5, 4}, {5, 1, 3}, {4, 3, 2}};
  Tensor<double> mean, change;
  for (std::size_t i = 0; i < m.size(); ++i) mean[i] = m[i] + k[i], change[i] = m[i] - k[i];
  const double all = product(change, change), p = trace(mean, mean);
  const double q = Forms<double, 1>({&mean}).q.coefficients[0];
  const double rho = std::max(std::sqrt(std::max(0x1p-20, 1 - 54 * q * q / (p * p * p))), tube);
  if (!(rho < 0.5) || m[6] != 0 || m[7] != 0) return all;
  // With a multiple of the identity the mean is about a multiple of e e^T.
  for (std::size_t i = 0; i < 3; ++i) mean[i] += std::copysign(std::sqrt(p / 6), q);
  const double size = mean[0] + mean[1] + mean[2], along_e = product(change, mean) / size;
  double of_e = 0;
  for (const auto& row : kEntry)
    for (const auto& column : kEntry) {
      double image = 0;
      for (std::size_t j = 0; j < 3; ++j) image += change[row[j]] * mean[column[j]] / size;
      of_e += image * image;
    }
  const double block = all - 2 * of_e + along_e * along_e / 2;
  return all + (1 / rho - 1) * block;
}

}  // namespace certificate
