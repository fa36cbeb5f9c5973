// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

#include "tensortopo/field/critical_points.hpp"

/// \file
/// Critical points of the mode decided in rational arithmetic: some hundred times as slow as in
/// intervals of doubles, for where those leave something open. On planes of symmetry of a real
/// field they do, as rounding moves a degenerate curve away from an edge by less than they see.
///
/// Each point is the only one in its enclosure, and certain unless it is degenerate. A derivative
/// towards a vertex whose sign is unknown is exactly zero. Points on the boundary of a simplex are
/// not inside of it: they are left out.

namespace tensortopo {

/// As `critical_vertex`.
CriticalPoint exact_critical_vertex(const SymmetricTensor<double>& tensor,
                                    std::span<const SymmetricTensor<double>> around);

/// As `critical_points_on_edge`; also empty where the mode is 1 or -1 along the edge.
std::vector<CriticalPoint> exact_critical_points_on_edge(
    const std::array<SymmetricTensor<double>, 2>& edge,
    std::span<const SymmetricTensor<double>> around);

/// As `critical_points_on_face`, and what that function gives where a curve in the face is
/// critical.
std::vector<CriticalPoint> exact_critical_points_on_face(
    const std::array<SymmetricTensor<double>, 3>& face,
    std::span<const SymmetricTensor<double>> around);

/// As `critical_points_in_tet`, and what that function gives where a line in the tetrahedron is
/// critical.
std::vector<CriticalPoint> exact_critical_points_in_tet(
    const std::array<SymmetricTensor<double>, 4>& tensors);

}  // namespace tensortopo
