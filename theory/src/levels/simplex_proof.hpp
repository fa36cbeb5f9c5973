// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "levels/mode_level.hpp"

namespace tensortopo::theory {

/// What is proved about a level on one simplex of a linear field.
///
/// The simplex is that of the weights: all nonnegative combinations of its vertex tensors, up to
/// positive factors, for the mode is the same along a ray.
enum class SimplexProof : std::uint8_t {
  none,
  empty,     ///< the level does not meet it
  monotone,  ///< the mode increases strictly along a direction: the level is a graph across it
};

/// Tries both proofs: by strict signs of all Bernstein coefficients, certified by error bounds.
///
/// Why a monotone simplex has no closed piece of the level: let D be the direction in the space of
/// weights. D and -D are not weights of the simplex (at the point D the derivative along D
/// vanishes, since the mode is constant along rays). So the cone of weights maps along D to a cone
/// that lies strictly in a half-space, and rays of the level to rays, no two to one: T' = c T + k D
/// with c > 0 has the mode of T only if k = 0. The level is thus embedded in a cell of one
/// dimension less, where nothing closed of that dimension fits.
///
/// @param square  an enclosure of the level's square
template <std::size_t Vertices>
SimplexProof prove(const std::array<BoundedDeviator, Vertices>& tensors, const ModeLevel& level,
                   const Bounded<double>& square);

/// How often the level crosses an edge: 0, 1, or 2 for more or where that is not proved.
///
/// The edge is halved a few times; each part must be proved empty or monotone, and the sides of
/// its ends say whether it is crossed. A vertex on the level counts as below it.
///
/// @param above  the exact sides of the ends
int crossings(const std::array<BoundedDeviator, 2>& ends, const std::array<bool, 2>& above,
              const ModeLevel& level, const Bounded<double>& square);

}  // namespace tensortopo::theory
