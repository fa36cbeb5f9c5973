// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

#include "tensortopo/field/deviator_box.hpp"
#include "tensortopo/scalar/sign.hpp"
#include "tensortopo/tensor/symmetric_tensor.hpp"

namespace tensortopo {

/// A critical point of the mode along a simplex of one to four vertices, enclosed.
struct CriticalPoint {
  /// The mode there is in [low, high], within [-1, 1].
  double low = -1, high = 1;
  /// 1 - mode^2 is in [gap_low, gap_high]: computed without cancellation, so narrow next to modes 1
  /// and -1 as well.
  double gap_low = 0, gap_high = 1;
  /// About where: barycentric weights of sum 1, the first ones used.
  std::array<double, 4> weights{};
  /// Proved: it is the only one in its enclosure, and not degenerate. If not, there may be several
  /// or none, and nothing is known but that no others are elsewhere.
  bool is_certain = false;
  /// Number of independent directions within the simplex in which the mode falls; if certain.
  int index = 0;
  /// Sign of the mode's derivative from here towards each of the vertices asked about: unknown
  /// where intervals of doubles do not tell (as if it is zero).
  std::vector<Verdict> towards;
  DeviatorBox deviator;  ///< there; if certain
};

/// A vertex itself, and where the mode goes along the edges from it.
/// @param around  tensors at the other ends
CriticalPoint critical_vertex(const SymmetricTensor<double>& tensor,
                              std::span<const SymmetricTensor<double>> around);

/// The critical points of the mode inside an edge.
///
/// None is missed: the edge is divided until signs of the cubic 2 P Q' - 3 Q P' or of its
/// derivative, in intervals of doubles, tell parts without a zero from parts with one.
/// With dependent tensors the mode is constant, and the answer empty: the value is the vertices',
/// whose derivative towards each other is not known to have a sign.
/// @param around  tensors of vertices that form a triangle with the edge
std::vector<CriticalPoint> critical_points_on_edge(
    const std::array<SymmetricTensor<double>, 2>& edge,
    std::span<const SymmetricTensor<double>> around);

/// The critical points of the mode inside a triangle, other than degenerate ones (mode 1 or -1).
///
/// None is missed: they belong to the zeros of a binary cubic, see `nondegenerate_critical_points`,
/// and those are separated as on edges. With dependent tensors the mode is constant along lines
/// that meet the edges, and the answer empty: on the edges the critical points' derivative towards
/// the third vertex is not known to have a sign.
/// @param around  tensors of vertices that form a tetrahedron with the triangle
std::vector<CriticalPoint> critical_points_on_face(
    const std::array<SymmetricTensor<double>, 3>& face,
    std::span<const SymmetricTensor<double>> around);

/// The saddle of the mode inside a tetrahedron, of which there is one at most: where the tensor is
/// the one that commutes with the characteristic tensor and is orthogonal to it. With dependent
/// tensors empty, for the reason given above.
std::vector<CriticalPoint> critical_points_in_tet(
    const std::array<SymmetricTensor<double>, 4>& tensors);

}  // namespace tensortopo
