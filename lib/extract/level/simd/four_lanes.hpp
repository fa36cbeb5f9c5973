// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "tensortopo/tensor/deviator.hpp"

namespace tensortopo {

inline constexpr std::size_t kLaneCount = 4;

/// Of a level, what the kernels look at.
struct LevelNumbers {
  double mu, sqrt2;
  int sign;
  double medium;  ///< the medium eigenvalue of its unit tensor
};

/// A bit for each simplex: what `prove_simplex` gives is monotone, or none and not hidden by
/// rounding. Of the others nothing is said.
struct LaneProofs {
  unsigned monotone, none;
};

/// The proofs of one to four triangles or tetrahedra, and the directions in both cases.
LaneProofs prove_four(std::span<const std::array<Deviator<double>, 3>> triangles,
                      const LevelNumbers& level,
                      std::array<std::array<double, 3>, kLaneCount>& directions);
LaneProofs prove_four(std::span<const std::array<Deviator<double>, 4>> tets,
                      const LevelNumbers& level,
                      std::array<std::array<double, 4>, kLaneCount>& directions);

/// A bit for each simplex: that `is_proved_empty` says yes, and that this is told at all.
struct LaneEmptiness {
  unsigned empty, known;
};

/// Of one to four edges, triangles or tetrahedra.
LaneEmptiness empty_four(std::span<const std::array<Deviator<double>, 2>> edges,
                         const LevelNumbers& level);
LaneEmptiness empty_four(std::span<const std::array<Deviator<double>, 3>> triangles,
                         const LevelNumbers& level);
LaneEmptiness empty_four(std::span<const std::array<Deviator<double>, 4>> tets,
                         const LevelNumbers& level);

/// `single_crossings` of one to four edges.
void cross_four(std::span<const std::array<Deviator<double>, 2>> ends, std::span<const char> rising,
                const LevelNumbers& level, std::span<double> weights);

}  // namespace tensortopo
