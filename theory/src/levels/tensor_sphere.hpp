// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "levels/level_complex.hpp"
#include "levels/level_surface.hpp"

namespace tensortopo::theory {

/// A basis of the tensors orthogonal to one that is not zero.
using SpanBasis = std::array<Deviator<Integer>, 4>;

/// One of small integers that is nearly orthonormal up to a common factor, in a general position.
SpanBasis span_basis(const Deviator<Rational>& normal);

/// The 3-sphere of rays in the span of a basis: the boundary of the 16-cell with the vertices +-b.
LevelComplex tensor_sphere(const SpanBasis& basis, const ModeLevel& level);

/// The same for mode 0, of which each cell comes with its opposite.
LevelComplex antipodal_sphere(const SpanBasis& basis);

/// The rays of a linear field in its tetrahedron.
LevelComplex tensor_tetrahedron(const std::array<Deviator<Rational>, 4>& vertices,
                                const ModeLevel& level);

/// Cells that a level takes at most before it counts as undecided. Levels that are not close to
/// critical take some thousands.
inline constexpr std::size_t kCellBudget = 400000;

/// The level on the sphere; nothing if it is not decided within the budget. (At a critical level it
/// never is.)
///
/// Mode mu at t is mode -mu at -t: so for mu > 0 this is a copy of the generalized mode mu surface
/// in the projective space of the span, that is in space with its points at infinity. For mu = 0 it
/// is a double cover of the neutral surface there.
std::optional<LevelSurface> sphere_surface(const SpanBasis& basis, const ModeLevel& level,
                                           std::size_t budget = kCellBudget);

/// The neutral surface in the projective space of the span.
std::optional<LevelSurface> projective_neutral_surface(const SpanBasis& basis,
                                                       std::size_t budget = kCellBudget);

std::optional<LevelSurface> tetrahedron_surface(const std::array<Deviator<Rational>, 4>& vertices,
                                                const ModeLevel& level,
                                                std::size_t budget = kCellBudget);

}  // namespace tensortopo::theory
