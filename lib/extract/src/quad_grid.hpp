// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "tensortopo/manifold/medium_eigenvector_manifold.hpp"

namespace tensortopo {

/// The vectors of a grid in sphero-conal coordinates, with the sines and cosines of its lines
/// computed once.
class QuadGrid {
 public:
  QuadGrid(const MediumEigenvectorManifold<double>& manifold, int around)
      : axes_(manifold.characteristic().eigenvectors),
        p_(manifold.p()),
        q_(manifold.q()),
        c_(manifold.c()) {
    const auto& b = manifold.characteristic().eigenvalues;
    const double a2 = (b[0] - b[1]) / (b[0] - b[2]), b2 = (b[1] - b[2]) / (b[0] - b[2]);
    for (int k = 0; k < around; ++k) {
      const double angle = (k + 0.5) * 2 * std::numbers::pi / around;
      const double c = std::cos(angle);
      lines_.push_back({c, std::sin(angle), std::sqrt(1 - a2 * c * c), std::sqrt(1 - b2 * c * c)});
    }
  }

  Vector3<double> vector(int i, int j) const {
    const auto& t = lines_[static_cast<std::size_t>(i)];
    const auto& e = lines_[static_cast<std::size_t>(j)];
    return (t.cosine * e.across_eta) * axes_[0] + (t.sine * e.sine) * axes_[1] +
           (e.cosine * t.across_theta) * axes_[2];
  }

  /// F at a point of the grid: positive in the real domain.
  double F(int i, int j) const {
    const double st = lines_[static_cast<std::size_t>(i)].sine;
    const double se = lines_[static_cast<std::size_t>(j)].sine;
    return p_ * st * st + q_ * se * se - c_;
  }

 private:
  struct Line {
    double cosine, sine, across_theta, across_eta;
  };
  std::array<Vector3<double>, 3> axes_;
  double p_, q_, c_;
  std::vector<Line> lines_;
};

}  // namespace tensortopo
