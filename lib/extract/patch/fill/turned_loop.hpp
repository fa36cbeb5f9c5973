// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "extract/patch/patch.hpp"

namespace tensortopo {

/// Two vectors that span the plane across a dominant eigenvector.
struct EigenvectorFrame {
  Vector3<double> first, second;
};

/// The frame across a unit vector whose first vector is nearest to a given one.
EigenvectorFrame frame_across(const Vector3<double>& dominant, const Vector3<double>& near);
/// The same for an axis of space that is not close to the vector.
EigenvectorFrame frame_across(const Vector3<double>& dominant);

/// Vertices around a tube. Angles are twice those of the medium eigenvector in a frame across the
/// dominant one: once around the tube is 2 pi.
struct TurnedLoop {
  std::vector<std::int32_t> corners;
  std::vector<double> angles;  ///< ascending, within one turn
};

/// A boundary loop with its angles, mirrored if it runs clockwise.
/// @return nothing if its angles do not go once around, each larger than the one before
struct DirectedLoop {
  TurnedLoop loop;
  bool is_clockwise;
};
std::optional<DirectedLoop> turned_loop(std::span<const BoundaryVertex> boundary,
                                        const EigenvectorFrame& frame);

/// Triangles between two loops that run the same way, each vertex joined to those at about the same
/// angle.
void join_loops(const TurnedLoop& lower, const TurnedLoop& upper,
                std::vector<std::array<std::int32_t, 3>>& triangles);

}  // namespace tensortopo
