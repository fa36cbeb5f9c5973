// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "levels/level_complex.hpp"

namespace tensortopo::theory {

/// The topology of a level in a complex of simple cells.
struct LevelSurface {
  int euler = 0;  ///< points on edges - arcs in faces + discs in cells
  int components = 0;
  int closed_components = 0;  ///< those that do not meet the boundary of the complex
  int boundary_loops = 0;
  /// Whether the discs can be turned so that neighbours agree along each arc. Decided from the
  /// discs alone, without a look at which side of them is above.
  bool orientable = true;

  friend bool operator==(const LevelSurface&, const LevelSurface&) = default;
};

/// Of an antipodal complex, the level in the projective space that it covers twice. Requires that
/// `complex` was refined.
LevelSurface level_surface(const LevelComplex& complex);

/// For witnesses.
std::string text(const LevelSurface& surface);

}  // namespace tensortopo::theory
