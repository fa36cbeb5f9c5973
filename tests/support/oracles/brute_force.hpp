// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "level_sign.hpp"
#include "support/surfaces/topology.hpp"

namespace tensortopo::test {

using TetCorners = std::array<ExactDeviator, 4>;       ///< from tensors or from deviators
using TriangleCorners = std::array<ExactDeviator, 3>;  ///< from tensors or from deviators

/// Corners from tensors (`SymmetricTensor<double>`) or deviators (`Deviator<double>`).
template <class Tensor, std::size_t count>
std::array<ExactDeviator, count> corners_of(const std::array<Tensor, count>& tensors) {
  std::array<ExactDeviator, count> result;
  for (std::size_t i = 0; i < count; ++i) result[i] = ExactDeviator(tensors[i]);
  return result;
}

/// What marching tetrahedra sees on one uniform lattice.
struct LatticeView {
  LocalTopology topology;
  /// Largest angle (radians, between tensors) across a lattice cube in the part of the
  /// tetrahedron that may meet the surface, as a bound: features narrower than this are at risk.
  /// Zero if the Lode angle proves that there is no surface.
  double cell_angle = 0;
};

/// Topology of the level set {mode = m} as marching tetrahedra sees it on the Kuhn subdivision of
/// a tetrahedron with n intervals an edge. Combinatorial, on exact signs at the lattice points.
///
/// Cost: n = 64 about 1 ms, 96 about 2 ms, 192 about 8 ms, 384 about 40 ms on independent random
/// corner tensors: only blocks that the Lode angle does not rule out are looked at.
/// Requires |mode| < 1, 1 <= n <= 800.
LatticeView lattice_view(const TetCorners& corners, double mode, int n);

/// What marching triangles sees on one uniform lattice, and the same bound for its triangles.
struct FaceLatticeView {
  FaceTopology topology;
  double cell_angle = 0;
};

/// The same for a triangle with n intervals an edge, by marching triangles. Costs 5 ms at n = 256.
/// Requires |mode| < 1, 1 <= n <= 4096.
FaceLatticeView lattice_face_view(const TriangleCorners& corners, double mode, int n);

/// How much agreement counts as an answer.
struct BruteForceOptions {
  /// Pairs of resolutions, tried in this order until a pair is accepted.
  std::vector<std::pair<int, int>> ladder{{48, 64}, {96, 128}, {192, 256}, {288, 384}};
  /// The finer lattice must show the same topology also at the levels whose Lode angle is this
  /// many squared cell angles to either side, and at a third of that; 0 switches the test off. Caps
  /// and necks too small for the lattice lie at levels that close. (Near mode -1 or 1 also at the
  /// level where tubes are half a cell angle wide, if that is farther.)
  double band = 0.15;
  /// The finer lattice must have a cell angle (radians) below this.
  double max_cell_angle = 0.5;
  /// Crossings on the edges must agree with their exact count.
  bool check_edges = true;
  /// If some component has a handle, two pairs must be accepted, with the same answer: a sheet
  /// thinner than the lattice gets holes at random, and they look like handles.
  bool confirm_handles = true;
};

/// Why and where an answer was given or refused.
struct BruteForceTrace {
  int resolution = 0;        ///< finer resolution of the last pair tried
  int rungs = 0;             ///< pairs tried
  const char* refused = "";  ///< what failed on the last pair tried; empty if it was accepted
};

/// Topology of {mode = m} in the tetrahedron with these corner tensors, or nothing where brute
/// force does not resolve it. An agreement of lattices, not a proof.
///
/// Requires |mode| < 1. Corners are the tensors at the vertices, in the order of the vertices.
std::optional<LocalTopology> brute_force_topology(const TetCorners& corners, double mode,
                                                  const BruteForceOptions& options = {},
                                                  BruteForceTrace* trace = nullptr);

/// The same for a triangle: open arcs and closed loops. Resolutions are twice those of the ladder.
std::optional<FaceTopology> brute_force_face_topology(const TriangleCorners& corners, double mode,
                                                      const BruteForceOptions& options = {},
                                                      BruteForceTrace* trace = nullptr);

}  // namespace tensortopo::test
