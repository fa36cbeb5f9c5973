// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The level in a tetrahedron of the mesh.
#pragma once

#include "face_level.hpp"

namespace certificate {

/// A boundary loop of a sheet. For roots that are positively oriented it runs such that from
/// outside the larger modes are seen to its left.
struct Loop {
  struct Step {
    Crossing from;
    unsigned face;  ///< through which the arc from there goes: its roots' bits
  };
  /// A point, by its weights at the roots, on the side `above` of the level.
  struct Sample {
    std::array<mpz_class, 4> weights;
    bool above = false;
  };
  std::vector<Step> steps;  ///< none if it is a closed curve in one face
  unsigned face = 0;        ///< in that case
  std::array<Sample, 2> beside;  ///< in that case: points of the face at both sides, near by
};
struct Sheet {
  long euler_characteristic = 0;
  std::vector<Loop> loops;
};

/// What is known of a tetrahedron's faces and edges.
struct TetBoundary {
  std::array<const EdgeLevel*, 6> edges{};  ///< 01, 02, 12, 03, 13, 23, as `for_subsets` goes
  std::array<const FaceLevel*, 4> faces{};  ///< by the opposite corner
};

/// Nothing if no proof closes.
std::optional<std::vector<Sheet>> level_in_tet(const Level& level,
                                               const std::array<Corner, 4>& corners,
                                               const Proved<4>& proved,
                                               const TetBoundary& boundary);

}  // namespace certificate
